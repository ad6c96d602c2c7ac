/* Flat steps: no run is left, every margin stands behind its stage and is like it in all but its name, and numbers
 * of files are those of the steps without margins. */
#include "tests/methods/small.h"
#include "trace/emitted/emit.h"

static u32 count(const ts_step *step)
{
	u32 n = 0;
	for (; step->stage != NULL || step->run != NULL; step++) n += step->run != NULL ? count(step->run) : 1;
	return n;
}

static bool same_but_margin(ts_step a, ts_step b)
{
	a.stage = b.stage;
	a.only_margins = b.only_margins;
	return a.least_bounces == b.least_bounces && a.only_traced == b.only_traced && a.only_ordered == b.only_ordered &&
	       a.stored == b.stored && a.only_if == b.only_if && a.unnumbered == b.unnumbered &&
	       a.each_batch == b.each_batch;
}

static void check(const ts_pipeline *p)
{
	u32 n = 0;
	for (const ts_step *step = ts_pipeline_steps(p); step->stage != NULL; step++) {
		const ts_stage *stage = ts_stage_find(step->stage), *margin = ts_stage_margin(stage);
		assert_non_null(stage);
		assert_null(step->run);
		n += !step->only_margins;
		if (margin == NULL) continue;
		assert_string_equal(step[1].stage, margin->name);
		assert_true(step[1].only_margins && !step->only_margins && same_but_margin(step[0], step[1]));
		assert_int_equal(ts_emit_number(p, ts_stage_outputs(margin)[0]), ts_emit_number(p, ts_stage_outputs(stage)[0]));
	}
	assert_int_equal(n, count(p->steps));
	assert_ptr_equal(ts_pipeline_steps(p), ts_pipeline_steps(p));
}

static void each_margin_stands_behind_its_stage(void **state)
{
	(void)state;
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) check(*at);
}

/* The margin of each stage is one, of no other stage, and has none itself; no stage that is called a margin is left
 * out. */
static void each_margin_belongs_to_one_stage(void **state)
{
	(void)state;
	for (const ts_stage *const *at = ts_stages(); *at != NULL; at++) {
		const ts_stage *s = *at;
		size_t n = strlen(s->name);
		bool called = n > 6 && strcmp(s->name + n - 6, "margin") == 0;
		u32 owners = 0;
		for (const ts_stage *const *of = ts_stages(); *of != NULL; of++) owners += ts_stage_margin(*of) == s;
		assert_int_equal(owners, called);
		if (called) assert_null(ts_stage_margin(s));
	}
}

/* A pipeline that is in no table is taken as it is written. */
static void a_new_pipeline_keeps_its_steps(void **state)
{
	(void)state;
	static const ts_step steps[] = {{.stage = "eye"}, {0}};
	const ts_pipeline own = {.name = "own", .steps = steps};
	assert_ptr_equal(ts_pipeline_steps(&own), steps);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_margin_stands_behind_its_stage),
		cmocka_unit_test(each_margin_belongs_to_one_stage),
		cmocka_unit_test(a_new_pipeline_keeps_its_steps),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
