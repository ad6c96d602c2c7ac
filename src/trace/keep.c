/* From the parts of a run's files to arrays in memory. */
#include "trace/keep.h"
#include <stdlib.h>
#include "trace/emitted/emit.h"
#include "trace/item.h"

typedef struct {
	ts_trace *trace;
	const ts_keep *keep;
	u64 filled[TS_N_BUFFERS]; /* bytes so far */
} keeper;

static bool is_kept(const keeper *k, ts_buffer_id id) { return k->keep->whole || k->keep->keep[id]; }

static ts_status begin(keeper *k, const ts_chunk *chunk)
{
	ts_npy npy = {.n_dims = chunk->n_dims};
	memcpy(npy.shape, chunk->shape, sizeof npy.shape);
	if (!ts_shape_count(&npy.n, npy.n_dims, npy.shape))
		return ts_fail_as(TS_KIND_MEMORY, "%s: too large for memory", ts_buffer_table[chunk->id].name);
	if (ts_item_keep(k->trace, chunk->id, &npy, NULL) != TS_OK) return TS_ERROR;
	k->filled[chunk->id] = 0;
	return TS_OK;
}

static ts_status take(void *user, const ts_chunk *chunk)
{
	keeper *k = user;
	if (!is_kept(k, chunk->id)) return TS_OK;
	if (chunk->first && begin(k, chunk) != TS_OK) return TS_ERROR;
	if (chunk->bytes == 0) return TS_OK;
	memcpy((u8 *)k->trace->item[chunk->id].owned + k->filled[chunk->id], chunk->data, (size_t)chunk->bytes);
	k->filled[chunk->id] += chunk->bytes;
	return TS_OK;
}

static ts_status borrow(void *user, const ts_chunk *chunk)
{
	keeper *k = user;
	ts_npy npy = {.n_dims = chunk->n_dims, .n = chunk->bytes / ts_buffer_table[chunk->id].element_bytes};
	memcpy(npy.shape, chunk->shape, sizeof npy.shape);
	return is_kept(k, chunk->id) ? ts_item_put(k->trace, chunk->id, &npy, chunk->data) : TS_OK;
}

static ts_status take_stage(const ts_run *run, const ts_stage *stage, void *user)
{
	return ts_emit_stage(run, stage, take, user);
}

static void describe(ts_trace *trace, const ts_pipeline *pipeline, const ts_run *run)
{
	trace->pipeline = pipeline;
	trace->arrival = run->arrival;
	trace->has_params = true;
	trace->params = run->params;
	trace->n_counters = run->n_counters;
	memcpy(trace->counters, run->counters, sizeof trace->counters);
}

ts_status ts_trace_keep(ts_trace **trace, const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *params,
                        const ts_how *how, const ts_keep *keep)
{
	char name[64];
	snprintf(name, sizeof name, "the run by %s", pipeline->name);
	keeper k = {.trace = ts_trace_new(name), .keep = keep};
	ts_run run;
	*trace = NULL;
	if (k.trace == NULL) return TS_ERROR;
	ts_run_begin(&run, scene, params, how->threads);
	ts_run_how(&run, how);
	run.traced = keep->whole;
	run.margins = keep->margins;
	run.lean = true;
	run.hook = take_stage;
	run.hook_user = &k;
	ts_status status = ts_emit_scene(&run, borrow, &k);
	if (status == TS_OK) status = ts_pipeline_run(pipeline, &run);
	describe(k.trace, pipeline, &run);
	ts_run_end(&run);
	if (status == TS_OK) {
		*trace = k.trace;
	} else {
		ts_trace_close(k.trace);
	}
	return status;
}
