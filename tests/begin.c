/* What every test program starts with, as the command does. */
#include "../src/tools/tools.h"

__attribute__((constructor)) static void begin(void) { ts_tools_begin(); }
