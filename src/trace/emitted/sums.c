/* Digests of a run's files. */
#include "trace/emitted/sums.h"

ts_status ts_sums_take(void *user, const ts_chunk *chunk)
{
	ts_digest *digest = &((ts_sums *)user)->digest[chunk->id];
	if (chunk->first) {
		char header[TS_NPY_HEADER], descr[TS_NPY_DESCR];
		ts_npy_descr(descr, chunk->id);
		ts_digest_begin(digest);
		ts_digest_add(digest, header, ts_npy_header(header, descr, chunk->n_dims, chunk->shape));
	}
	return ts_digest_all(digest, chunk->data, (size_t)chunk->bytes);
}

void ts_sums_end(ts_sums *sums)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (sums->digest[id].begun) ts_digest_end(&sums->digest[id], sums->hex[id]);
	}
}

static ts_status take_stage(const ts_run *run, const ts_stage *stage, void *user)
{
	return ts_emit_stage(run, stage, ts_sums_take, user);
}

ts_status ts_sums_of(ts_sums *sums, const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *params,
                     const ts_how *how)
{
	ts_run run;
	*sums = (ts_sums){.hex = {{0}}};
	ts_run_begin(&run, scene, params, how->threads);
	ts_run_how(&run, how);
	run.traced = run.lean = true;
	run.hook = take_stage;
	run.hook_user = sums;
	ts_status status = ts_emit_scene(&run, ts_sums_take, sums);
	if (status == TS_OK) status = ts_pipeline_run(pipeline, &run);
	ts_sums_end(sums);
	ts_run_end(&run);
	return status;
}

void ts_sums_print(const ts_sums *sums, const ts_pipeline *pipeline, FILE *out)
{
	ts_buffer_id ids[TS_N_BUFFERS];
	ts_emit_order(ids, pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS; i++) {
		char name[TS_EMIT_NAME];
		if (sums->hex[ids[i]][0] == 0) continue;
		ts_emit_name(name, pipeline, ids[i]);
		fprintf(out, "%s  %s\n", sums->hex[ids[i]], name);
	}
}
