/* The table of truths: every row can be made, in one way, of effects that there are. */
#include <ctype.h>
#include "study/asked/truths.h"
#include "tests/model/test.h"

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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_truth_has_a_name_of_letters), cmocka_unit_test(each_truth_is_made_in_one_way),
		cmocka_unit_test(each_truth_is_of_effects_there_are), cmocka_unit_test(each_truth_is_against_a_similar_one),
		cmocka_unit_test(truths_of_reflections_start_from_epr)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
