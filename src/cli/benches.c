/* `bench TABLE`: measures one of the tables. */
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
	if (ts_selftest_require() != TS_OK) return TS_ERROR;
	ts_measure_keep_memory();
	return ts_tables_run(row, &cli->job);
}

ts_status ts_bench_command(ts_cli *cli)
{
	const ts_bench_row *row;
	ts_tables *tables;
	ts_status status = ts_tables_open_named(&tables, &row, cli->arguments[0]);
	if (status == TS_OK) status = run(row, cli);
	ts_tables_close(tables);
	return status;
}
