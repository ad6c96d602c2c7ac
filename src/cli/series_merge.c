/* Series that merge joins: the command runs again, with the scene's figures, the pictures and the figures that its
 * shards report in place of a scene and its renders. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "cli/reports/sharded.h"
#include "cli/series.h"
#include "model/decimal.h"
#include "model/input.h"
#include "model/json/read.h"

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
	char file[TS_SERIES_NAME + 64];
	f32 *pixels;
	u32 width, height, channels;
	size_t bytes;
	const ts_params *p = &series->job->params;
	snprintf(file, sizeof file, "%s%s.png", series->folder, name);
	char *png = ts_part_file(&bytes, part, file, TS_INPUT_ANY);
	ts_status status =
		png != NULL ? ts_image_read_bytes(&pixels, &width, &height, &channels, png, bytes, file) : TS_ERROR;
	free(png);
	if (status != TS_OK) return status;
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

/* What only the report's head and titles show of a scene. The texts belong to the report. */
static ts_status fetch_scene(ts_scene *scene, const json_t *report)
{
	const json_t *notes = json_object_get(report, "notes");
	json_int_t triangles = 0, mirrors = 0;
	bool good = json_is_string(json_object_get(report, "scene")) && json_is_array(notes) &&
	            ts_json_whole(&triangles, json_object_get(report, "triangles"), 0, UINT32_MAX);
	const json_t *told = json_object_get(report, "mirrors");
	good = good && (told == NULL || ts_json_whole(&mirrors, told, 0, UINT32_MAX));
	*scene = (ts_scene){.name = (char *)json_string_value(json_object_get(report, "scene"))};
	scene->n_triangles = (u32)triangles;
	scene->info.n_reflectors = (u32)mirrors;
	scene->notes = ts_alloc_zero(json_array_size(notes), sizeof *scene->notes, "notes");
	if (scene->notes == NULL) return TS_ERROR;
	for (; scene->n_notes < json_array_size(notes); scene->n_notes++) {
		scene->notes[scene->n_notes] = (char *)json_string_value(json_array_get(notes, scene->n_notes));
		good = good && scene->notes[scene->n_notes] != NULL;
	}
	return good ? TS_OK : TS_DIFFERENT;
}

ts_status ts_series_fetch_head(ts_series *series)
{
	const ts_part *part = &series->cli->parts->part[0];
	ts_job *job = series->job;
	json_int_t bytes = 0, threads = 0;
	const char *backend = json_string_value(json_object_get(part->report, "backend"));
	const json_t *exposure = json_object_get(json_object_get(part->report, "params"), "image.exposure");
	char text[40];
	ts_status status = fetch_scene(&series->reported, part->report);
	if (status == TS_ERROR) return TS_ERROR;
	snprintf(text, sizeof text, "%.9g", json_number_value(exposure));
	bool good = status == TS_OK && backend != NULL && ts_backend_find(&job->backend, job->backends, backend) == TS_OK &&
	            ts_json_whole(&threads, json_object_get(part->report, "threads"), 1, TS_MOST_THREADS) &&
	            ts_json_whole(&bytes, json_object_get(part->times, "estimated_bytes"), 0, INT64_MAX);
	if (good && job->exposed) good = ts_params_set(&job->params, "image.exposure", text) == TS_OK;
	job->how.threads = (u32)threads;
	series->render->scene = &series->reported;
	series->render->estimate.held = (u64)bytes;
	return good ? TS_OK : ts_part_damaged(part, "report.json lacks what render says of a scene");
}

ts_status ts_series_fetch_missing(ts_series *series)
{
	const ts_part *part = part_of(series);
	const json_t *record = record_in(series, json_object_get(part->shard, "renders"));
	const json_t *lines = json_object_get(record, "missing");
	const char *key;
	json_t *line;
	u32 absent = 0;
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		if (json_object_get(lines, ts_truths()[t]->name) != NULL) absent |= 1u << t;
	}
	if (!series->begun || absent != series->absent) {
		json_object_foreach ((json_t *)lines, key, line) {
			if (!json_is_string(line)) return ts_part_damaged(part, "a truth that is missing for no reason");
			ts_report_line(&series->report, "%s", json_string_value(line));
		}
	}
	series->absent = absent;
	return TS_OK;
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

/* Parses `render` and the words that a shard says were typed, which are untrusted: of its options those alone that a
 * shard tells. `words` has room for one more. */
static ts_status parse(ts_cli *run, const ts_parts *parts, char **words)
{
	const ts_part *part = &parts->part[0];
	const json_t *typed = json_object_get(part->shard, "typed");
	ts_command command = *ts_cli_require(parts->command);
	int n = 0;
	for (u32 i = 0; i < TS_N_OPTIONS; i++) command.options[i] = command.options[i] && ts_sharded_tells(i);
	words[n++] = (char *)parts->command;
	for (; (size_t)n <= json_array_size(typed); n++) {
		words[n] = (char *)json_string_value(json_array_get(typed, (size_t)n - 1));
	}
	if (ts_cli_parse(run, &command, n, words) != TS_OK) return ts_part_damaged(part, ts_error_message());
	u32 cases = run->job.sweep.n > 0 ? ts_sweep_count(&run->job.sweep) : ts_frames_count(&run->job.frames);
	bool series = run->job.sweep.n > 0 || run->job.frames.step > 0;
	bool good = series && !run->given[TS_OPTION_HELP] && cases == json_array_size(parts->cases);
	return good ? TS_OK : ts_part_damaged(part, "what was typed is not the series of its cases");
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
		run->job.output.report = cli->job.output.report;
		run->parts = parts;
		status = ts_render_command(run);
	}
	free(words);
	free(run);
	return status;
}
