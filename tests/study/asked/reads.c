/* Who reads which parameter: a method, what makes a buffer of it, and scenes, by plain sums of the rows. */
#include "methods/stages.h"
#include "study/asked/reads.h"
#include "tests/model/test.h"

/* Whether a size that the buffer's shape names reads the parameter. */
static bool shape_reads(ts_buffer_id id, const char *param)
{
	char words[128];
	snprintf(words, sizeof words, "%s", ts_buffer_table[id].shape);
	for (char *word = strtok(words, " *+"); word != NULL; word = strtok(NULL, " *+")) {
		if (ts_reads("size", word, param)) return true;
	}
	return false;
}

/* Whether a stage or the size of a buffer that it makes reads the parameter. */
static bool stage_reads(const ts_stage *stage, const char *param)
{
	bool reads = ts_reads("stage", stage->name, param);
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) reads |= shape_reads(*id, param);
	return reads;
}

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
			reads = reads || stage_reads(stage, param);
			for (const ts_buffer_id *in = ts_stage_inputs(stage); *in != TS_N_BUFFERS; in++) {
				more = more || !made[*in];
				made[*in] = true;
			}
		}
	}
	return reads;
}

static void a_buffer_reads_what_its_stages_read(void **state)
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
				if (stages != reads) fail_msg("%s, %s: %s", (*method)->name, ts_buffer_table[id].name, param);
				bool own = (*method)->sets.param != NULL && strcmp((*method)->sets.param, param) == 0;
				if (reads && !own) assert_true(ts_reads_method(*method, NULL, param));
				n_reads += stages;
				n_not += !reads;
			}
		}
	}
	assert_true(n_reads > 20 && n_not > 1000);
}

static void rows_tell_who_reads_a_parameter(void **state)
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

typedef struct {
	u32 by_row, by_step, own;
} ways;

/* What the method's row or a stage that is taken reads; counted where only one of them does. */
static bool sum(ways *n, const ts_pipeline *method, const ts_params *params, const char *param)
{
	bool stages = false, left_out = false, row = ts_reads(method->effect->name, method->name, param);
	for (const ts_step *step = ts_pipeline_steps(method); step->stage != NULL; step++) {
		bool reads = stage_reads(ts_stage_find(step->stage), param);
		bool taken = params == NULL || ts_pipeline_takes(step, params, true);
		stages |= reads && taken;
		left_out |= reads && !taken;
	}
	bool own = method->sets.param != NULL && strcmp(method->sets.param, param) == 0;
	n->own += own && (row || stages);
	n->by_row += row && !stages;
	n->by_step += left_out && !row && !stages;
	return !own && (row || stages);
}

static void a_method_reads_what_its_steps_read(void **state)
{
	(void)state;
	size_t n;
	ways found = {0};
	ts_params usual;
	ts_params_default(&usual);
	const ts_param_info *table = ts_param_table(&n);
	for (const ts_pipeline *const *method = ts_pipelines(); *method != NULL; method++) {
		for (size_t p = 0; p < 2 * n; p++) {
			const ts_params *params = p < n ? NULL : &usual;
			const char *param = table[p % n].name;
			bool right = sum(&found, *method, params, param);
			if (ts_reads_method(*method, params, param) != right) fail_msg("%s: %s", (*method)->name, param);
		}
	}
	assert_true(found.by_row > 0 && found.by_step > 0 && found.own > 0);
}

static void two_buffers_read_what_either_does(void **state)
{
	(void)state;
	size_t n;
	u32 n_second = 0;
	const ts_param_info *table = ts_param_table(&n);
	for (const ts_pipeline *const *method = ts_pipelines(); *method != NULL; method++) {
		const ts_buffer_id *first = ts_stage_outputs(ts_stage_find(ts_pipeline_steps(*method)->stage));
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			if (ts_pipeline_maker(*method, (ts_buffer_id)id) == NULL || id % 23 != 3) continue;
			const ts_buffer_id both[] = {first[0], (ts_buffer_id)id, TS_N_BUFFERS};
			const ts_buffer_id one[] = {first[0], TS_N_BUFFERS}, other[] = {(ts_buffer_id)id, TS_N_BUFFERS};
			for (size_t p = 0; p < n; p += 5) {
				bool ours = ts_reads_making(*method, one, table[p].name);
				bool theirs = ts_reads_making(*method, other, table[p].name);
				assert_int_equal(ts_reads_making(*method, both, table[p].name), ours || theirs);
				n_second += theirs && !ours;
			}
		}
	}
	assert_true(n_second > 0);
}

/* Some kind of scene reads a parameter if a row of scenes has it, whatever stages and truths read. */
static void scenes_read_what_their_rows_say(void **state)
{
	(void)state;
	size_t n;
	u32 n_reads = 0, n_others = 0;
	const ts_param_info *table = ts_param_table(&n);
	for (size_t p = 0; p < n; p++) {
		const char *param = table[p].name;
		bool reads = ts_reads("scene", "built-in", param) || ts_reads("scene", "file", param);
		assert_int_equal(ts_reads_scene(param), reads);
		n_reads += reads;
		n_others += !reads && (ts_reads("truth", NULL, param) || ts_reads("stage", NULL, param));
	}
	assert_true(n_reads > 5 && n_others > 5);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_buffer_reads_what_its_stages_read), cmocka_unit_test(rows_tell_who_reads_a_parameter),
		cmocka_unit_test(a_method_reads_what_its_steps_read), cmocka_unit_test(two_buffers_read_what_either_does),
		cmocka_unit_test(scenes_read_what_their_rows_say)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
