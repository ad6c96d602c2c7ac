/* Several renders in one process, which keeps its memory: frames one after the other, or the combinations of a sweep,
 * each with pictures in a folder of its own. */
#include "cli/series.h"
#include <math.h>
#include <stdlib.h>
#include "study/results/folder.h"
#include "study/video.h"

enum { CONTACT_COLUMNS = 10 };

static u32 count_all(const ts_job *job) { return ts_sweep_count(&job->sweep) * ts_frames_count(&job->frames); }

/* "cube.px=64,lookup.bounces=2", followed by the frame. */
static void name_folder(ts_series *series)
{
	const ts_job *job = series->job;
	size_t n = 0;
	series->name[0] = 0;
	for (u32 k = 0; k < job->sweep.n; k++) {
		n += (size_t)snprintf(series->name + n, sizeof series->name - n, "%s%s=%s", k > 0 ? "," : "",
		                      job->sweep.swept[k].name, series->values[k]);
	}
	if (job->frames.step == 0) {
		snprintf(series->folder, sizeof series->folder, "%s/", series->name);
	} else {
		snprintf(series->folder, sizeof series->folder, "%s%sframe-%06u/", series->name, n > 0 ? "," : "",
		         (unsigned)TS_PARAM(&job->params, frame));
	}
	series->render->folder = series->folder;
}

/* Marks the reflective pixels that were reflective in the frame before, then keeps this frame's. */
static ts_status mark_still(ts_series *series)
{
	const ts_picture *mirrors = series->render->mirrors;
	size_t n = (size_t)TS_PARAM(&series->job->params, width) * TS_PARAM(&series->job->params, height);
	series->render->mirrors_still = NULL;
	if (mirrors == NULL || series->job->frames.step == 0) return TS_OK;
	bool known = series->mirrors_before != NULL;
	if (!known) {
		series->mirrors_before = ts_alloc(n, 1, "the reflective pixels");
		series->mirrors_still = ts_alloc(n, 1, "the reflective pixels");
	}
	if (series->mirrors_before == NULL || series->mirrors_still == NULL) return TS_ERROR;
	for (size_t i = 0; i < n; i++) {
		series->mirrors_still[i] = known && mirrors->reflective[i] != 0 && series->mirrors_before[i] != 0;
		series->mirrors_before[i] = mirrors->reflective[i];
	}
	if (known) series->render->mirrors_still = series->mirrors_still;
	return TS_OK;
}

static void lend_before(ts_series *series)
{
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) ts_render_picture(series->render, i)->before = series->before[i];
}

static ts_status keep_before(ts_series *series)
{
	const ts_params *params = &series->job->params;
	size_t bytes = (size_t)TS_PARAM(params, width) * TS_PARAM(params, height) * 3;
	for (u32 i = 0; i < TS_MAX_SHOWN && series->job->frames.step > 0; i++) {
		const ts_picture *picture = ts_render_shown(series->render, i);
		if (picture == NULL) continue;
		if (series->before[i] == NULL) series->before[i] = ts_alloc(bytes, 1, "the frame before");
		if (series->before[i] == NULL) return TS_ERROR;
		memcpy(series->before[i], picture->srgb, bytes);
	}
	return TS_OK;
}

/* A new combination has no frame before. */
static void forget_before(ts_series *series)
{
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
		free(series->before[i]);
		free(series->rows[i]);
		series->before[i] = NULL;
		series->rows[i] = NULL;
	}
	free(series->mirrors_before);
	free(series->mirrors_still);
	series->mirrors_before = series->mirrors_still = NULL;
	for (u32 i = 0; i < TS_MAX_METHODS; i++) {
		free(series->render->histories[i].n);
		series->render->histories[i] = (ts_history){.n = NULL};
	}
}

/* Whether a parameter that the scene depends on differs from the combination before. */
static bool is_other_scene(const ts_series *series, const ts_params *before)
{
	const ts_job *job = series->job;
	bool other = false;
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	for (size_t row = 0; row < n && !other; row++) {
		char was[64], is[64];
		ts_params_format(before, row, was, sizeof was);
		ts_params_format(&job->params, row, is, sizeof is);
		other = strcmp(was, is) != 0 && ts_render_scene_reads(job, table[row].name);
	}
	return other;
}

static void put_contact(ts_series *series, u32 column)
{
	const ts_params *params = &series->job->params;
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
		const ts_picture *picture = ts_render_shown(series->render, i);
		if (picture == NULL) continue;
		ts_contact_put(&series->contact, column, ts_render_place(series->render, i), picture->srgb,
		               TS_PARAM(params, width), TS_PARAM(params, height));
	}
}

