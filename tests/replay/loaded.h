/* What the tests of checks share: a run whose buffers are a trace's, in memory, and faults planted in them. */
#ifndef TS_TESTS_REPLAY_LOADED_H
#define TS_TESTS_REPLAY_LOADED_H
#include "replay/check.h"
#include "tests/methods/small.h"
#include "tests/replay/spot.h"

static ts_run run;
static ts_scene *scene;
static ts_trace trace, candidate;

/* Runs a method on the scene; its buffers become those of the trace. */
static inline void loaded_run(const ts_pipeline *pipeline, const ts_params *params)
{
	scene = small_scene(params);
	ts_run_begin(&run, scene, params, 2);
	if (ts_pipeline_run(pipeline, &run) != TS_OK) fail_msg("%s", ts_error_message());
	trace = (ts_trace){.dir = (char *)(uintptr_t) "run", .pipeline = pipeline, .has_params = true, .params = *params};
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_buffer *buffer = &run.frame.buffer[id];
		if (!buffer->made) continue;
		ts_trace_item *item = &trace.item[id];
		item->path = (char *)(uintptr_t)ts_buffer_table[id].name;
		item->memory = ts_frame_data(&run.frame, (ts_buffer_id)id);
		item->npy.n = buffer->n;
		item->npy.n_dims = buffer->n_dims;
		memcpy(item->npy.shape, buffer->shape, sizeof buffer->shape);
	}
}

static int end(void **state)
{
	(void)state;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) free(candidate.item[id].owned);
	ts_run_end(&run);
	ts_scene_free(scene);
	return 0;
}

/* What a stage reads, loaded. */
static inline void load_for(ts_load *load, const ts_stage *stage)
{
	*load = (ts_load){.run = run, .scene = *scene, .pipeline = trace.pipeline, .reference = &trace};
	load->run.scene = &load->scene;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool loaded = run.frame.buffer[id].made && ts_stage_reads(stage, (ts_buffer_id)id);
		if (loaded) load->item[id] = &trace.item[id];
	}
}

/* Checks the run's buffers, of which one may be damaged, as for a stage. */
static inline ts_status check_for(const char *stage)
{
	ts_load load;
	load_for(&load, ts_stage_find(stage));
	return ts_check(&load, ts_stage_find(stage));
}

/* Checks the run's buffers with another value in one of them, which gets its own back. */
static inline ts_status check_component(const char *stage, ts_buffer_id id, u64 element, const char *field,
                                        u32 component, u64 value)
{
	u64 kept;
	spot place = spot_of(ts_frame_data(&run.frame, id), ts_frame_n(&run.frame, id), id, element, field, component);
	memcpy(&kept, place.at, place.bytes);
	memcpy(place.at, &value, place.bytes);
	ts_status status = check_for(stage);
	memcpy(place.at, &kept, place.bytes);
	return status;
}

/* The same of the first component. */
static inline ts_status check_with(const char *stage, ts_buffer_id id, u64 element, const char *field, u64 value)
{
	return check_component(stage, id, element, field, 0, value);
}

static inline void accepts(const char *name, ts_buffer_id id, u64 element, const char *field, u64 value)
{
	ts_status status = check_with(name, id, element, field, value);
	if (status != TS_OK) fail_msg("%s, %s of %s: %s", name, field, ts_buffer_table[id].name, ts_error_message());
}

/* The stage refuses the value, and names the place, in one line. */
static inline void refuses(const char *name, ts_buffer_id id, u64 element, const char *field, u64 value)
{
	ts_status status = check_with(name, id, element, field, value);
	char place[64];
	snprintf(place, sizeof place, ": element %u", (unsigned)element);
	const char *message = ts_error_message();
	bool told = strncmp(message, ts_buffer_table[id].name, strlen(ts_buffer_table[id].name)) == 0 &&
	            strstr(message, place) != NULL && strstr(message, "would be right") != NULL &&
	            strchr(message, '\n') == NULL;
	if (status != TS_ERROR || !told) fail_msg("%s, %s of %s: %s", name, field, ts_buffer_table[id].name, message);
}

/* Nothing is wrong with what any of its stages reads. */
static inline void what_is_loaded_is_right(void **state)
{
	(void)state;
	for (const ts_step *step = ts_pipeline_steps(trace.pipeline); step->stage != NULL; step++) {
		if (!ts_pipeline_takes(step, &run.params, true)) continue;
		if (check_for(step->stage) != TS_OK) fail_msg("%s: %s", step->stage, ts_error_message());
	}
}

/* ---- a candidate of the run's method, with buffers of its own ---- */
/* Forgets the buffers of the candidate before. */
static inline void candidate_begin(bool arrival)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) free(candidate.item[id].owned);
	candidate = (ts_trace){.dir = (char *)(uintptr_t) "candidate", .pipeline = trace.pipeline, .arrival = arrival};
}

/* Gives it a copy of a buffer of the run, and hands the copy out. */
static inline void *candidate_copy(ts_buffer_id id)
{
	ts_trace_item *item = &candidate.item[id];
	size_t bytes = (size_t)trace.item[id].npy.n * ts_buffer_table[id].element_bytes;
	*item = trace.item[id];
	item->memory = item->owned = malloc(bytes + 1);
	assert_true(item->owned != NULL && trace.item[id].path != NULL);
	return memcpy(item->owned, trace.item[id].memory, bytes);
}

#endif
