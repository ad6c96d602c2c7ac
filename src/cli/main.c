/* The command `touchstone`. */
#include <jansson.h>
#include <stdlib.h>
#include "../families/families.h"
#include "../tools/tools.h"
#include "cli.h"

int main(int argc, char **argv)
{
	json_set_alloc_funcs(ts_starved_malloc, free);
	ts_families_begin();
	ts_tools_begin();
	return ts_cli_main(argc, argv);
}
