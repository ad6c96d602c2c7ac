/* What every test program starts with, as the command does. */
#include "../src/families/families.h"
#include "../src/tools/tools.h"

__attribute__((constructor)) static void begin(void)
{
	ts_families_begin();
	ts_tools_begin();
}
