/* What the papers show: each claim is asked by a table of `bench` that can be run in brief, or says why it cannot be
 * asked, and none is there twice. Causes have classes. */
#include <string.h>
#include "study/bench_paper.h"
#include "study/claims.h"
#include "tests/model/test.h"
#include "tools/tools.h"

static const ts_bench_row *bench_of(const ts_claim *claim)
{
	const ts_bench_row *const *row = ts_benches();
	while (*row != NULL && strcmp((*row)->name, claim->bench) != 0) row++;
	return *row;
}

/* Each beginning is that of some relation's text. */
static void check_rows(const ts_claim *claim, const ts_paper_table *table)
{
	for (const char *begin = claim->rows; begin != NULL; begin = strchr(begin, '|')) {
		begin += begin != claim->rows;
		const ts_paper_relation *r = table->relations;
		while (r->text != NULL && strncmp(r->text, begin, strcspn(begin, "|")) != 0) r++;
		if (r->text == NULL)
			fail_msg("%s, %s: no row of %s begins with %s", claim->paper, claim->place, table->name, begin);
	}
}

static void check(const ts_claim *claim)
{
	if (claim->shows[0] == 0) fail_msg("%s, %s: shows nothing", claim->paper, claim->place);
	if ((claim->bench != NULL) == (claim->cannot != NULL))
		fail_msg("%s, %s: asked or not?", claim->paper, claim->place);
	if (claim->bench == NULL) return;
	const ts_bench_row *row = bench_of(claim);
	if (row == NULL) fail_msg("%s, %s: no table %s", claim->paper, claim->place, claim->bench);
	if (row->brief == NULL) fail_msg("%s: no options to be run in brief", row->name);
	if (row->paper != NULL) check_rows(claim, row->paper);
}

static void each_claim_is_asked_or_excused(void **state)
{
	(void)state;
	u32 n = 0;
	for (const ts_claim *const *list = ts_claims(); *list != NULL; list++) {
		for (const ts_claim *claim = *list; claim->paper != NULL; claim++, n++) {
			check(claim);
			for (const ts_claim *other = *list; other < claim; other++) {
				if (strcmp(other->paper, claim->paper) == 0) assert_string_not_equal(other->place, claim->place);
			}
		}
	}
	assert_true(n > 50);
}

/* Tables that measure a paper's are asked by some claim. */
static void each_table_of_a_paper_is_asked(void **state)
{
	(void)state;
	for (const ts_bench_row *const *row = ts_benches(); *row != NULL; row++) {
		bool asks = (*row)->brief == NULL;
		for (const ts_claim *const *list = ts_claims(); *list != NULL; list++) {
			for (const ts_claim *claim = *list; claim->paper != NULL; claim++)
				asks |= claim->bench != NULL && strcmp(claim->bench, (*row)->name) == 0;
		}
		if (!asks) fail_msg("%s: no claim asks it", (*row)->name);
		if ((*row)->paper != NULL && (*row)->brief == NULL) fail_msg("%s: no options to be run in brief", (*row)->name);
	}
}

/* Whose fault it is where a claim does not hold. */
static void each_cause_has_a_class(void **state)
{
	(void)state;
	u32 n = 0;
	for (const ts_bench_row *const *row = ts_benches(); *row != NULL; row++) {
		if ((*row)->paper == NULL) continue;
		n++;
		for (const ts_paper_relation *r = (*row)->paper->relations; r->text != NULL; r++)
			if (!ts_bench_has_class(r->because))
				fail_msg("%s, %s: no class of cause: %s", (*row)->name, r->text, r->because);
	}
	assert_true(n > 0);
}

int main(void)
{
	ts_tools_begin();
	const struct CMUnitTest tests[] = {cmocka_unit_test(each_claim_is_asked_or_excused),
	                                   cmocka_unit_test(each_table_of_a_paper_is_asked),
	                                   cmocka_unit_test(each_cause_has_a_class)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
