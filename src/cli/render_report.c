/* The report of a render: times, counters, memory, metrics and what the pictures show. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include "cli/render.h"
#include "output/json/text.h"
#include "study/sums.h"

/* Columns of a table with one figure per method. */
typedef struct {
	ts_column column[TS_MAX_COLUMNS];
	u32 n_methods;
} method_columns;

static method_columns columns_make(const ts_render *render, const char *key, const char *head)
{
	method_columns c = {.column = {{key, head, false}}};
	c.n_methods = render->n_methods < TS_MAX_COLUMNS - 2 ? render->n_methods : TS_MAX_COLUMNS - 2;
	for (u32 i = 0; i < c.n_methods; i++) {
		c.column[i + 1] = (ts_column){render->methods[i]->name, render->methods[i]->name, true};
	}
	return c;
}

static json_t *methods_json(const ts_render *render)
{
	json_t *names = json_array();
	for (u32 i = 0; i < render->n_methods; i++) json_array_append_new(names, json_string(render->methods[i]->name));
	return names;
}

static bool has_mirrors(const ts_render *render) { return ts_effect_find(render->effect)->mirrors; }

static u64 n_reflective(const ts_render *render) { return render->mirrors != NULL ? render->mirrors->n_reflective : 0; }

static bool has_shadows(const ts_render *render) { return render->pictures[0].n_samples > 0; }

/* Reports where pictures deviate from the scene's file. */
static void report_notes(const ts_scene *scene, ts_report *report)
{
	json_t *notes = json_array();
	for (u32 i = 0; i < scene->n_notes; i++) {
		ts_report_line(report, "note: %s", scene->notes[i]);
		report->failed |= json_array_append_new(notes, ts_text_json(scene->notes[i])) != 0;
	}
	ts_report_value(report, "notes", notes);
}

void ts_render_report_head(const ts_render *render, ts_report *report)
{
	const ts_params *p = &render->job->params;
	const ts_scene *scene = render->scene;
	char mirrors[32] = "";
	if (has_mirrors(render)) snprintf(mirrors, sizeof mirrors, ", %u mirrors", (unsigned)scene->info.n_reflectors);
	ts_report_line(report, "%s: %u triangles%s; %u x %u pixels, frame %u, %u threads", scene->name,
	               (unsigned)scene->n_triangles, mirrors, (unsigned)TS_PARAM(p, width), (unsigned)TS_PARAM(p, height),
	               (unsigned)TS_PARAM(p, frame), (unsigned)render->job->how.threads);
	u64 peak = render->estimate.held + render->estimate.run;
	if (render->job->exposed)
		ts_report_line(report, "exposure %g: 95 %% of frame 0 by %s are shown below 0.8",
		               (double)TS_PARAM(p, image_exposure), render->methods[0]->name);
	ts_report_line(report, "memory: about %.2f GB at the peak, of %.2f GB", (double)peak / 1e9,
	               (double)ts_memory_total() / 1e9);
	report_notes(scene, report);
	ts_report_run(report, render->job);
	ts_report_value(report, "effect", json_string(render->effect));
	ts_report_value(report, "methods", methods_json(render));
	ts_report_value(report, "scene", ts_text_json(scene->name));
	ts_report_value(report, "triangles", json_integer(scene->n_triangles));
	if (has_mirrors(render)) ts_report_value(report, "mirrors", json_integer(scene->info.n_reflectors));
	ts_report_timed(report, "estimated_bytes", json_integer((json_int_t)peak));
	ts_report_timed(report, "held_bytes", json_integer((json_int_t)render->estimate.held));
}

static void report_stage(const ts_render *render, u32 n_methods, ts_table *table, const char *stage)
{
	ts_table_text(table, stage);
	for (u32 i = 0; i < n_methods; i++) {
		const ts_timing *timing = ts_measure_timing(&render->measures[i], stage);
		if (timing != NULL) {
			ts_table_real(table, 1e3 * timing->seconds, 2);
		} else {
			ts_table_none(table);
		}
	}
}

static bool timed_before(const ts_render *render, u32 method, const char *stage)
{
	for (u32 i = 0; i < method; i++) {
		if (ts_measure_timing(&render->measures[i], stage) != NULL) return true;
	}
	return false;
}

