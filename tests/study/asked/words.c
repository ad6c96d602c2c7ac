/* "Did you mean": edits against a plain recursion over all alignments, and which names are near. */
#include <string.h>
#include "study/asked/words.h"
#include "tests/model/test.h"

static u32 least(u32 a, u32 b) { return a < b ? a : b; }

/* By the definition: the last letters are equal, or the last edit is one of four. */
static u32 edits(const char *a, size_t na, const char *b, size_t nb)
{
	if (na == 0 || nb == 0) return (u32)(na + nb);
	u32 d = least(edits(a, na - 1, b, nb), edits(a, na, b, nb - 1)) + 1;
	d = least(d, edits(a, na - 1, b, nb - 1) + (a[na - 1] != b[nb - 1]));
	const bool swapped = na > 1 && nb > 1 && a[na - 1] == b[nb - 2] && a[na - 2] == b[nb - 1];
	return swapped ? least(d, edits(a, na - 2, b, nb - 2) + 1) : d;
}

enum { LETTERS = 4 };

/* Word number k, of up to so many letters of as many. Returns their number. */
static u32 word(char text[LETTERS + 1], u32 k)
{
	u32 n = 0;
	for (u32 of = 1; k >= of; of *= LETTERS, n++) k -= of;
	for (u32 i = 0; i < n; i++, k /= LETTERS) text[i] = (char)('a' + k % LETTERS);
	text[n] = 0;
	return n;
}

/* Every word beside every one. */
static void distances_are_those_of_a_recursion(void **state)
{
	(void)state;
	u32 n_words = 0;
	for (u32 n = 0, of = 1; n <= LETTERS; n++, of *= LETTERS) n_words += of;
	for (u32 k = 0; k < n_words * n_words; k++) {
		char a[LETTERS + 1], b[LETTERS + 1];
		const u32 na = word(a, k / n_words), nb = word(b, k % n_words);
		ts_nearest nearest = ts_nearest_begin(a);
		ts_nearest_offer(&nearest, b);
		assert_int_equal(nearest.distance, edits(a, na, b, nb));
	}
}

static const char *hint(const char *typed, const char *name)
{
	static ts_nearest nearest;
	nearest = ts_nearest_begin(typed);
	ts_nearest_offer(&nearest, name);
	return ts_nearest_hint(&nearest, NULL);
}

static void near_names_are_hinted_at(void **state)
{
	(void)state;
	static const char *const near[][2] = {
		{"rendr", "render"}, {"erp", "epr"},  {"widht", "width"},         {"bouncs", "lookup.bounces"},
		{"ad", "add"},       {"A30", "A300"}, {"shadow", "soft-shadows"}, {"plane_dept", "splat.plane_depth"},
	};
	static const char *const far[][2] = {
		{"rho", "fov"}, {"version", "vectors"},         {"", "add"},
		{"x", "y"},     {"splat.plan", "scene.ground"}, {"bench", "epr-1"},
	};
	for (u32 i = 0; i < sizeof near / sizeof *near; i++) assert_string_not_equal(hint(near[i][0], near[i][1]), "");
	for (u32 i = 0; i < sizeof far / sizeof *far; i++) assert_string_equal(hint(far[i][0], far[i][1]), "");
}

/* The text: nearest and list, one of them, or none; nothing of a long name is lost but its end. */
static void a_hint_names_nearest_and_list(void **state)
{
	(void)state;
	ts_nearest nearest = ts_nearest_begin("metod");
	nearest.mark = "--";
	ts_nearest_offer(&nearest, "method");
	assert_string_equal(ts_nearest_hint(&nearest, "touchstone help"),
	                    "; the nearest is --method, and \"touchstone help\" lists all");
	nearest = ts_nearest_begin("rho");
	ts_nearest_offer(&nearest, "fov");
	assert_string_equal(ts_nearest_hint(&nearest, "touchstone list params"), "; \"touchstone list params\" lists all");
	nearest = ts_nearest_begin("rho");
	assert_string_equal(ts_nearest_hint(&nearest, NULL), "");
	char name[300], typed[300];
	memset(name, 'n', 299);
	memset(typed, 'n', 299);
	name[299] = typed[299] = 0;
	nearest = ts_nearest_begin(typed);
	ts_nearest_offer(&nearest, name);
	const char *text = ts_nearest_hint(&nearest, "touchstone list params");
	assert_true(strspn(text + strlen("; the nearest is "), "n") == 64);
	assert_string_equal(text + strlen("; the nearest is ") + 64, ", and \"touchstone list params\" lists all");
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(distances_are_those_of_a_recursion),
	                                   cmocka_unit_test(near_names_are_hinted_at),
	                                   cmocka_unit_test(a_hint_names_nearest_and_list)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
