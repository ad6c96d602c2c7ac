/* `bench TABLE`: measures one of the tables. */
#include <stdio.h>
#include <string.h>
#include "cli/line/cli.h"
#include "study/tables/tables.h"

static bool says_nothing(const ts_bench_row *row, const char *option)
{
	bool one_frame = row->paper == NULL && strcmp(option, "frames") == 0;
	bool not_quiet = !row->quiet && strcmp(option, "busy") == 0;
	return one_frame || not_quiet || ts_words_have(row->without, option) ||
	       (row->takes != NULL && !ts_words_have(row->takes, option));
}

static ts_status run(const ts_bench_row *row, ts_cli *cli)
{
	for (u32 i = 0; i < TS_N_OPTIONS; i++) {
		const char *option = ts_option_table[i].name;
		if (cli->given[i] && says_nothing(row, option)) return ts_fail("bench %s: takes no --%s", row->name, option);
	}
	if (TS_PARAM(&cli->job.params, truth_rays) > 0)
		return ts_fail("bench %s: truth.rays=%u: tables judge by whole truths; leave it out", row->name,
		               (unsigned)TS_PARAM(&cli->job.params, truth_rays));
	cli->job.scene.options.camera = TS_CAMERA_CIRCLE;
	return ts_tables_run(row, &cli->job);
}

/* Opens the tables of FILE.table or FILE.table:NAME, and finds the one; if there is only one it needs no name. */
static ts_status open_file(const ts_bench_row **row, ts_tables **tables, const char *argument, size_t path_bytes)
{
	char path[4096];
	const char *name = argument[path_bytes] != 0 ? argument + path_bytes + 1 : NULL;
	if (path_bytes >= sizeof path) return ts_fail("bench: the name of the file of tables is too long");
	snprintf(path, path_bytes + 1, "%s", argument);
	if (ts_tables_open_file(tables, path) != TS_OK) return TS_ERROR;
	*row = ts_tables_at(*tables, 0);
	if (name != NULL) return ts_tables_find(row, *tables, name);
	if (*row == NULL) return ts_fail("%s: has no table", path);
	if (ts_tables_at(*tables, 1) == NULL) return TS_OK;
	return ts_fail("%s: has several tables; name one, as %s:%s", path, path, (*row)->name);
}

/* The length of the path that ends with .table, behind which nothing stands or a colon; 0: there is none. */
static size_t path_length(const char *argument)
{
	const char *end = strstr(argument, ".table");
	while (end != NULL && end[6] != 0 && end[6] != ':') end = strstr(end + 1, ".table");
	return end != NULL ? (size_t)(end + 6 - argument) : 0;
}

ts_status ts_bench_command(ts_cli *cli)
{
	const char *argument = cli->arguments[0];
	const ts_bench_row *row;
	ts_tables *tables = NULL;
	size_t path = path_length(argument);
	ts_status status = path != 0 ? open_file(&row, &tables, argument, path) : ts_tables_open(&tables);
	if (status == TS_OK && path == 0) status = ts_tables_find(&row, tables, argument);
	if (status == TS_OK) status = run(row, cli);
	ts_tables_close(tables);
	return status;
}
