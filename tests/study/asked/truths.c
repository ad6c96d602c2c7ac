/* The table of truths: every row can be made, in one way, of effects that there are. Truths are named by their names,
 * in any case, each of its effect alone. */
#include <ctype.h>
#include "study/asked/truths.h"
#include "study/bench.h"
#include "tests/model/test.h"
#include "tests/status.h"

static bool has_effect(const ts_truth_kind *kind, const char *effect)
{
	char text[128], *rest = NULL;
	strncpy(text, kind->effects, sizeof text - 1);
	text[sizeof text - 1] = 0;
	for (char *word = strtok_r(text, " ", &rest); word != NULL; word = strtok_r(NULL, " ", &rest)) {
		if (strcmp(word, effect) == 0) return true;
	}
	return false;
}

static void each_truth_has_a_name_of_letters(void **state)
{
	(void)state;
	for (const ts_truth_kind *const *row = ts_truths(); *row != NULL; row++) {
		const ts_truth_kind *a = *row;
		assert_true(strlen(a->name) < 16 && strcmp(a->name, "none") != 0);
		for (const char *c = a->name; *c != 0; c++) assert_true(isalpha((unsigned char)*c));
		for (const ts_truth_kind *const *b = ts_truths(); b < row; b++) assert_string_not_equal(a->name, (*b)->name);
	}
}

/* One of the three ways of table.h, and a stage that shows what is traced. */
static void each_truth_is_made_in_one_way(void **state)
{
	(void)state;
	for (const ts_truth_kind *const *row = ts_truths(); *row != NULL; row++) {
		const ts_truth_kind *kind = *row;
		assert_int_equal((kind->needs != NULL) + (kind->begin != NULL) + (kind->radiance != NULL), 1);
		assert_int_equal(kind->trace != NULL, kind->radiance == NULL);
		assert_int_equal(kind->image != NULL, kind->trace != NULL);
		assert_int_equal(kind->exists != NULL, kind->why_not != NULL);
		if (kind->image != NULL) assert_true(ts_stage_writes(ts_stage_find(kind->image), TS_B_image_srgb));
	}
}

static void each_truth_is_of_effects_there_are(void **state)
{
	(void)state;
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		const ts_pipeline *p = *at;
		u32 n = 0;
		for (const ts_truth_kind *const *row = ts_truths(); *row != NULL; row++) n += has_effect(*row, p->effect->name);
		assert_true(n > 0);
	}
	for (const ts_truth_kind *const *row = ts_truths(); *row != NULL; row++) {
		const ts_truth_kind *kind = *row;
		size_t named = 1;
		for (const char *c = kind->effects; *c != 0; c++) named += *c == ' ';
		for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
			const ts_pipeline *p = *at;
			bool first = at == ts_pipelines() || p->effect != at[-1]->effect;
			if (first && has_effect(kind, p->effect->name)) named--;
		}
		assert_int_equal(named, 0);
	}
}

static void each_truth_is_against_a_similar_one(void **state)
{
	(void)state;
	for (const ts_truth_kind *const *row = ts_truths(); *row != NULL; row++) {
		const ts_truth_kind *kind = *row;
		const ts_truth_kind *const *other = ts_truths();
		if (kind->against[0] == 0) continue;
		while (*other != NULL && strcmp((*other)->name, kind->against) != 0) other++;
		assert_non_null(*other);
		assert_string_equal((*other)->effects, kind->effects);
	}
}

/* What truths of reflections start from is EPR's, or that of its variants, whichever methods run before it. */
static void truths_of_reflections_start_from_epr(void **state)
{
	(void)state;
	u32 n = 0;
	for (const ts_truth_kind *const *row = ts_truths(); *row != NULL; row++) {
		const ts_truth_kind *kind = *row;
		u32 n_methods = 0;
		for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
			const ts_pipeline *p = *at;
			if (!has_effect(kind, p->effect->name) || !ts_truth_starts_from(kind, p)) continue;
			assert_memory_equal(p->name, "epr", 3);
			n_methods += strcmp(p->name, "epr") == 0;
		}
		assert_int_equal(n_methods, kind->needs != NULL);
		n += n_methods;
	}
	assert_int_equal(n, 2);
}

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
		cmocka_unit_test(each_truth_has_a_name_of_letters),     cmocka_unit_test(each_truth_is_made_in_one_way),
		cmocka_unit_test(each_truth_is_of_effects_there_are),   cmocka_unit_test(each_truth_is_against_a_similar_one),
		cmocka_unit_test(truths_of_reflections_start_from_epr), cmocka_unit_test(truths_of_an_effect_are_listed),
		cmocka_unit_test(every_truth_has_its_own_bit),          cmocka_unit_test(truths_of_other_effects_are_refused),
		cmocka_unit_test(one_truth_is_compared_with),           cmocka_unit_test(the_median_is_in_the_middle)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
