/* Series in shards: a shard's record of each render, how merge uses it, and the series that merge runs again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "cli/reports/sharded.h"
#include "cli/series.h"
#include "model/decimal.h"
#include "study/results/folder.h"

bool ts_series_has(const ts_series *series, u32 combination, u32 k)
{
	const ts_job *job = series->job;
	if (job->sweep.n > 0) return ts_shard_has(job->shard, combination);
	return ts_shard_has_block(job->shard, k, ts_frames_count(&job->frames));
}

/* [["points", 0, "0x1.8p+3"], ...] */
static json_t *figures_json(const ts_series_figure_list *figures)
{
	json_t *list = json_array();
	int failed = list == NULL;
	for (u32 i = 0; i < figures->n; i++) {
		char value[40];
		snprintf(value, sizeof value, "%a", figures->figure[i].value);
		json_t *row = json_pack("[s, i, s]", figures->figure[i].name, figures->figure[i].decimals, value);
		failed |= json_array_append_new(list, row) != 0;
	}
	if (failed == 0) return list;
	json_decref(list);
	return NULL;
}

ts_status ts_series_record(ts_series *series)
{
	json_t *images = json_object();
	json_t *row = json_pack("{s:i, s:i, s:o}", "combination", (int)series->combination, "frame",
	                        (int)TS_PARAM(&series->job->params, frame), "images", images);
	int failed = row == NULL;
	for (u32 i = 0; i < TS_MAX_SHOWN && failed == 0; i++) {
		char name[24];
		if (ts_render_shown(series->render, i) == NULL) continue;
		ts_render_name(name, sizeof name, series->render, i);
		failed = json_object_set_new(images, name, figures_json(&series->rows[i]->figures));
	}
	failed |= json_array_append_new(series->renders, row);
	return failed == 0 ? TS_OK : ts_fail("the figures of a shard: out of memory");
}

/* Combinations, or frames. */
static json_t *cases_json(const ts_series *series)
{
	const ts_job *job = series->job;
	u32 n = job->sweep.n > 0 ? ts_sweep_count(&job->sweep) : ts_frames_count(&job->frames);
	json_t *cases = json_array();
	int failed = cases == NULL;
	for (u32 i = 0; i < n; i++) {
		failed |= json_array_append_new(cases, json_sprintf(job->sweep.n > 0 ? "combination %u" : "frame %u", i)) != 0;
	}
	if (failed == 0) return cases;
	json_decref(cases);
	ts_fail("the names of cases: out of memory");
	return NULL;
}

ts_status ts_series_shard_write(ts_series *series)
{
	const ts_sharded sharded = {"render", "touchstone.render", cases_json(series), TS_OK, series->renders};
	if (sharded.cases == NULL) return TS_ERROR;
	ts_report_value(&series->report, "program", json_string(series->job->program));
	ts_status status = ts_sharded_write(&series->report, series->cli, &sharded);
	json_decref(sharded.cases);
	return status;
}

/* The shard that has this render. */
static const ts_part *part_of(const ts_series *series)
{
	const ts_parts *parts = series->cli->parts;
	u32 k = series->n_done % ts_frames_count(&series->job->frames);
	for (u32 i = 0; i < parts->n; i++) {
		ts_series as = {.job = &(ts_job){.sweep = series->job->sweep, .frames = series->job->frames}};
		as.job->shard = (ts_shard){parts->part[i].index, parts->part[i].of};
		if (ts_series_has(&as, series->combination, k)) return &parts->part[i];
	}
	return &parts->part[0];
}

/* The record of this render in an array of them; NULL: there is none. */
static json_t *record_in(const ts_series *series, const json_t *records)
{
	size_t i;
	json_t *row;
	json_int_t frame = TS_PARAM(&series->job->params, frame);
	json_array_foreach (records, i, row) {
		bool same = json_integer_value(json_object_get(row, "combination")) == series->combination;
		if (same && json_integer_value(json_object_get(row, "frame")) == frame) return row;
	}
	return NULL;
}