static ts_status show_contact(ts_series *series)
{
	u32 all = count_all(series->job), columns = all < CONTACT_COLUMNS ? all : CONTACT_COLUMNS;
	const ts_params *params = &series->job->params;
	if (series->contact.rgb == NULL && ts_contact_begin(&series->contact, columns, ts_render_count(series->render),
	                                                    TS_PARAM(params, width), TS_PARAM(params, height)) != TS_OK)
		return TS_ERROR;
	for (u32 c = 0; c < columns; c++) {
		u32 meant = columns > 1 ? (u32)((u64)c * (all - 1) / (columns - 1)) : 0;
		if (meant == series->n_done) put_contact(series, c);
	}
	return TS_OK;
}

static void note_time(ts_series *series)
{
	ts_series_time *time = &series->times[series->n_done];
	time->combination = series->combination;
	time->frame = TS_PARAM(&series->job->params, frame);
	if (series->job->truths != 0) ts_measure_return_memory();
	if (series->fetched == NULL) time->resident_bytes = ts_memory_resident();
	for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
		const ts_picture *picture = ts_render_shown(series->render, i);
		time->milliseconds[i] = picture != NULL ? 1e3 * picture->seconds : NAN;
	}
}

/* The parameters of a sweep, by their names. */
static int put_values(json_t *object, const ts_job *job, u32 combination)
{
	char values[TS_MAX_SWEEPS][TS_SWEEP_TEXT];
	ts_params params = job->params;
	int failed = ts_sweep_set(&job->sweep, combination, &params, values) != TS_OK;
	for (u32 k = 0; k < job->sweep.n && !failed; k++) {
		failed |= json_object_set_new(object, job->sweep.swept[k].name, json_string(values[k]));
	}
	return failed;
}

/* A new reference; NULL without memory. */
static json_t *times_json(const ts_series *series)
{
	json_t *times = json_array();
	int failed = 0;
	for (u32 k = 0; k < series->n_done; k++) {
		const ts_series_time *time = &series->times[k];
		json_t *each = json_object(), *row = json_object(), *values = json_object();
		failed |= put_values(values, series->job, time->combination);
		for (u32 i = 0; i < TS_MAX_SHOWN; i++) {
			char name[24];
			if (isnan(time->milliseconds[i])) continue;
			ts_render_name(name, sizeof name, series->render, i);
			failed |= json_object_set_new(each, name, json_real(time->milliseconds[i]));
		}
		failed |= json_object_set_new(row, "combination", json_integer(time->combination));
		failed |= json_object_set_new(row, "values", values);
		failed |= json_object_set_new(row, "frame", json_integer(time->frame));
		failed |= json_object_set_new(row, "resident_bytes", json_integer((json_int_t)time->resident_bytes));
		failed |= json_object_set_new(row, "milliseconds", each);
		failed |= json_array_append_new(times, row);
	}
	if (failed == 0) return times;
	json_decref(times);
	return NULL;
}

static ts_status report_render(ts_series *series)
{
	const ts_job *job = series->job;
	ts_status status = ts_series_add(series);
	if (status == TS_OK) status = ts_series_csv(series, job->sweep.n > 0 && !job->output.json && !job->output.quiet);
	if (status == TS_OK) status = ts_series_plot_frame(series);
	note_time(series);
	if (status == TS_OK && series->n_done == 0 && series->fetched == NULL) ts_render_advise(series->render);
	if (status == TS_OK && job->shard.of > 0) status = ts_series_record(series);
	if (status != TS_OK || job->output.no_images) return status;
	if (job->shard.of == 0) status = show_contact(series);
	if (status != TS_OK) return status;
	return series->fetched == NULL ? ts_render_write(series->render) : ts_series_copy(series);
}

/* Makes the pictures with the job's current parameters. */
static ts_status make_pictures(ts_series *series)
{
	name_folder(series);
	if (series->cli->parts != NULL) return ts_series_fetch(series);
	ts_keep_give(series);
	ts_status status = ts_render_make(series->render);
	if (status == TS_OK) status = mark_still(series);
	lend_before(series);
	return status;
}

static ts_status make(ts_series *series)
{
	ts_status status = make_pictures(series);
	if (status == TS_OK && series->fetched == NULL) status = ts_render_compare(series->render);
	if (status == TS_OK) status = report_render(series);
	if (status == TS_OK) status = keep_before(series);
	series->n_done++;
	ts_progress("renders", series->n_done, series->n_all);
	return status;
}

/* Makes the frame before the shard's first one, to measure changes. */
static ts_status make_before(ts_series *series)
{
	ts_status status = make_pictures(series);
	if (status == TS_OK) status = keep_before(series);
	ts_render_clear(series->render);
	return status;
}

