/* Running a method and keeping what is worth telling. */
#include <stdio.h>
#include <stdlib.h>
#include "../kernels/srgb.h"
#include "../truth/truth.h"
#include "cli.h"
#include "measure.h"
#include "viewer.h"

enum { TRUTH_C_FACTOR = 4 };

static void measure_faces(ts_measure *m, const ts_frame *frame)
{
	const ts_face *faces = ts_frame_data(frame, TS_B_resize_face);
	u64 n = ts_frame_n(frame, TS_B_resize_face), sum = 0;
	m->n_in_sight = 0;
	for (u64 r = 0; r < n; r++) {
		sum += faces[r].n;
		m->n_in_sight += faces[r].n > 0;
	}
	m->mean_diameter = m->n_in_sight > 0 ? (double)sum / m->n_in_sight : 0;
}

/* Pipelines that work in batches show their own progress. */
static void show_progress(const ts_run *run, const ts_stage *stage, const char *method)
{
	char label[64];
	u64 done = (u64)(stage - ts_stage_table) + 1, total = done;
	while (ts_stage_table[total - 1].name != NULL) total++;
	if (run->n_units == run->all_units) {
		snprintf(label, sizeof label, "%s, after %s", method, stage->name);
		ts_progress(label, done, total);
	}
}

static ts_status after_stage(const ts_run *run, const ts_stage *stage, void *user)
{
	ts_measure *m = user;
	show_progress(run, stage, m->method->name);
	for (size_t i = 0; i < sizeof stage->writes / sizeof stage->writes[0] && stage->writes[i] < TS_N_BUFFERS; i++) {
		ts_buffer_id id = stage->writes[i];
		if (!run->frame.buffer[id].made) continue;
		u64 n = ts_frame_n(&run->frame, id), bytes = n * ts_buffer_table[id].element_bytes;
		m->elements[id] += n;
		m->bytes[id] = bytes > m->bytes[id] ? bytes : m->bytes[id];
		if (id == TS_B_resize_face) {
			m->elements[id] = n;
			measure_faces(m, &run->frame);
		}
	}
	ts_status status = m->pictures != NULL ? ts_stage_pictures_take(m->pictures, run, stage) : TS_OK;
	if (status == TS_OK && m->viewer != NULL) status = ts_viewer_take(run, stage, m->viewer);
	return status == TS_OK && m->writer != NULL ? ts_trace_write_stage(m->writer, run, stage) : status;
}

static void keep(ts_measure *m, const ts_run *run)
{
	m->n_counters = run->n_counters;
	m->n_timings = run->n_timings;
	memcpy(m->counters, run->counters, sizeof m->counters);
	memcpy(m->timings, run->timings, sizeof m->timings);
	m->peak_bytes = run->frame.peak_bytes;
}

/* What truths A and B, and the mask of reflective pixels, are made of after the run. */
static void keep_for_truths(ts_run *run)
{
	static const ts_buffer_id ids[] = { TS_B_eye_view, TS_B_pose_vertex, TS_B_resize_face, TS_B_eye_depth_triangle,
		TS_B_pixel_offset, TS_B_pixel_record, TS_B_lookup_point, TS_B_shade_radiance };
	run->lean = true;
	for (u32 i = 0; i < sizeof ids / sizeof ids[0]; i++) run->keep[ids[i]] = true;
}

ts_status ts_measure_run(ts_measure *measure, const ts_pipeline *method, const ts_scene *scene, const ts_params *params,
                         const ts_how *how, ts_measure_after after, void *user)
{
	*measure = (ts_measure){ .method = method, .pictures = measure->pictures, .trace = measure->trace,
	                         .viewer = measure->viewer };
	ts_run run;
	ts_run_begin(&run, scene, params, how->threads);
	ts_run_how(&run, how);
	keep_for_truths(&run);
	run.hook = after_stage;
	run.hook_user = measure;
	run.traced = measure->trace != NULL;
	run.margins = run.traced && measure->trace->margins;
	ts_status status = TS_OK;
	if (run.traced) status = ts_trace_write_begin(&measure->writer, method, &run, measure->trace);
	if (status == TS_OK) status = ts_pipeline_run(method, &run);
	if (status == TS_OK && run.traced) status = ts_trace_write_end(measure->writer, &run);
	ts_trace_write_free(measure->writer);
	measure->writer = NULL;
	keep(measure, &run);
	for (u32 i = 0; i < measure->n_timings; i++) measure->seconds += measure->timings[i].seconds;
	run.hook = NULL;
	if (status == TS_OK && after != NULL) status = after(&run, user);
	ts_progress(method->name, 1, 1);
	ts_run_end(&run);
	return status;
}

const ts_counter *ts_measure_counter(const ts_measure *measure, const char *name)
{
	for (u32 i = 0; i < measure->n_counters; i++) {
		if (strcmp(measure->counters[i].name, name) == 0) return &measure->counters[i];
	}
	return NULL;
}

i64 ts_measure_shading(const ts_measure *measure)
{
	const ts_counter *counter = ts_measure_counter(measure, "shading operations");
	return counter != NULL ? counter->value : 0;
}