static ts_status fetch_picture(ts_picture *picture, const ts_series *series, const ts_part *part, const char *name)
{
	char path[4096];
	f32 *pixels;
	u32 width, height, channels;
	const ts_params *p = &series->job->params;
	snprintf(path, sizeof path, "%s/%s%s.png", part->dir, series->folder, name);
	if (ts_image_read(&pixels, &width, &height, &channels, path) != TS_OK) return TS_ERROR;
	bool fits = width == TS_PARAM(p, width) && height == TS_PARAM(p, height) && channels == 3;
	size_t n = (size_t)width * height * channels;
	u8 *srgb = fits ? ts_alloc(n, 1, "a picture") : NULL;
	for (size_t i = 0; srgb != NULL && i < n; i++) srgb[i] = (u8)lrintf(pixels[i] * 255.0f);
	free(pixels);
	picture->srgb = srgb;
	snprintf(picture->name, sizeof picture->name, "%s", name);
	if (!fits) return ts_part_damaged(part, "a picture of another size");
	return srgb != NULL ? TS_OK : TS_ERROR;
}

ts_status ts_series_fetch(ts_series *series)
{
	const ts_part *part = series->from = part_of(series);
	const json_t *time = record_in(series, json_object_get(part->times, "renders"));
	series->fetched = record_in(series, json_object_get(part->shard, "renders"));
	if (series->fetched == NULL || time == NULL) return ts_part_damaged(part, "a render that it should have");
	ts_series_time *own = &series->times[series->n_done];
	own->resident_bytes = (u64)json_integer_value(json_object_get(time, "resident_bytes"));
	ts_status status = TS_OK;
	for (u32 i = 0; i < TS_MAX_SHOWN && status == TS_OK; i++) {
		char name[24];
		bool asked =
			i < TS_MAX_METHODS ? i < series->render->n_methods : (series->job->truths >> (i - TS_MAX_METHODS) & 1) != 0;
		if (!asked) continue;
		ts_render_name(name, sizeof name, series->render, i);
		if (json_object_get(json_object_get(series->fetched, "images"), name) == NULL) continue;
		ts_picture *picture = ts_render_picture(series->render, i);
		picture->seconds = 1e-3 * json_number_value(json_object_get(json_object_get(time, "milliseconds"), name));
		status = fetch_picture(picture, series, part, name);
	}
	return status;
}

ts_status ts_series_fetch_figures(ts_series_figure_list *figures, const ts_series *series, u32 shown)
{
	char name[24];
	ts_render_name(name, sizeof name, series->render, shown);
	const json_t *list = json_object_get(json_object_get(series->fetched, "images"), name);
	bool good = json_is_array(list) && json_array_size(list) <= TS_MAX_FIGURES;
	figures->n = good ? (u32)json_array_size(list) : 0;
	for (u32 i = 0; i < figures->n && good; i++) {
		ts_series_figure *figure = &figures->figure[i];
		const json_t *row = json_array_get(list, i);
		const char *text = json_string_value(json_array_get(row, 0)),
				   *value = json_string_value(json_array_get(row, 2));
		json_int_t decimals = json_integer_value(json_array_get(row, 1));
		char *end = NULL;
		good = text != NULL && value != NULL && decimals >= 0 && decimals <= 20;
		if (!good) break;
		figure->value = ts_strtod(value, &end);
		figure->decimals = (int)decimals;
		good = *end == 0 && end > value && strlen(text) < sizeof figure->name;
		snprintf(figure->name, sizeof figure->name, "%s", text);
	}
	return good ? TS_OK : ts_part_damaged(series->from, "figures of a render");
}

void ts_series_fetch_pictures(ts_table *table, const ts_series *series)
{
	size_t i;
	json_t *row;
	json_array_foreach (json_object_get(series->from->report, "pictures"), i, row) {
		const char *name = json_string_value(json_object_get(row, "name"));
		const char *shows = json_string_value(json_object_get(row, "shows"));
		ts_table_text(table, name != NULL ? name : "");
		ts_table_text(table, shows != NULL ? shows : "");
	}
}

ts_status ts_series_copy(ts_series *series)
{
	size_t i, n = strlen(series->folder);
	json_t *file;
	ts_status status = TS_OK;
	json_array_foreach (json_object_get(series->from->report, "files"), i, file) {
		const char *name = json_string_value(file);
		if (name == NULL || strncmp(name, series->folder, n) != 0 || status != TS_OK) continue;
		status = ts_part_copy(series->from, name);
	}
	return status;
}

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
