/* Which methods are named: all of an effect, or those listed, in that order and each once. */
#include "study/asked/methods.h"
#include "tests/status.h"

static u32 found(const ts_pipeline *methods[TS_MAX_METHODS], const char *effect, const char *names)
{
	u32 n;
	if (ts_methods_find(methods, &n, effect, names) != TS_OK) fail_msg("%s", ts_error_message());
	return n;
}

static void refuses(const char *effect, const char *names, const char *words)
{
	const ts_pipeline *methods[TS_MAX_METHODS];
	u32 n;
	refused(ts_methods_find(methods, &n, effect, names), words);
}

/* "all" has every method of the effect, nothing said those that need not be named. */
static void all_names_every_method_of_an_effect(void **state)
{
	(void)state;
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		const char *effect = (*at)->effect->name;
		const ts_pipeline *all[TS_MAX_METHODS], *usual[TS_MAX_METHODS], *own[TS_MAX_METHODS];
		u32 n_all = found(all, effect, "all"), n_usual = found(usual, effect, NULL), n = 0;
		for (u32 i = 0; i < n_all; i++) {
			assert_string_equal(all[i]->effect->name, effect);
			if (!all[i]->only_named) assert_ptr_equal(usual[n++], all[i]);
		}
		assert_int_equal(n, n_usual);
		assert_int_equal(found(own, effect, (*at)->name), 1);
		assert_ptr_equal(own[0], *at);
	}
}

static void named_methods_come_once_in_order(void **state)
{
	(void)state;
	const ts_pipeline *methods[TS_MAX_METHODS];
	assert_int_equal(found(methods, "reflections", "mvr,epr,mvr"), 2);
	assert_string_equal(methods[0]->name, "mvr");
	assert_string_equal(methods[1]->name, "epr");
}

static void unknown_methods_are_refused_by_the_nearest(void **state)
{
	(void)state;
	refuses("reflection", NULL, "no effect \"reflection\"; the nearest is reflections");
	refuses("nothing-like-it", "epr", "no effect \"nothing-like-it\"");
	refuses("reflections", "epr,mvrr", "--method: no method \"mvrr\" of reflections; the nearest is mvr");
}

/* Shadows are shown without mirrors, unless some were said. */
static void shadows_are_shown_without_mirrors(void **state)
{
	(void)state;
	static const struct {
		const char *effect;
		bool said, keeps;
	} cases[] = {{"reflections", false, true}, {"soft-shadows", false, false}, {"soft-shadows", true, true}};
	for (u32 i = 0; i < 3; i++) {
		ts_job job = {.mirrored = cases[i].said};
		ts_params_default(&job.params);
		TS_PARAM_SET(&job.params, reflectors_count, 5);
		ts_effect_params(&job, cases[i].effect);
		assert_int_equal(TS_PARAM(&job.params, reflectors_count), cases[i].keeps ? 5 : 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(all_names_every_method_of_an_effect),
	                                   cmocka_unit_test(named_methods_come_once_in_order),
	                                   cmocka_unit_test(unknown_methods_are_refused_by_the_nearest),
	                                   cmocka_unit_test(shadows_are_shown_without_mirrors)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