/* Stages as the first method runs them, then those that only later ones run. */
static void report_times(const ts_render *render, ts_report *report)
{
	method_columns columns = columns_make(render, "stage", "time, ms");
	ts_table table = ts_table_begin("milliseconds", "Time", columns.column);
	table.timed = true;
	for (u32 i = 0; i < columns.n_methods; i++) {
		for (u32 k = 0; k < render->measures[i].n_timings; k++) {
			const char *stage = render->measures[i].timings[k].stage;
			if (!timed_before(render, i, stage)) report_stage(render, columns.n_methods, &table, stage);
		}
	}
	ts_table_text(&table, "all");
	for (u32 i = 0; i < columns.n_methods; i++) ts_table_real(&table, 1e3 * render->measures[i].seconds, 2);
	ts_report_table(report, &table);
}

/* Empty for a truth without counted rays. */
static void truth_cost_cells(ts_table *table, const ts_picture *truth)
{
	double rays = truth->cost.rays > 0 ? (double)truth->cost.rays : NAN;
	if (rays > 0) {
		ts_table_count(table, (i64)truth->cost.rays);
	} else {
		ts_table_none(table);
	}
	ts_table_known(table, rays > 0 ? truth->cost.seconds : NAN, 2);
	ts_table_known(table, 1e-6 * rays / truth->cost.seconds, 2);
	ts_table_known(table, rays > 0 ? truth->shading : NAN, 2);
	ts_table_known(table, 1e-6 * rays / truth->shading, 2);
}

static void report_truths(const ts_render *render, ts_report *report)
{
	static const ts_column columns[] = {{"truth", "truth", false},
	                                    {"seconds", "time, s", true},
	                                    {"rays", "rays", true},
	                                    {"casting_s", "casting, s", true},
	                                    {"mrays_a_second", "M/s", true},
	                                    {"shading_s", "shading, s", true},
	                                    {"mshaded_a_second", "M/s", true},
	                                    {0}};
	ts_table table = ts_table_begin("truth_seconds", "Time of truths", columns);
	table.timed = true;
	for (u32 t = 0; t < TS_MAX_TRUTHS; t++) {
		if (render->truths[t].srgb == NULL) continue;
		ts_table_text(&table, render->truths[t].name);
		ts_table_real(&table, render->truths[t].seconds, 2);
		truth_cost_cells(&table, &render->truths[t]);
	}
	if (table.n_cells > 0) ts_report_table(report, &table);
}

static bool counted_before(const ts_render *render, u32 method, const char *name)
{
	for (u32 i = 0; i < method; i++) {
		if (ts_measure_counter(&render->measures[i], name) != NULL) return true;
	}
	return false;
}

static void report_counters(const ts_render *render, ts_report *report)
{
	method_columns columns = columns_make(render, "counter", "counter");
	ts_table table = ts_table_begin("counters", "Work", columns.column);
	for (u32 i = 0; i < columns.n_methods; i++) {
		for (u32 k = 0; k < render->measures[i].n_counters; k++) {
			const char *name = render->measures[i].counters[k].name;
			if (counted_before(render, i, name)) continue;
			ts_table_text(&table, name);
			for (u32 j = 0; j < columns.n_methods; j++) {
				const ts_counter *counter = ts_measure_counter(&render->measures[j], name);
				if (counter != NULL) {
					ts_table_count(&table, counter->value);
				} else {
					ts_table_none(&table);
				}
			}
		}
	}
	ts_report_table(report, &table);
	if (counted_before(render, columns.n_methods, "texels a ray")) {
		ts_report_line(report,
		               "texels a ray: of this many texels one, at random, was sent a ray; a count n of them is n "
		               "+- sqrt n");
		ts_report_line(report, "%s", "");
	}
}

/* Omitted if no method has any. */
static void bytes_row(const ts_render *render, const method_columns *columns, ts_table *table, const char *name,
                      u64 (*bytes)(const ts_measure *m))
{
	u64 any = 0;
	for (u32 i = 0; i < columns->n_methods; i++) any |= bytes(&render->measures[i]);
	if (any == 0) return;
	ts_table_text(table, name);
	for (u32 i = 0; i < columns->n_methods; i++) {
		u64 n = bytes(&render->measures[i]);
		if (n > 0) {
			ts_table_bytes(table, n);
		} else {
			ts_table_none(table);
		}
	}
}

