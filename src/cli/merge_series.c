/* Shards of a series: the command runs again, except for the renders, which the shards made. */
#include <stdlib.h>
#include "cli/merge.h"

/* Parses `render` and the typed words. `words` has room for one more. */
static ts_status parse(ts_cli *run, const ts_parts *parts, char **words)
{
	const json_t *typed = json_object_get(parts->part[0].shard, "typed");
	int n = 0;
	words[n++] = (char *)parts->command;
	for (; (size_t)n <= json_array_size(typed); n++) {
		words[n] = (char *)json_string_value(json_array_get(typed, (size_t)n - 1));
	}
	if (ts_cli_parse(run, ts_cli_require(parts->command), n, words) != TS_OK) return TS_ERROR;
	bool series = run->job.sweep.n > 0 || run->job.frames.step > 0;
	bool others = run->job.shard.of > 0 || run->job.output.dir != NULL || run->job.output.no_images;
	return series && !others ? TS_OK : ts_part_damaged(&parts->part[0], "what was typed is no series");
}

ts_status ts_merge_series(ts_cli *cli, const ts_parts *parts)
{
	static const u32 judging[] = {TS_OPTION_JUNIT, TS_OPTION_MARKDOWN, TS_OPTION_TAP};
	for (u32 i = 0; i < sizeof judging / sizeof *judging; i++) {
		if (!cli->given[judging[i]]) continue;
		return ts_fail("--%s: of what judges; these are shards of render: leave it out",
		               ts_option_table[judging[i]].name);
	}
	ts_cli *run = ts_alloc_zero(1, sizeof *run, "a command");
	char **words =
		ts_alloc_zero(json_array_size(json_object_get(parts->part[0].shard, "typed")) + 2, sizeof *words, "words");
	ts_status status = run != NULL && words != NULL ? parse(run, parts, words) : TS_ERROR;
	if (status == TS_OK) {
		run->job.output.dir = cli->job.output.dir;
		run->job.output.force = cli->job.output.force;
		run->job.output.json = cli->job.output.json;
		run->job.output.quiet = cli->job.output.quiet;
		run->job.how.threads = (u32)json_integer_value(json_object_get(parts->part[0].report, "threads"));
		run->parts = parts;
		status = ts_render_command(run);
	}
	free(words);
	free(run);
	return status;
}
