/* `bench TABLE`: measures one of the tables. */
#include <string.h>
#include "cli/line/cli.h"
#include "study/bench.h"

static ts_status unknown(const char *name)
{
	ts_nearest nearest = ts_nearest_begin(name);
	for (const ts_bench_row *const *row = ts_benches(); *row != NULL; row++) ts_nearest_offer(&nearest, (*row)->name);
	return ts_fail("bench: no table \"%s\"%s", name, ts_nearest_hint(&nearest, "touchstone list benches"));
}

static bool says_nothing(const ts_bench_row *row, const char *option)
{
	bool one_frame = row->paper == NULL && strcmp(option, "frames") == 0;
	bool not_quiet = !row->quiet && strcmp(option, "busy") == 0;
	return one_frame || not_quiet || ts_words_have(row->without, option) ||
	       (row->takes != NULL && !ts_words_have(row->takes, option));
}

ts_status ts_bench_command(ts_cli *cli)
{
	const ts_bench_row *const *named = ts_benches();
	while (*named != NULL && strcmp((*named)->name, cli->arguments[0]) != 0) named++;
	if (*named == NULL) return unknown(cli->arguments[0]);
	const ts_bench_row *row = *named;
	for (u32 i = 0; i < TS_N_OPTIONS; i++) {
		const char *option = ts_option_table[i].name;
		if (cli->given[i] && says_nothing(row, option)) return ts_fail("bench %s: takes no --%s", row->name, option);
	}
	if (TS_PARAM(&cli->job.params, truth_rays) > 0)
		return ts_fail("bench %s: truth.rays=%u: tables judge by whole truths; leave it out", row->name,
		               (unsigned)TS_PARAM(&cli->job.params, truth_rays));
	cli->job.scene.options.camera = TS_CAMERA_CIRCLE;
	return ts_bench_run(row, &cli->job);
}
