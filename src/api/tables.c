/* Tables to walk. */
#include <assert.h>
#include <pthread.h>
#include <string.h>
#include <touchstone/tables.h>
#include "api/api.h"
#include "methods/pipeline.h"
#include "trace/emitted/emit.h"

enum { MOST_METHODS = 64, MOST_STAGES = 128 };
static ts_method_info methods[MOST_METHODS];
static ts_stage_info stages[MOST_STAGES];
static size_t n_methods, n_stages;

static void make(void)
{
	ts_api_ready();
	for (const ts_pipeline *const *at = ts_pipelines(), *p; (p = *at) != NULL; at++) {
		assert(n_methods < MOST_METHODS);
		methods[n_methods++] = (ts_method_info){p->effect->name, p->name, p->paper, p->doc, p->only_named};
	}
	for (const ts_stage *const *at = ts_stages(), *s; (s = *at) != NULL; at++) {
		assert(n_stages < MOST_STAGES);
		stages[n_stages++] = (ts_stage_info){s->name, s->kind, s->margin_of, s->paper, s->doc, s->launches != NULL};
	}
}

static void require(void)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, make);
}

const ts_method_info *ts_method_at(size_t i)
{
	require();
	return i < n_methods ? &methods[i] : NULL;
}

const ts_stage_info *ts_stage_at(size_t i)
{
	require();
	return i < n_stages ? &stages[i] : NULL;
}

/* Step i of a method; NULL: there is none. */
static const ts_step *step_at(const ts_pipeline **pipeline, const char *effect, const char *method, size_t i)
{
	*pipeline = effect != NULL && method != NULL ? ts_pipeline_find(effect, method) : NULL;
	const ts_step *step = *pipeline != NULL ? ts_pipeline_steps(*pipeline) : NULL;
	while (step != NULL && step->stage != NULL && i > 0) step++, i--;
	return step != NULL && step->stage != NULL ? step : NULL;
}

const ts_stage_info *ts_method_stage(const char *effect, const char *method, size_t i)
{
	const ts_pipeline *pipeline;
	require();
	const ts_step *step = step_at(&pipeline, effect, method, i);
	for (size_t k = 0; step != NULL && k < n_stages; k++) {
		if (strcmp(stages[k].name, step->stage) == 0) return &stages[k];
	}
	return NULL;
}

uint32_t ts_method_stage_number(const char *effect, const char *method, size_t i)
{
	const ts_pipeline *pipeline;
	ts_api_ready();
	const ts_step *step = step_at(&pipeline, effect, method, i);
	return step != NULL ? ts_emit_number(pipeline, ts_stage_outputs(ts_stage_find(step->stage))[0]) : 0;
}

static const char *nth(const ts_buffer_id *ids, size_t i)
{
	while (*ids != TS_N_BUFFERS && i > 0) ids++, i--;
	return *ids != TS_N_BUFFERS ? ts_buffer_table[*ids].name : NULL;
}

static const ts_stage *find(const char *name)
{
	ts_api_ready();
	return name != NULL ? ts_stage_find(name) : NULL;
}

const char *ts_stage_input(const char *stage, size_t i)
{
	return find(stage) != NULL ? nth(ts_stage_inputs(find(stage)), i) : NULL;
}

const char *ts_stage_output(const char *stage, size_t i)
{
	return find(stage) != NULL ? nth(ts_stage_outputs(find(stage)), i) : NULL;
}

const ts_buffer_info *ts_buffer_at(size_t i) { return i < TS_N_BUFFERS ? &ts_buffer_table[i] : NULL; }

static ts_size_info sizes[TS_N_DIMS];

static void list_sizes(void)
{
	for (u32 i = 0; i < TS_N_DIMS; i++) {
		sizes[i] = (ts_size_info){ts_dim_table[i].name, ts_dim_table[i].noun, ts_dim_table[i].doc};
	}
}

const ts_size_info *ts_size_at(size_t i)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, list_sizes);
	return i < TS_N_DIMS ? &sizes[i] : NULL;
}

int ts_buffer_is_image(const char *name)
{
	u32 id = 0;
	while (name != NULL && id < TS_N_BUFFERS && strcmp(ts_buffer_table[id].name, name) != 0) id++;
	return name != NULL && id < TS_N_BUFFERS && ts_shape_is_image(ts_buffer_shape((ts_buffer_id)id));
}

const ts_field_info *ts_field_at(size_t i)
{
	size_t n;
	const ts_field_info *fields = ts_field_table(&n);
	return i < n ? &fields[i] : NULL;
}
