/* What the tests of checks share: a run whose buffers are a trace's, and faults planted in them. */
#ifndef TS_TESTS_TRACE_LOADED_H
#define TS_TESTS_TRACE_LOADED_H
#include "../methods/small.h"
#include "../../src/replay/check.h"
#include "../../src/trace/field.h"

static ts_run run;
static ts_scene *scene;
static ts_trace trace;

/* Runs a method on the scene; its buffers become those of the trace. */
static inline void loaded_run(const ts_pipeline *pipeline, const ts_params *params)
{
	scene = small_scene(params);
	ts_run_begin(&run, scene, params, 2);
	if (ts_pipeline_run(pipeline, &run) != TS_OK) fail_msg("%s", ts_error_message());
	trace.pipeline = pipeline;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_buffer *buffer = &run.frame.buffer[id];
		if (!buffer->made) continue;
		ts_trace_item *item = &trace.item[id];
		item->path = (char *)(uintptr_t)ts_buffer_table[id].name;
		item->npy.n = buffer->n;
		item->npy.n_dims = buffer->n_dims;
		memcpy(item->npy.shape, buffer->shape, sizeof buffer->shape);
	}
}

static int end(void **state)
{
	(void)state;
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

/* The stage refuses the value, and names the place, in one line. */
static inline void refuses(const char *name, ts_buffer_id id, u64 element, const char *field, u64 value)
{
	ts_load load;
	const ts_stage *stage = ts_stage_find(name);
	ts_buffer *buffer = &run.frame.buffer[id];
	const ts_fields fields = ts_fields_of(id);
	u32 f = 0;
	while (strcmp(fields.field[f].name, field) != 0) f++;
	u8 *at = (u8 *)buffer->data + element * ts_buffer_table[id].element_bytes + fields.field[f].offset;
	u64 kept = 0;
	assert_true(element < buffer->n);
	memcpy(&kept, at, fields.field[f].bytes);
	memcpy(at, &value, fields.field[f].bytes);
	load_for(&load, stage);
	ts_status status = ts_check(&load, stage);
	memcpy(at, &kept, fields.field[f].bytes);
	char place[64];
	snprintf(place, sizeof place, ": element %u", (unsigned)element);
	const char *message = ts_error_message();
	bool told = strncmp(message, ts_buffer_table[id].name, strlen(ts_buffer_table[id].name)) == 0 &&
	            strstr(message, place) != NULL && strstr(message, "would be right") != NULL &&
	            strchr(message, '\n') == NULL;
	if (status != TS_ERROR || !told) fail_msg("%s, %s of %s: %s", name, field, ts_buffer_table[id].name, message);
}

/* Nothing is wrong with what any of its stages reads. */
static void test_right(void **state)
{
	(void)state;
	for (const ts_step *step = ts_pipeline_steps(trace.pipeline); step->stage != NULL; step++) {
		if (!ts_pipeline_takes(step, &run.params, true)) continue;
		ts_load load;
		const ts_stage *stage = ts_stage_find(step->stage);
		load_for(&load, stage);
		if (ts_check(&load, stage) != TS_OK) fail_msg("%s: %s", step->stage, ts_error_message());
	}
}

#endif
