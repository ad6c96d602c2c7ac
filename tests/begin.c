/* What every test program starts with, as the command does. */
#include "families/families.h"
#include "tools/tools.h"

__attribute__((constructor)) static void begin(void)
{
	ts_families_begin();
	ts_tools_begin();
}