const ts_timing *ts_measure_timing(const ts_measure *measure, const char *stage)
{
	for (u32 i = 0; i < measure->n_timings; i++) {
		if (strcmp(measure->timings[i].stage, stage) == 0) return &measure->timings[i];
	}
	return NULL;
}

ts_status ts_picture_take(ts_picture *picture, const char *name, const ts_run *run)
{
	size_t n = (size_t)run->params.width * run->params.height * 3;
	snprintf(picture->name, sizeof picture->name, "%s", name);
	picture->radiance = ts_alloc(n, sizeof(f32), "a picture");
	picture->srgb = ts_alloc(n, 1, "a picture");
	if (picture->radiance == NULL || picture->srgb == NULL) return TS_ERROR;
	memcpy(picture->radiance, ts_frame_data(&run->frame, TS_B_image_radiance), n * sizeof(f32));
	memcpy(picture->srgb, ts_frame_data(&run->frame, TS_B_image_srgb), n);
	return TS_OK;
}

ts_status ts_picture_make(ts_picture *picture, const char *name, f32 *radiance, const ts_params *params)
{
	size_t n = (size_t)params->width * params->height * 3;
	snprintf(picture->name, sizeof picture->name, "%s", name);
	picture->radiance = radiance;
	picture->srgb = ts_alloc(n, 1, "a picture");
	for (size_t i = 0; i < n && picture->srgb != NULL; i++) {
		picture->srgb[i] = (u8)ts_srgb_byte(params->exposure * radiance[i]);
	}
	return picture->srgb != NULL ? TS_OK : TS_ERROR;
}

void ts_picture_free(ts_picture *picture)
{
	free(picture->radiance);
	free(picture->srgb);
	picture->radiance = NULL;
	picture->srgb = NULL;
}

static ts_status count_missed(ts_picture *picture, ts_truth *tree, const ts_run *run)
{
	u32 *hits;
	const u32 *found = ts_frame_data(&run->frame, TS_B_lookup_point);
	if (ts_truth_hits(tree, run, &hits) != TS_OK) return TS_ERROR;
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_lookup_point); i++) {
		picture->n_hits += hits[i] != TS_NONE;
		picture->n_missed += hits[i] != TS_NONE && found[i] == TS_NONE;
	}
	free(hits);
	return TS_OK;
}

ts_status ts_picture_truth(ts_picture *picture, u32 truth, ts_run *run)
{
	double begin = ts_seconds();
	ts_truth *tree;
	ts_status status = ts_truth_new(&tree, run);
	if (status != TS_OK) return status;
	status = truth == TS_TRUTH_A ? ts_truth_a(tree, run) : ts_truth_b(tree, run);
	if (status == TS_OK && truth == TS_TRUTH_A) status = count_missed(picture, tree, run);
	if (status == TS_OK) status = ts_run_stage(run, ts_stage_find("image"));
	if (status == TS_OK) status = ts_frame_fetch(&run->frame);
	if (status == TS_OK) status = ts_picture_take(picture, truth == TS_TRUTH_A ? "truth-a" : "truth-b", run);
	ts_truth_free(tree);
	picture->seconds = ts_seconds() - begin;
	return status;
}

ts_status ts_picture_truth_c(ts_picture *picture, const ts_scene *scene, const ts_params *params, u32 threads)
{
	double begin = ts_seconds();
	f32 *radiance;
	ts_status status = ts_truth_c(&radiance, scene, params, TRUTH_C_FACTOR, threads);
	if (status == TS_OK) status = ts_picture_make(picture, "truth-c", radiance, params);
	picture->seconds = ts_seconds() - begin;
	return status;
}

static u64 larger(u64 a, u64 b) { return a > b ? a : b; }

ts_status ts_measure_estimate(u64 *bytes, const ts_pipeline *const *methods, u32 n_methods, u32 truths,
                              const ts_scene *scene, const ts_params *params)
{
	const ts_pipeline *mvr = ts_pipeline_find("reflections", "mvr");
	ts_params big = *params;
	*bytes = 0;
	for (u32 i = 0; i < n_methods; i++) *bytes = larger(*bytes, ts_pipeline_estimate(methods[i], scene, params, true));
	if ((truths & TS_TRUTH_C) != 0 && mvr != NULL) {
		big.width *= TRUTH_C_FACTOR;
		big.height *= TRUTH_C_FACTOR;
		big.face_max *= TRUTH_C_FACTOR;
		big.face_px *= TRUTH_C_FACTOR;
		*bytes = larger(*bytes, ts_pipeline_estimate(mvr, scene, &big, true));
	}
	u64 limit = ts_memory_limit();
	if (*bytes > limit) {
		return ts_fail("%s: needs about %.1f GB of memory and may use %.1f GB of this machine's %.1f GB; choose a smaller "
		               "--size, fewer --reflectors%s", scene->name, (double)*bytes / 1e9, (double)limit / 1e9,
		               (double)ts_memory_total() / 1e9, (truths & TS_TRUTH_C) != 0 ? ", or no truth C" : "");
	}
	return TS_OK;
}