static u64 bytes_peak(const ts_measure *m) { return m->peak_bytes; }

static void report_memory(const ts_render *render, ts_report *report)
{
	method_columns columns = columns_make(render, "buffer", "buffer, largest batch");
	ts_table table = ts_table_begin("bytes", "Memory", columns.column);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		u64 any = 0;
		for (u32 i = 0; i < columns.n_methods; i++) any |= render->measures[i].bytes[id];
		if (any == 0) continue;
		ts_table_text(&table, ts_buffer_table[id].name);
		for (u32 i = 0; i < columns.n_methods; i++) {
			if (render->measures[i].bytes[id] > 0) {
				ts_table_bytes(&table, render->measures[i].bytes[id]);
			} else {
				ts_table_none(&table);
			}
		}
	}
	for (const ts_bytes_rule *const *list = ts_sums_bytes(); *list != NULL; list++) {
		for (const ts_bytes_rule *rule = *list; rule->bytes != NULL; rule++) {
			bytes_row(render, &columns, &table, rule->name, rule->bytes);
		}
	}
	bytes_row(render, &columns, &table, "peak", bytes_peak);
	ts_report_table(report, &table);
}

static void report_figures(const ts_render *render, ts_report *report)
{
	static const ts_column columns[] = {{"figure", "figure", false}, {"value", "value", true}, {0}};
	const ts_measured_frame of = {render->measures, render->n_methods, render->scene, &render->job->params,
	                              n_reflective(render)};
	for (const ts_figures_rule *const *list = ts_sums_figures(); *list != NULL; list++) {
		for (const ts_figures_rule *rule = *list; rule->put != NULL; rule++) {
			ts_table table = ts_table_begin(rule->key, rule->title, columns);
			rule->put(&table, &of);
			ts_report_table(report, &table);
		}
	}
}

static void lit_row(ts_table *table, const ts_picture *picture)
{
	if (picture->srgb == NULL || picture->n_samples == 0) return;
	ts_table_text(table, picture->name);
	ts_table_count(table, (i64)picture->n_samples);
	ts_table_count(table, (i64)picture->lit.seen);
	ts_table_count(table, (i64)picture->lit.full);
	ts_table_count(table, (i64)picture->lit.part);
	ts_table_count(table, (i64)picture->lit.none);
}

static void report_shadows(const ts_render *render, ts_report *report)
{
	static const ts_column columns[] = {{"image", "image", false},
	                                    {"samples", "light samples", true},
	                                    {"pixels", "pixels in sight", true},
	                                    {"full", "fully lit", true},
	                                    {"part", "in penumbra", true},
	                                    {"none", "in shadow", true},
	                                    {0}};
	ts_table table = ts_table_begin("shadows", "Shadows", columns);
	for (u32 i = 0; i < render->n_methods; i++) lit_row(&table, &render->pictures[i]);
	for (u32 t = 0; t < TS_MAX_TRUTHS; t++) lit_row(&table, &render->truths[t]);
	ts_report_line(report, "lights: %" PRIu64 "; a depth map has %u x %u texels", render->pictures[0].n_lamps,
	               (unsigned)TS_PARAM(&render->job->params, depth_map_px),
	               (unsigned)TS_PARAM(&render->job->params, depth_map_px));
	ts_report_line(report, "%s", "");
	ts_report_value(report, "lights", json_integer((json_int_t)render->pictures[0].n_lamps));
	ts_report_table(report, &table);
}

/* Next to a reference without light an error is no number; a partial truth has no SSIM. */
static void error_cell(ts_table *table, double error, int decimals)
{
	if (isfinite(error)) {
		ts_table_real(table, error, decimals);
	} else {
		ts_table_none(table);
	}
}

