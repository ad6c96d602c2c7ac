/* Who reads which parameter: what makes a buffer reads no more than the whole method, and no less than its stages. */
#include "../../src/study/reads.h"
#include "../model/test.h"
#include "../../src/methods/stages.h"

/* The stages that a buffer comes from, by a plain search until nothing is new. */
static bool makes(const ts_pipeline *method, ts_buffer_id id, const char *param)
{
	static bool made[TS_N_BUFFERS];
	memset(made, 0, sizeof made);
	made[id] = true;
	bool reads = false;
	for (bool more = true; more;) {
		more = false;
		for (const ts_step *step = ts_pipeline_steps(method); step->stage != NULL; step++) {
			const ts_stage *stage = ts_stage_find(step->stage);
			bool wanted = false;
			for (const ts_buffer_id *out = ts_stage_outputs(stage); *out != TS_N_BUFFERS; out++) {
				const ts_step *maker = made[*out] ? ts_pipeline_maker(method, *out) : NULL;
				wanted = wanted || (maker != NULL && strcmp(maker->stage, step->stage) == 0);
			}
			if (!wanted) continue;
			reads = reads || ts_reads("stage", step->stage, param);
			for (const ts_buffer_id *in = ts_stage_inputs(stage); *in != TS_N_BUFFERS; in++) {
				more = more || !made[*in];
				made[*in] = true;
			}
		}
	}
	return reads;
}

static void test_making(void **state)
{
	(void)state;
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	u32 n_reads = 0, n_not = 0;
	for (const ts_pipeline *const *method = ts_pipelines(); *method != NULL; method++) {
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			if (ts_pipeline_maker(*method, (ts_buffer_id)id) == NULL || id % 23 != 7)
				continue; /* some of each pipeline */
			const ts_buffer_id ids[] = {(ts_buffer_id)id, TS_N_BUFFERS};
			for (size_t p = 0; p < n; p++) {
				const char *param = table[p].name;
				bool reads = ts_reads_making(*method, ids, param), stages = makes(*method, (ts_buffer_id)id, param);
				if (stages && !reads) fail_msg("%s, %s: %s", (*method)->name, ts_buffer_table[id].name, param);
				bool own = (*method)->sets.param != NULL && strcmp((*method)->sets.param, param) == 0;
				if (reads && !own) assert_true(ts_reads_method(*method, NULL, param));
				n_reads += stages;
				n_not += !reads;
			}
		}
	}
	assert_true(n_reads > 20 && n_not > 1000);
}

static void test_rows(void **state)
{
	(void)state;
	const ts_buffer_id none[] = {TS_N_BUFFERS};
	assert_true(ts_reads("stage", "eye", "width") || ts_reads("size", NULL, "width"));
	assert_false(ts_reads("stage", NULL, "no.parameter"));
	assert_false(ts_reads("no kind", NULL, "width"));
	assert_false(ts_reads_making(ts_pipelines()[0], none, "width"));
	assert_true(ts_reads_method(ts_pipelines()[0], NULL, "width"));
	assert_false(ts_reads_scene("no.parameter"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_making), cmocka_unit_test(test_rows)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
