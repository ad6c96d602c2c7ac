/* How long kernels take to build, in processes of their own: with an empty cache, and with one that they filled. */
#define _XOPEN_SOURCE 700
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "study/bench_backends.h"

enum { MAX_PATH = 4096, OPEN_FOLDERS = 16 };

static const ts_column columns[] = {
	{"column", "column", false}, {"cache", "kernel cache", false}, TS_BENCH_STARTED_COLUMNS, {0}};

static int remove_one(const char *path, const struct stat *info, int kind, struct FTW *where)
{
	(void)info, (void)kind, (void)where;
	return remove(path);
}

/* The variable that moves the driver's cache, so that tests have an empty one and the user's is left alone; NULL: not
 * known. */
static const char *cache_variable(const ts_bench_column *column)
{
	if (column->kind == &ts_cuda_kind) return "CUDA_CACHE_PATH";
	if (strcmp(column->platform, TS_POCL) == 0) return "POCL_CACHE_DIR";
	return strncmp(column->how.backend->compiler, "Mesa ", 5) == 0 ? "MESA_SHADER_CACHE_DIR" : NULL;
}

static ts_status add_row(ts_table *t, const ts_bench_table *table, const ts_bench_column *column, const char *cache,
                         char *set)
{
	ts_bench_started started;
	ts_status status = ts_bench_start_apart(&started, table->job, column->kind->name, column->index, set);
	if (status != TS_OK) return status;
	ts_table_text(t, column->name);
	ts_table_text(t, cache);
	ts_bench_started_cells(t, &started);
	return TS_OK;
}

static ts_status add_both(ts_table *t, const ts_bench_table *table, const ts_bench_column *column, const char *variable)
{
	const char *above = getenv("TMPDIR");
	char folder[MAX_PATH], set[MAX_PATH + 64];
	snprintf(folder, sizeof folder, "%s/touchstone-XXXXXX", above != NULL && above[0] != 0 ? above : "/tmp");
	if (mkdtemp(folder) == NULL)
		return ts_fail("%s: cannot be made; set TMPDIR to a folder that can be written", folder);
	snprintf(set, sizeof set, "%s=%s", variable, folder);
	ts_status status = add_row(t, table, column, "empty", set);
	if (status == TS_OK) status = add_row(t, table, column, "filled", set);
	nftw(folder, remove_one, OPEN_FOLDERS, FTW_DEPTH | FTW_PHYS);
	return status;
}

ts_status ts_bench_print_builds(ts_bench_table *table)
{
	ts_status status = TS_OK;
	ts_table t = ts_table_begin("kernel_build", "Kernel build, in a process of its own", columns);
	t.timed = true;
	for (u32 i = table->reference + 1; status == TS_OK && i < table->n_columns; i++) {
		const ts_bench_column *column = &table->column[i];
		const char *variable = cache_variable(column);
		if (variable != NULL) {
			status = add_both(&t, table, column, variable);
		} else {
			status = add_row(&t, table, column, "the driver's own", NULL);
			ts_bench_note(table, "%s: no empty cache: it is not known how this driver's is moved", column->name);
		}
	}
	if (table->n_columns > table->reference + 1) {
		ts_report_table(table->report, &t);
	} else {
		ts_table_end(&t);
	}
	return status;
}
