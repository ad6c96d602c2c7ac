/* Which stages, methods and truths read a parameter, from the notes of scripts/reads. */
#include "study/asked/reads.h"
#include <string.h>
#include "model/table.h"
#include "study/asked/words.h"

#define READS(kind, name, params) {kind, name, params},
static const struct {
	const char *kind, *name, *params;
} table[] = {
#include "study/asked/reads.def"
};

bool ts_reads(const char *kind, const char *name, const char *param)
{
	for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
		bool meant = strcmp(table[i].kind, kind) == 0 && (name == NULL || strcmp(table[i].name, name) == 0);
		if (meant && ts_words_have(table[i].params, param)) return true;
	}
	return false;
}

bool ts_reads_scene(const char *param) { return ts_reads("scene", NULL, param); }

static bool shape_reads(ts_buffer_id id, const char *param)
{
	const ts_shape *shape = ts_buffer_shape(id);
	for (u32 i = 0; i < shape->n; i++) {
		for (u32 k = 0; k < shape->axis[i].n_factors; k++) {
			if (ts_reads("size", ts_dim_table[shape->axis[i].factor[k]].name, param)) return true;
		}
	}
	return false;
}

static bool stage_reads(const ts_stage *stage, const char *param)
{
	const ts_buffer_id *made = ts_stage_outputs(stage);
	while (*made != TS_N_BUFFERS && !shape_reads(*made, param)) made++;
	return *made != TS_N_BUFFERS || ts_reads("stage", stage->name, param);
}

bool ts_reads_method(const ts_pipeline *method, const ts_params *params, const char *param)
{
	if (method->sets.param != NULL && strcmp(method->sets.param, param) == 0) return false;
	if (ts_reads(method->effect->name, method->name, param)) return true;
	for (const ts_step *step = ts_pipeline_steps(method); step->stage != NULL; step++) {
		bool takes = params == NULL || ts_pipeline_takes(step, params, true);
		if (takes && stage_reads(ts_stage_find(step->stage), param)) return true;
	}
	return false;
}

bool ts_reads_named(const char *effect, const char *method, const char *param)
{
	return ts_reads_method(ts_pipeline_find(effect, method), NULL, param);
}

/* Marks the stages that contribute to the buffer. */
static void mark_makers(const ts_pipeline *method, ts_buffer_id id, bool marked[TS_N_BUFFERS])
{
	const ts_step *maker = ts_pipeline_maker(method, id);
	if (marked[id] || maker == NULL) return;
	marked[id] = true;
	for (const ts_buffer_id *at = ts_stage_inputs(ts_stage_find(maker->stage)); *at != TS_N_BUFFERS; at++) {
		mark_makers(method, *at, marked);
	}
}

bool ts_reads_making(const ts_pipeline *method, const ts_buffer_id *ids, const char *param)
{
	bool marked[TS_N_BUFFERS] = {false}, reads = false;
	for (; *ids != TS_N_BUFFERS; ids++) mark_makers(method, *ids, marked);
	for (u32 id = 0; id < TS_N_BUFFERS && !reads; id++) {
		reads = marked[id] && stage_reads(ts_stage_find(ts_pipeline_maker(method, id)->stage), param);
	}
	return reads;
}