/* With the standard error of the RMSE, if some are estimates. */
static void metric_cells(ts_table *table, const ts_metrics *m, bool estimates)
{
	if (m->pixels == 0) {
		for (u32 i = 0; i < (estimates ? 4 : 3); i++) ts_table_none(table);
		return;
	}
	ts_table_real(table, m->rmse, 3);
	if (estimates) error_cell(table, m->rmse_error, 3);
	ts_table_real(table, m->psnr, 2);
	error_cell(table, m->ssim, 5);
}

static void report_missed(const ts_render *render, ts_report *report)
{
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		const ts_picture *truth = &render->truths[t];
		if (truth->n_hits == 0) continue;
		double percent = 100.0 * (double)truth->n_missed / (double)truth->n_hits;
		ts_report_line(report,
		               "empty look-ups of EPR where a ray of truth %s through the texel's centre hits: %" PRIu64
		               " of %" PRIu64 ", %.5f %%%s",
		               ts_truths()[t]->name, truth->n_missed, truth->n_hits, percent,
		               truth->chosen != NULL ? ", at the chosen pixels" : "");
		ts_report_line(report, "%s", "");
		ts_report_value(report, "hit_lookups", json_integer((json_int_t)truth->n_hits));
		ts_report_value(report, "missed_lookups", json_integer((json_int_t)truth->n_missed));
	}
}

/* Reports which part of a truth was traced. */
static void report_parts(const ts_render *render, ts_report *report)
{
	static const ts_column columns[] = {{"truth", "truth", false},
	                                    {"samples", "samples a pixel", true},
	                                    {"of", "of", true},
	                                    {"pixels", "pixels with all", true},
	                                    {0}};
	ts_table table = ts_table_begin("truth_parts",
	                                "Truths in part: pictures by some samples a pixel, figures by pixels with all of "
	                                "them; +- is one standard error. With truth.rays=0 truths are whole",
	                                columns);
	size_t n = (size_t)TS_PARAM(&render->job->params, width) * TS_PARAM(&render->job->params, height);
	for (u32 t = 0; t < TS_MAX_TRUTHS; t++) {
		const ts_picture *truth = &render->truths[t];
		i64 pixels = 0;
		if (truth->chosen == NULL) continue;
		for (size_t i = 0; i < n; i++) pixels += truth->chosen[i] && (truth->seen == NULL || truth->seen[i]);
		ts_table_text(&table, truth->name);
		ts_table_count(&table, (i64)truth->sampling.some);
		ts_table_count(&table, (i64)truth->sampling.items);
		ts_table_count(&table, pixels);
	}
	if (table.n_cells > 0) ts_report_table(report, &table);
}

/* Columns of the metrics: over the image, and over its reflective pixels or in radiance. */
static void metric_columns(ts_column *column, bool mask, bool estimates)
{
	u32 n = 0;
#define COLUMN(...) column[n++] = (ts_column){__VA_ARGS__, true}
	column[n++] = (ts_column){"image", "image", false};
	column[n++] = (ts_column){"reference", "against", false};
	COLUMN("rmse", "RMSE");
	if (estimates) COLUMN("rmse_error", "+-");
	COLUMN("psnr", "PSNR, dB");
	COLUMN("ssim", "SSIM");
	if (mask) {
		COLUMN("reflective_rmse", "refl. RMSE");
		if (estimates) COLUMN("reflective_rmse_error", "+-");
		COLUMN("reflective_psnr", "PSNR, dB");
		COLUMN("reflective_ssim", "SSIM");
	} else {
		COLUMN("relative_rmse", "relative RMSE");
	}
#undef COLUMN
	column[n++] = (ts_column){"share", "error of the", false};
	column[n] = (ts_column){0};
}

static void report_metrics(const ts_render *render, ts_report *report)
{
	bool mask = render->mirrors != NULL, estimates = false;
	ts_column columns[TS_MAX_COLUMNS];
	if (render->n_pairs == 0) return;
	report_missed(render, report);
	report_parts(render, report);
	for (u32 i = 0; i < render->n_pairs; i++) estimates |= render->pairs[i].chosen != NULL;
	metric_columns(columns, mask, estimates);
	const char *title = mask ? "Metrics, in grey levels, over the image and over its reflective pixels"
	                         : "Metrics, in grey levels; relative RMSE in radiance, by the mean, without the sky";
	ts_table table = ts_table_begin("metrics", title, columns);
	for (u32 i = 0; i < render->n_pairs; i++) {
		const ts_pair *pair = &render->pairs[i];
		ts_table_text(&table, pair->image->name);
		ts_table_text(&table, pair->reference->name);
		metric_cells(&table, &pair->all, estimates);
		if (mask) {
			metric_cells(&table, &pair->reflective, estimates);
		} else {
			error_cell(&table, pair->light.relative, 5);
		}
		ts_table_text(&table, pair->share);
	}
	ts_report_table(report, &table);
}

