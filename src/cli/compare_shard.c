/* Stages of a comparison as cases. */
#include "compare_shard.h"

u32 ts_compare_place(const ts_pipeline *pipeline, ts_buffer_id id)
{
	const ts_step *step = ts_pipeline_maker(pipeline, id);
	return step != NULL ? (u32)(step - ts_pipeline_steps(pipeline)) + 1 : 0;
}

json_t *ts_compare_cases(const ts_pipeline *pipeline)
{
	json_t *names = json_pack("[s]", "scene");
	int failed = names == NULL;
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step++) {
		failed |= json_array_append_new(names, json_string(step->stage)) != 0;
	}
	if (failed == 0) return names;
	json_decref(names);
	ts_fail("the names of stages: out of memory");
	return NULL;
}

ts_status ts_compare_own(bool own[TS_N_BUFFERS], const ts_trace *reference, const ts_trace *candidate,
                         const ts_relaxations *relaxations, ts_shard shard)
{
	u32 n = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool both = reference->item[id].path != NULL && candidate->item[id].path != NULL;
		n += both && !ts_relax_ignores(relaxations, ts_buffer_table[id].name);
		own[id] = ts_shard_has(shard, ts_compare_place(reference->pipeline, (ts_buffer_id)id));
	}
	return n > 0 ? TS_OK : ts_fail("%s: no buffer that the reference has too: nothing to judge", candidate->dir);
}

ts_status ts_compare_aside(ts_comparison *c, const ts_trace *reference, const ts_trace *candidate,
                           const ts_relaxations *relaxations)
{
	bool wanted[TS_N_BUFFERS] = {false};
	ts_relaxations others = *relaxations;
	ts_comparison *aside = ts_comparison_make(1);
	if (aside == NULL) return TS_ERROR;
	others.only = wanted;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_step *step = ts_pipeline_maker(reference->pipeline, (ts_buffer_id)id);
		if (c->verdict[id].judgement != TS_UNLIKE || step == NULL) continue;
		const ts_buffer_id *input = ts_stage_inputs(ts_stage_find(step->stage));
		for (; *input != TS_N_BUFFERS; input++) wanted[*input] = !relaxations->only[*input];
	}
	ts_status status = ts_compare_traces(aside, reference, candidate, &others);
	for (u32 id = 0; id < TS_N_BUFFERS && status != TS_ERROR; id++) {
		if (!wanted[id]) continue;
		c->verdict[id] = aside->verdict[id];
		c->verdict[id].list = (ts_differences){.n = 0};
		c->verdict[id].aside = true;
	}
	ts_comparison_free(aside);
	return status == TS_ERROR ? TS_ERROR : TS_OK;
}
