/* Which truths are named: each by its name, in any case, of its effect alone. */
#include "study/asked/truths.h"
#include "study/bench.h"
#include "tests/status.h"

static void assert_list(const char *effect, const char *last, const char *right)
{
	char text[256];
	ts_truths_list(text, sizeof text, effect, last);
	assert_string_equal(text, right);
}

static void truths_of_an_effect_are_listed(void **state)
{
	(void)state;
	assert_list("reflections", " and ", "A, B and C");
	assert_list("soft-shadows", " or ", "samples or area");
	assert_list("particles", ", ", "glow");
	assert_list("nothing", ", ", "");
}

static u32 found(const char *effect, const char *names)
{
	u32 truths = 0;
	assert_int_equal(ts_truths_find(&truths, effect, names), TS_OK);
	return truths;
}

/* Every truth by its name has its own bit, and all of an effect have those of each. */
static void every_truth_has_its_own_bit(void **state)
{
	(void)state;
	u32 t = 0, all = 0;
	for (; ts_truths()[t] != NULL; t++) {
		const ts_truth_kind *kind = ts_truths()[t];
		char effect[64], lower[32];
		snprintf(effect, sizeof effect, "%s", kind->effects);
		effect[strcspn(effect, " ")] = 0;
		for (u32 i = 0; i <= strlen(kind->name); i++)
			lower[i] = (char)(kind->name[i] | (kind->name[i] >= 'A' ? 32 : 0));
		assert_int_equal(ts_truth_bit(kind), 1u << t);
		assert_int_equal(found(effect, lower), 1u << t);
		assert_true((found(effect, NULL) & 1u << t) != 0 && found(effect, "all") == found(effect, NULL));
		assert_ptr_equal(ts_truths_one(kind->name, effect), kind);
		all |= 1u << t;
	}
	assert_int_equal(all, (1u << t) - 1);
	assert_int_equal(found("reflections", "none"), 0);
	assert_int_equal(found("reflections", "a,C"), found("reflections", "A") | found("reflections", "C"));
}

static void truths_of_other_effects_are_refused(void **state)
{
	(void)state;
	u32 truths;
	assert_int_equal(ts_truths_find(&truths, "reflections", "A,area"), TS_ERROR);
	says("--truth area: no truth of reflections; there are A, B and C, or none");
	assert_int_equal(ts_truths_find(&truths, "particles", "A"), TS_ERROR);
	says("there is glow, or none");
	assert_true(ts_truths_named("a,glow") && !ts_truths_named("a,epr") && !ts_truths_named(""));
}

/* The one truth that a table compares with: what was typed, or else its own. */
static void one_truth_is_compared_with(void **state)
{
	(void)state;
	const ts_truth_kind *judge = NULL;
	ts_job job = {.judged = false};
	assert_int_equal(ts_bench_truth(&judge, &job, "reflections", "B"), TS_OK);
	assert_ptr_equal(judge, ts_truths_one("B", "reflections"));
	job.judged = true;
	job.truth = "c";
	assert_int_equal(ts_bench_truth(&judge, &job, "reflections", "B"), TS_OK);
	assert_ptr_equal(judge, ts_truths_one("C", "reflections"));
	job.truth = "none";
	assert_int_equal(ts_bench_truth(&judge, &job, "reflections", "B"), TS_OK);
	assert_null(judge);
	job.truth = NULL;
	assert_int_equal(ts_bench_truth(&judge, &job, "reflections", "B"), TS_ERROR);
	says("one truth is compared with, not several; write --truth=A, B, C or none");
	job.truth = "glow";
	assert_int_equal(ts_bench_truth(&judge, &job, "reflections", "B"), TS_ERROR);
}

static void the_median_is_in_the_middle(void **state)
{
	(void)state;
	double odd[] = {5, 1, 4, 4, 9}, even[] = {8, 2, 3, 7}, one[] = {6};
	assert_true(ts_median(odd, 5) == 4 && ts_median(even, 4) == 5 && ts_median(one, 1) == 6);
	assert_true(odd[0] == 1 && odd[4] == 9);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(truths_of_an_effect_are_listed), cmocka_unit_test(every_truth_has_its_own_bit),
		cmocka_unit_test(truths_of_other_effects_are_refused), cmocka_unit_test(one_truth_is_compared_with),
		cmocka_unit_test(the_median_is_in_the_middle)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