/* Relative RMSEs are divided by the mean of the reference over the same pixels. */
static void report_light(const ts_render *render, ts_report *report)
{
	static const ts_column columns[] = {{"image", "image", false},
	                                    {"reference", "against", false},
	                                    {"relative_rmse_near", "RMSE, near", true},
	                                    {"relative_rmse_elsewhere", "elsewhere", true},
	                                    {"near_percent", "near, % of pixels", true},
	                                    {"near_error_percent", "of squared error", true},
	                                    {"median_error", "median error", true},
	                                    {"beyond_percent", "above 10 %, %", true},
	                                    {0}};
	ts_table table = ts_table_begin(
		"light_errors", "Relative errors in radiance; near: within a side of the middle of a triangle of light",
		columns);
	for (u32 i = 0; i < render->n_pairs; i++) {
		const ts_pair *pair = &render->pairs[i];
		if (!pair->parted || pair->light.pixels == 0) continue;
		ts_table_text(&table, pair->image->name);
		ts_table_text(&table, pair->reference->name);
		error_cell(&table, pair->near.relative, 5);
		error_cell(&table, pair->elsewhere.relative, 5);
		ts_table_real(&table, 100 * (double)pair->near.pixels / (double)pair->light.pixels, 2);
		error_cell(&table, 100 * pair->near.squares / pair->light.squares, 2);
		error_cell(&table, pair->light.median, 5);
		ts_table_real(&table, 100 * pair->light.beyond, 2);
	}
	if (table.n_cells > 0) ts_report_table(report, &table);
}

static void picture_row(ts_table *table, const char *name, const char *what)
{
	ts_table_text(table, name);
	ts_table_text(table, what);
}

void ts_render_report_pictures(const ts_render *render, ts_table *table)
{
	char name[64], what[64];
	for (u32 i = 0; i < render->n_methods; i++) {
		snprintf(name, sizeof name, "%s.png .exr", render->methods[i]->name);
		picture_row(table, name, render->methods[i]->doc);
		for (u32 k = 0; k < render->stages[i].n; k++) {
			snprintf(name, sizeof name, "%s-%s.png", render->methods[i]->name, render->stages[i].picture[k].name);
			picture_row(table, name, render->stages[i].picture[k].caption);
		}
	}
	for (u32 t = 0; t < TS_MAX_TRUTHS; t++) {
		if (render->truths[t].srgb != NULL) {
			snprintf(name, sizeof name, "%s.png .exr", render->truths[t].name);
			picture_row(table, name, ts_truths()[t]->doc);
		}
	}
	if (render->n_pairs > 0) {
		snprintf(what, sizeof what, "grey levels apart, times %d (.exr: signed radiance)",
		         ts_render_difference_scale(render));
		picture_row(table, "difference-*.png .exr", what);
	}
}

static void report_pictures(const ts_render *render, ts_report *report)
{
	static const ts_column columns[] = {{"name", "picture", false}, {"shows", "shows", false}, {0}};
	ts_table table = ts_table_begin("pictures", "Pictures", columns);
	ts_render_report_pictures(render, &table);
	ts_report_table(report, &table);
}

void ts_render_report_body(const ts_render *render, ts_report *report)
{
	report_times(render, report);
	report_truths(render, report);
	report_counters(render, report);
	report_memory(render, report);
	if (has_mirrors(render)) {
		report_figures(render, report);
	} else if (has_shadows(render)) {
		report_shadows(render, report);
	}
	report_metrics(render, report);
	report_light(render, report);
	if (!render->job->output.no_images) report_pictures(render, report);
}
