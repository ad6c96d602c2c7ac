/* Expressions: what is read has the value of the tree that was written, growth is a power's exponent, and what is
 * wrong is found where it stands. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "study/expression.h"
#include "tests/model/test.h"

enum { MEASURED = 4, FIGURES = 3, TERMS = 64, ROUNDS = 20000 };

/* m0 to m3 are measured, f0 to f2 figures of the table. */
static ts_status name(void *user, const char *text, size_t n, ts_term *term)
{
	(void)user;
	if (n != 2 || (text[0] != 'm' && text[0] != 'f')) return ts_fail("no name %.*s", (int)n, text);
	*term = (ts_term){.kind = text[0] == 'm' ? TS_TERM_MEASURED : TS_TERM_FIGURE, .at = (u32)(text[1] - '0')};
	return TS_OK;
}

static double value_of(const char *text, const ts_expression_values *values)
{
	ts_term terms[TERMS];
	u32 n = TERMS;
	const char *at;
	if (ts_expression_read(terms, &n, text, &at, name, NULL) != TS_OK) fail_msg("%s: %s", text, ts_error_message());
	return ts_expression_value(terms, n, values);
}

static const double measured[MEASURED] = {3, 0.25, -7, 1000}, figures[FIGURES] = {5, 0, 2.5};
static const ts_expression_values all = {measured, figures, NULL};

/* Writes a tree behind `text` and returns its value; an operator of lower rank within one of higher has brackets. */
static double write_tree(char *text, u32 depth, u32 rank)
{
	double a, b;
	char *end = text + strlen(text);
	if (depth == 0 || rand() % 4 == 0) {
		u32 kind = (u32)rand() % 3, i = (u32)rand() % FIGURES;
		if (kind == 0) snprintf(end, 8, "m%u", (unsigned)i);
		if (kind == 1) snprintf(end, 8, " f%u", (unsigned)i);
		if (kind == 2) snprintf(end, 8, "%u.5 ", (unsigned)i);
		return kind == 0 ? measured[i] : kind == 1 ? figures[i] : i + 0.5;
	}
	u32 op = (u32)rand() % 4, own = op / 2;
	bool brackets = own < rank || rand() % 8 == 0;
	if (brackets) strcat(text, "(");
	a = write_tree(text, depth - 1, own);
	strcat(text, (const char *const[]){"+", " - ", "*", " /"}[op]);
	b = write_tree(text, depth - 1, own + 1);
	if (brackets) strcat(text, ")");
	return op == 0 ? a + b : op == 1 ? a - b : op == 2 ? a * b : b != 0 ? a / b : NAN;
}

static void what_is_read_has_the_value_of_what_was_written(void **state)
{
	(void)state;
	srand(62);
	for (u32 i = 0; i < ROUNDS; i++) {
		char text[2000] = "";
		double right = write_tree(text, 4, 0), found = value_of(text, &all);
		if (memcmp(&right, &found, sizeof right) != 0 && !(isnan(right) && isnan(found)))
			fail_msg("%s: %g, not %g", text, found, right);
	}
}

static void growth_is_the_exponent_of_a_power(void **state)
{
	(void)state;
	for (double e = -2; e <= 3; e += 0.5) {
		const double before[FIGURES] = {3 * pow(5, e), 5}, now[FIGURES] = {3 * pow(40, e), 40};
		assert_float_equal(value_of("growth(f0, f1)", &(ts_expression_values){NULL, now, before}), e, 1e-9);
		assert_true(isnan(value_of("growth(f0, f1)", &(ts_expression_values){NULL, now, now})));
		assert_true(isnan(value_of("1 + growth(f0,f1)", &(ts_expression_values){NULL, now, NULL})));
	}
}

static void what_is_wrong_is_found_where_it_stands(void **state)
{
	(void)state;
	static const struct {
		const char *text;
		size_t at;
		const char *says;
	} bad[] = {
		{"", 0, "a figure is missing"},
		{"m0 +", 4, "a figure is missing"},
		{"m0 + * m1", 5, "no figure"},
		{"(m0 + m1", 8, "')' is missing"},
		{"m0)", 2, "')' is not expected"},
		{"m0 m1", 3, "'m' is not expected"},
		{"2x", 0, "no number"},
		{"1 + nobody", 4, "no name nobody"},
		{"growth(m0, f1)", 14, "not what is measured"},
		{"growth(f0 f1)", 10, "',' is missing"},
		{"growth f0", 7, "'(' is missing"},
		{"-m0", 0, "no figure"},
		{"m0 \x01", 3, "'?' is not expected"},
	};
	for (u32 i = 0; i < sizeof bad / sizeof *bad; i++) {
		ts_term terms[TERMS];
		u32 n = TERMS;
		const char *at;
		assert_int_equal(ts_expression_read(terms, &n, bad[i].text, &at, name, NULL), TS_ERROR);
		if (at != bad[i].text + bad[i].at || strstr(ts_error_message(), bad[i].says) == NULL)
			fail_msg("\"%s\" at %zu: %s", bad[i].text, (size_t)(at - bad[i].text), ts_error_message());
	}
}

/* Neither brackets nor values nor terms go beyond their room. */
static void what_is_too_long_is_refused(void **state)
{
	(void)state;
	char brackets[200] = "", sums[4 * TERMS] = "m0", nested[400] = "";
	for (u32 i = 0; i < 40; i++) strcat(brackets, "(");
	for (u32 i = 0; i < TERMS / 2; i++) strcat(sums, "+m0");
	for (u32 i = 0; i < TS_EXPRESSION_DEPTH + 1; i++) strcat(nested, "1+2*(");
	const char *const texts[] = {brackets, sums, nested}, *at;
	for (u32 i = 0; i < 3; i++) {
		ts_term terms[TERMS];
		u32 n = TERMS;
		assert_int_equal(ts_expression_read(terms, &n, texts[i], &at, name, NULL), TS_ERROR);
		assert_non_null(strstr(ts_error_message(), "too long"));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(what_is_read_has_the_value_of_what_was_written),
		cmocka_unit_test(growth_is_the_exponent_of_a_power),
		cmocka_unit_test(what_is_wrong_is_found_where_it_stands),
		cmocka_unit_test(what_is_too_long_is_refused),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