static ts_status make_frames(ts_series *series)
{
	ts_job *job = series->job;
	u32 n = ts_frames_count(&job->frames);
	ts_status status = TS_OK;
	for (u32 k = 0; k < n && status == TS_OK; k++) {
		bool own = ts_series_has(series, series->combination, k);
		ts_frames_set(&job->params, &job->frames, k);
		if (!own && k + 1 < n && ts_series_has(series, series->combination, k + 1)) status = make_before(series);
		if (!own) continue;
		status = make(series);
		bool last = series->n_done == series->n_all;
		if (status == TS_OK && !last && job->sweep.n > 0 && series->fetched == NULL) status = ts_keep_take(series);
		if (!last) ts_render_clear(series->render);
	}
	return status;
}

static ts_status open_scene(ts_series *series, const ts_params *before)
{
	if (series->cli->parts != NULL) return series->begun ? TS_OK : ts_series_fetch_head(series);
	if (series->begun && is_other_scene(series, before)) {
		ts_scene_free(series->render->own);
		series->render->scene = series->render->own = NULL;
	}
	return ts_render_open(series->render);
}

static ts_status report_missing(ts_series *series)
{
	if (series->cli->parts != NULL) return ts_series_fetch_missing(series);
	u32 absent = ts_render_truths_absent(series->render);
	if (!series->begun || absent != series->absent) ts_render_truths_missing(series->render, &series->report);
	series->absent = absent;
	return TS_OK;
}

static ts_status make_combination(ts_series *series)
{
	ts_job *job = series->job;
	ts_params before = job->params;
	ts_status status = ts_sweep_set(&job->sweep, series->combination, &job->params, series->values);
	ts_frames_set(&job->params, &job->frames, 0);
	bool first = !series->begun;
	if (status == TS_OK) status = open_scene(series, &before);
	if (status != TS_OK) return status;
	if (first) ts_render_report_head(series->render, &series->report);
	status = report_missing(series);
	if (status == TS_OK && first && job->sweep.n == 0) status = ts_report_print(&series->report);
	series->begun = true;
	forget_before(series);
	if (status == TS_OK) status = make_frames(series);
	return status == TS_OK ? ts_series_plot_combination(series) : status;
}

/* Writes the video of a picture in this combination, if it was made there. *why is not "" where videos cannot be
 * made. */
static ts_status write_video(ts_series *series, u32 shown, char *why, size_t why_bytes)
{
	char image[24], name[TS_SERIES_NAME + 48], pattern[TS_SERIES_NAME + 48];
	const char *comma = series->job->sweep.n > 0 ? "," : "";
	u32 first = series->combination * ts_frames_count(&series->job->frames);
	if (isnan(series->times[first].milliseconds[shown])) return TS_OK;
	ts_render_name(image, sizeof image, series->render, shown);
	snprintf(name, sizeof name, "%s%s%s.mp4", series->name, comma, image);
	snprintf(pattern, sizeof pattern, "%s%sframe-*/%s.png", series->name, comma, image);
	return ts_video_write(why, why_bytes, name, pattern);
}

static ts_status write_videos(ts_series *series)
{
	ts_job *job = series->job;
	ts_status status = TS_OK;
	char why[256] = "";
	u32 n = ts_frames_count(&job->frames) > 1 ? ts_sweep_count(&job->sweep) : 0;
	for (u32 c = 0; c < n && status == TS_OK; c++) {
		series->combination = c;
		status = ts_sweep_set(&job->sweep, c, &job->params, series->values);
		name_folder(series);
		for (u32 i = 0; i < TS_MAX_SHOWN && status == TS_OK && why[0] == 0; i++)
			status = write_video(series, i, why, sizeof why);
	}
	if (why[0] != 0) ts_say("%s", why);
	return status;
}

static ts_status write_csv(ts_series *series)
{
	const char *path = ts_folder_file(series->job->frames.step > 0 ? "sequence.csv" : "sweep.csv");
	if (path == NULL) return TS_ERROR;
	return ts_file_text_write(&series->csv, path);
}

static void row(ts_table *table, const char *name, const char *shows)
{
	ts_table_text(table, name);
	ts_table_text(table, shows);
}

