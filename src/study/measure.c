/* Running a method and keeping its figures. */
#include "study/measure.h"
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include "methods/stages.h"
#include "study/stage_pictures.h"
#if defined(__GLIBC__)
#include <malloc.h>
#endif

static const ts_buffer_id *const *keeps;
static const ts_lower_rule *const *lowers;

void ts_measure_keeps_use(const ts_buffer_id *const *ids) { keeps = ids; }

void ts_measure_lowers_use(const ts_lower_rule *const *rules) { lowers = rules; }

static void measure_faces(ts_measure *m, const ts_frame *frame)
{
	const ts_face *faces = ts_frame_data(frame, TS_B_cube_size_face);
	u64 n = ts_frame_n(frame, TS_B_cube_size_face), sum = 0;
	m->n_in_sight = 0;
	for (u64 r = 0; r < n; r++) {
		sum += faces[r].n;
		m->n_in_sight += faces[r].n > 0;
	}
	m->mean_diameter = m->n_in_sight > 0 ? (double)sum / m->n_in_sight : 0;
}

/* Judges texels that the stage wrote by rays through them, where that is possible. */
static ts_status judge_texels(ts_measure *m, const ts_run *run, const ts_stage *stage)
{
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		const ts_texel_rule *rule = ts_texels_find(*id);
		bool triangles = run->frame.buffer[TS_B_pose_vertex].made;
		if (rule == NULL || !triangles || !run->frame.buffer[*id].made) continue;
		if (m->tree == NULL && ts_truth_new(&m->tree, run) != TS_OK) return TS_ERROR;
		if (rule->judge(&m->texels, m->tree, run, *id) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static u64 bytes_of(const ts_run *run, const ts_buffer_id *ids)
{
	u64 bytes = 0;
	for (; *ids != TS_N_BUFFERS; ids++) {
		bool counts = run->frame.buffer[*ids].made && *ids != TS_B_scene_texel;
		if (counts) bytes += ts_frame_n(&run->frame, *ids) * ts_buffer_table[*ids].element_bytes;
	}
	return bytes;
}

static void add_moved(ts_measure *m, const ts_run *run, const ts_stage *stage)
{
	u32 k = 0;
	while (strcmp(run->timings[k].stage, stage->name) != 0) k++;
	m->moved[k] += bytes_of(run, ts_stage_inputs(stage)) + bytes_of(run, ts_stage_outputs(stage));
}

static ts_status after_stage(const ts_run *run, const ts_stage *stage, void *user)
{
	ts_measure *m = user;
	add_moved(m, run, stage);
	for (const ts_buffer_id *at = ts_stage_outputs(stage); *at != TS_N_BUFFERS; at++) {
		ts_buffer_id id = *at;
		if (!run->frame.buffer[id].made) continue;
		u64 n = ts_frame_n(&run->frame, id), bytes = n * ts_buffer_table[id].element_bytes;
		m->elements[id] += n;
		m->bytes[id] = bytes > m->bytes[id] ? bytes : m->bytes[id];
		if (id == TS_B_cube_size_face) {
			m->elements[id] = n;
			measure_faces(m, &run->frame);
		}
	}
	ts_status status = m->pictures != NULL ? ts_stage_pictures_take(m->pictures, run, stage) : TS_OK;
	if (status == TS_OK && m->rays) status = judge_texels(m, run, stage);
	if (status == TS_OK && m->notes) status = ts_notes_take(m->note, run, stage);
	if (status == TS_OK && m->viewer != NULL) status = ts_viewer_take(run, stage, m->viewer);
	return status == TS_OK && m->writer != NULL ? ts_trace_write_stage(m->writer, run, stage) : status;
}

static void keep_counter(ts_measure *m, ts_counter counter)
{
	if (m->n_counters < TS_MAX_COUNTERS) m->counters[m->n_counters++] = counter;
}

static void keep_texels(ts_measure *m)
{
	const ts_texel_counts *texels = &m->texels;
	const ts_counter counters[] = {{"texels covered by rays", (i64)texels->covered},
	                               {"holes", (i64)texels->holes},
	                               {"leaks", (i64)texels->leaks},
	                               {"wrong depths", (i64)texels->apart},
	                               {"shadows asked of rays", (i64)texels->asked},
	                               {"lit but by rays", (i64)texels->lit},
	                               {"dark but by rays", (i64)texels->dark}};
	u32 n = texels->asked > 0 ? 7 : 4;
	if (texels->one_of > 1) keep_counter(m, (ts_counter){"texels a ray", texels->one_of});
	for (u32 i = 0; i < n; i++) keep_counter(m, counters[i]);
	for (u32 i = 0; texels->reasons != NULL && texels->reasons[i] != NULL; i++) {
		keep_counter(m, (ts_counter){texels->reasons[i], (i64)texels->because[i]});
	}
}

static void keep(ts_measure *m, const ts_run *run)
{
	m->n_counters = run->n_counters;
	m->n_timings = run->n_timings;
	memcpy(m->counters, run->counters, sizeof m->counters);
	if (m->tree != NULL) keep_texels(m);
	memcpy(m->timings, run->timings, sizeof m->timings);
	m->peak_bytes = run->frame.peak_bytes;
}

static void keep_buffers(ts_run *run, const ts_buffer_id *ids)
{
	for (; *ids != TS_N_BUFFERS; ids++) run->keep[*ids] = true;
}

/* Keeps buffers that are read after the run, by truths that start from it and by families, and the eye's view. */
static void keep_for_after(ts_run *run, const ts_effect *effect)
{
	assert(keeps != NULL);
	run->lean = true;
	run->keep[effect->seen] = true;
	for (const ts_buffer_id *const *ids = keeps; *ids != NULL; ids++) keep_buffers(run, *ids);
	for (const ts_truth_kind *const *kind = ts_truths(); *kind != NULL; kind++) {
		if ((*kind)->needs != NULL) keep_buffers(run, (*kind)->needs);
	}
}

/* Whether buffers of stages, or all their counts, are read. */
static bool is_looked_at(const ts_measure *m)
{
	return m->whole || m->rays || m->pictures != NULL || m->trace != NULL || m->viewer != NULL;
}

ts_status ts_measure_run(ts_measure *measure, const ts_pipeline *method, const ts_scene *scene, const ts_params *params,
                         const ts_how *how, ts_measure_after after, void *user)
{
	*measure = (ts_measure){.method = method,
	                        .pictures = measure->pictures,
	                        .trace = measure->trace,
	                        .viewer = measure->viewer,
	                        .rays = measure->rays,
	                        .history = measure->history,
	                        .notes = measure->notes,
	                        .whole = measure->whole};
	ts_run run;
	ts_run_begin(&run, scene, params, how->threads);
	ts_run_how(&run, how);
	keep_for_after(&run, method->effect);
	run.asked = !is_looked_at(measure);
	run.hook = after_stage;
	run.hook_user = measure;
	run.history = measure->history;
	run.traced = measure->trace != NULL;
	run.margins = run.traced && measure->trace->margins;
	ts_status status = TS_OK;
	if (run.traced) status = ts_trace_write_begin(&measure->writer, method, &run, measure->trace);
	if (status == TS_OK) status = ts_pipeline_run(method, &run);
	if (status == TS_OK && run.traced) status = ts_trace_write_end(measure->writer, &run);
	ts_trace_write_free(measure->writer);
	measure->writer = NULL;
	keep(measure, &run);
	ts_truth_free(measure->tree);
	measure->tree = NULL;
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

/* The parameter that alone sets more than half of a method's memory; NULL: none. */
static const char *largest_param(const ts_pipeline *method, const ts_params *params, u64 bytes)
{
	assert(lowers != NULL);
	for (const ts_lower_rule *const *list = lowers; *list != NULL; list++) {
		for (const ts_lower_rule *rule = *list; rule->param != NULL; rule++) {
			bool made = ts_pipeline_maker(method, rule->buffer) != NULL;
			if (made && rule->bytes(params) > bytes / 2) return rule->param;
		}
	}
	return NULL;
}

/* The largest part of a method's memory except its image. */
static const char *what_to_lower(const ts_pipeline *method, const ts_params *params, u64 bytes)
{
	const char *param = largest_param(method, params, bytes);
	if (param != NULL) return param;
	return method->lower != NULL ? method->lower : method->effect->lower;
}

/* The truth of `truths` that needs most memory; NULL if none needs more than *bytes, which becomes its need. */
static const ts_truth_kind *largest_truth(u64 *bytes, u32 truths, const ts_pipeline *method, const ts_scene *scene,
                                          const ts_params *params)
{
	const ts_truth_kind *largest = NULL;
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		const ts_truth_kind *kind = ts_truths()[t];
		if ((truths & 1u << t) == 0 || kind->bytes == NULL) continue;
		u64 own;
		TS_PARAM_READER("truth", kind->name, own = kind->bytes(method, scene, params));
		largest = own > *bytes ? kind : largest;
		*bytes = own > *bytes ? own : *bytes;
	}
	return largest;
}

ts_status ts_measure_estimate(ts_estimate *estimate, const ts_pipeline *const *methods, u32 n_methods, u32 truths,
                              const ts_scene *scene, const ts_params *params, const ts_leaves *leaves)
{
	const ts_pipeline *largest = methods[0];
	u64 run = 0, limit = ts_memory_limit();
	for (u32 i = 0; i < n_methods; i++) {
		u64 own = ts_pipeline_estimate(methods[i], scene, params, true);
		largest = own > run ? methods[i] : largest;
		run = own > run ? own : run;
	}
	const ts_truth_kind *truth = largest_truth(&run, truths, methods[0], scene, params);
	if (leaves != NULL) run = (run > leaves->writing ? run : leaves->writing) + leaves->pictures;
	*estimate = (ts_estimate){.held = ts_memory_used(), .run = run};
	if (estimate->held <= limit && run <= limit - estimate->held) return TS_OK;
	return ts_fail("%s: needs about %.1f GB of memory and may use %.1f GB of this machine's %.1f GB; choose a smaller "
	               "image, %s%s%s",
	               scene->name, (double)estimate->held / 1e9 + (double)run / 1e9, (double)limit / 1e9,
	               (double)ts_memory_total() / 1e9, what_to_lower(largest, params, run),
	               truth != NULL ? ", or no truth " : "", truth != NULL ? truth->name : "");
}

void ts_measure_keep_memory(void)
{
#if defined(__GLIBC__)
	mallopt(M_MMAP_MAX, 0);
	mallopt(M_TRIM_THRESHOLD, -1);
	mallopt(M_ARENA_MAX, 1);
#endif
}

void ts_measure_touch_memory(u64 bytes)
{
	const size_t page = 4096;
	volatile u8 *memory = malloc((size_t)bytes);
	if (memory == NULL) return;
	ts_memory_large_pages((void *)memory, (size_t)bytes);
	for (size_t i = 0; i < (size_t)bytes; i += page) memory[i] = 0;
	free((void *)memory);
}

void ts_measure_return_memory(void)
{
#if defined(__GLIBC__)
	malloc_trim(0);
#endif
}
