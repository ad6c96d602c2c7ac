/* Stages by their names. */
#include "compare/part.h"
#include <string.h>
#include "compare/digests.h"
#include "trace/emit.h"

/* Whether the first n bytes of `text` are that name. */
static bool is_name(const char *name, const char *text, size_t n)
{
	return strlen(name) == n && memcmp(name, text, n) == 0;
}

static ts_status take_stage(bool part[TS_N_BUFFERS], const ts_pipeline *pipeline, const char *text, size_t n)
{
	bool known = is_name("scene", text, n);
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step++) {
		known |= is_name(step->stage, text, n);
	}
	for (u32 id = 0; id < TS_N_BUFFERS; id++) part[id] |= is_name(ts_emit_maker(pipeline, (ts_buffer_id)id), text, n);
	if (known) return TS_OK;
	return ts_fail("stages: \"%.*s\" is no stage of %s", (int)(n < 80 ? n : 80), text, pipeline->name);
}

ts_status ts_part_make(bool part[TS_N_BUFFERS], const char *stages, const ts_trace *reference,
                       const ts_trace *candidate, const ts_relaxations *relaxations)
{
	bool any = false;
	memset(part, 0, TS_N_BUFFERS * sizeof *part);
	for (const char *at = stages; *at != 0; at += *at == ',') {
		size_t length = strcspn(at, ",");
		if (take_stage(part, reference->pipeline, at, length) != TS_OK) return TS_ERROR;
		at += length;
	}
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool both = ts_digest_known(&reference->item[id]) && ts_digest_known(&candidate->item[id]);
		any |= both && !ts_relax_ignores(relaxations, ts_buffer_table[id].name);
	}
	return any ? TS_OK : ts_fail("%s: no buffer that the reference has too: nothing to judge", candidate->dir);
}

ts_status ts_part_inputs(ts_comparison *c, const ts_trace *reference, const ts_trace *candidate,
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