/* Files of every folder, and those beside the folders. */
static void report_pictures(ts_series *series)
{
	static const ts_column columns[] = {{"name", "picture", false}, {"shows", "shows", false}, {0}};
	char rows[512];
	size_t n = 0;
	bool sequence = series->job->frames.step > 0;
	ts_table table = ts_table_begin("pictures", "Pictures, in a folder of each render", columns);
	if (series->fetched != NULL) {
		ts_series_fetch_pictures(&table, series);
		ts_report_table(&series->report, &table);
		return;
	}
	ts_render_report_pictures(series->render, &table);
	n += (size_t)snprintf(rows, sizeof rows, "renders from left to right; from above ");
	for (u32 i = 0; i < TS_MAX_SHOWN && n < sizeof rows; i++) {
		char name[24];
		if (ts_render_shown(series->render, i) == NULL) continue;
		ts_render_name(name, sizeof name, series->render, i);
		n += (size_t)snprintf(rows + n, sizeof rows - n, "%s%s", ts_render_place(series->render, i) > 0 ? ", " : "",
		                      name);
	}
	row(&table, "../contact-sheet.png", rows);
	row(&table, "../rmse-*.svg", "errors against the first truth");
	if (sequence) row(&table, "../flicker-frame.svg", "change beyond that of the truth");
	if (sequence) row(&table, "../change-frame.svg", "change since the frame before");
	if (sequence) row(&table, "../*.mp4", "the frames, " TS_VIDEO_RATE " a second, where ffmpeg is installed");
	row(&table, sequence ? "../sequence.csv" : "../sweep.csv", "figures of each render");
	ts_report_table(&series->report, &table);
}

/* Writes what belongs to all renders. */
static ts_status write_whole(ts_series *series)
{
	ts_status status = ts_contact_write(&series->contact, "contact-sheet.png");
	if (status == TS_OK) status = ts_series_plots_write(series);
	if (status == TS_OK) status = write_videos(series);
	if (status == TS_OK) status = write_csv(series);
	if (status != TS_OK) return status;
	ts_report_line(&series->report, "%s", "");
	ts_report_line(&series->report, "The files are in %s", ts_render_output(series->job));
	return ts_results_report(&series->report);
}

static ts_status finish(ts_series *series)
{
	ts_job *job = series->job;
	ts_series_report(series);
	ts_report_timed(&series->report, "renders", times_json(series));
	if (job->output.no_images) return ts_report_check(&series->report);
	if (series->n_all > 0) report_pictures(series);
	return job->shard.of > 0 ? ts_series_shard_write(series) : write_whole(series);
}

static ts_status make_all(ts_series *series)
{
	ts_status status = TS_OK;
	u32 n = ts_sweep_count(&series->job->sweep), n_frames = ts_frames_count(&series->job->frames);
	for (u32 c = 0; c < n; c++) {
		for (u32 k = 0; k < n_frames; k++) series->n_all += ts_series_has(series, c, k);
	}
	for (u32 c = 0; c < n && status == TS_OK; c++) {
		bool whole = series->job->sweep.n == 0 && series->n_all > 0; /* a shard of the frames */
		series->combination = c;
		if (whole || ts_series_has(series, c, 0)) status = make_combination(series);
	}
	if (series->n_all == 0) ts_shard_say_empty(series->job->shard, (u64)n * n_frames);
	return status == TS_OK ? finish(series) : status;
}

static void release(ts_series *series)
{
	forget_before(series);
	if (series->csv.out != NULL) ts_file_text_drop(&series->csv);
	free(series->times);
	ts_contact_free(&series->contact);
	ts_keep_free(&series->keep);
	json_decref(series->renders);
	free(series->reported.notes);
	free(series->data);
	free(series);
}

static ts_status work(ts_render *render, void *user)
{
	ts_cli *cli = user;
	ts_job *job = &cli->job;
	bool files = !job->output.no_images, quiet = job->sweep.n > 0;
	ts_series *series = ts_alloc_zero(1, sizeof *series, "a series of renders");
	if (series == NULL) return TS_ERROR;
	series->cli = cli;
	series->job = job;
	series->renders = json_array();
	series->render = render;
	series->times = ts_alloc(count_all(job), sizeof *series->times, "times of a series");
	ts_report_begin(&series->report, job->output.json || quiet);
	series->report.quiet = job->output.quiet;
	ts_status status = ts_file_text_begin(&series->csv, "the figures");
	if (status == TS_OK && files) status = ts_results_begin(ts_render_output(job), job->output.force);
	if (status == TS_OK) status = series->times != NULL ? make_all(series) : TS_ERROR;
	if (status == TS_OK && files) status = ts_folder_commit();
	if (status == TS_OK && (job->output.json || !quiet)) {
		status = ts_report_end(&series->report);
	} else {
		ts_report_discard(&series->report);
	}
	if (status != TS_OK) ts_folder_discard();
	release(series);
	return status;
}

ts_status ts_render_series(ts_cli *cli)
{
	if (ts_render_traces(&cli->job)) return ts_fail("--trace: of one frame and no sweep; name the frame by --frame");
	return ts_render_with(&cli->job, work, cli);
}
