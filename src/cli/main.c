/* The command `touchstone`. */
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include "cli/line/cli.h"
#include "families/families.h"
#include "tools/tools.h"

/* Without memory jansson drops values that it cannot hold, and reads beyond the end of texts. */
static void *allocate(size_t bytes)
{
	void *memory = malloc(bytes);
	if (memory != NULL) return memory;
	fprintf(stderr, "%s: out of memory\n", ts_program);
	_Exit(TS_ERROR);
}

int main(int argc, char **argv)
{
	json_set_alloc_funcs(allocate, free);
	ts_families_begin();
	ts_tools_begin();
	return ts_cli_main(argc, argv);
}
