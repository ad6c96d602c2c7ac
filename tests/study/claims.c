/* What the papers show: each claim is asked by a table of `bench` that can be run in brief, or says why it cannot be
 * asked, and none is there twice. Causes have classes. */
#include <string.h>
#include "study/tables/paper.h"
#include "study/tables/tables.h"
#include "tests/model/test.h"
#include "tools/tools.h"

static ts_tables *tables;

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
	const ts_bench_row *row;
	if (ts_tables_find(&row, tables, claim->bench) != TS_OK)
		fail_msg("%s, %s: %s", claim->paper, claim->place, ts_error_message());
	if (row->brief == NULL) fail_msg("%s: no options to be run in brief", row->name);
	if (row->paper != NULL) check_rows(claim, row->paper);
}

static void each_claim_is_asked_or_excused(void **state)
{
	(void)state;
	const ts_claim *claim, *other;
	u32 n = 0;
	for (; (claim = ts_tables_claim(tables, n)) != NULL; n++) {
		check(claim);
		for (u32 k = 0; k < n; k++) {
			other = ts_tables_claim(tables, k);
			if (strcmp(other->paper, claim->paper) == 0) assert_string_not_equal(other->place, claim->place);
		}
	}
	assert_true(n > 50);
}

/* Tables that measure a paper's are asked by some claim. */
static void each_table_of_a_paper_is_asked(void **state)
{
	(void)state;
	const ts_bench_row *row;
	const ts_claim *claim;
	for (u32 i = 0; (row = ts_tables_at(tables, i)) != NULL; i++) {
		bool asks = row->brief == NULL;
		for (u32 k = 0; (claim = ts_tables_claim(tables, k)) != NULL; k++)
			asks |= claim->bench != NULL && strcmp(claim->bench, row->name) == 0;
		if (!asks) fail_msg("%s: no claim asks it", row->name);
		if (row->paper != NULL && row->brief == NULL) fail_msg("%s: no options to be run in brief", row->name);
	}
}

/* Whose fault it is where a claim does not hold. */
static void each_cause_has_a_class(void **state)
{
	(void)state;
	const ts_bench_row *row;
	u32 n = 0;
	for (u32 i = 0; (row = ts_tables_at(tables, i)) != NULL; i++) {
		if (row->paper == NULL) continue;
		n++;
		for (const ts_paper_relation *r = row->paper->relations; r->text != NULL; r++)
			if (!ts_bench_has_class(r->because)) fail_msg("%s, %s: no class: %s", row->name, r->text, r->because);
	}
	assert_true(n > 0);
}

int main(void)
{
	ts_tools_begin();
	if (ts_tables_open(&tables) != TS_OK) return 1;
	const struct CMUnitTest tests[] = {cmocka_unit_test(each_claim_is_asked_or_excused),
	                                   cmocka_unit_test(each_table_of_a_paper_is_asked),
	                                   cmocka_unit_test(each_cause_has_a_class)};
	int failed = cmocka_run_group_tests(tests, NULL, NULL);
	ts_tables_close(tables);
	return failed;
}
