/* JSON: what is read is what jansson reads; memory that ends anywhere is told from text that is wrong; and what is
 * wrong has its place. */
#include <errno.h>
#include "kernels/base/num.h"
#include "model/core.h"
#include "model/json/read.h"
#include "tests/model/test.h"

static const char text[] = "{\"names\": [\"a\", \"b\\u00e9\"], \"deep\": {\"x\": [1, 2.5, -3e9, true, null]},\n"
						   "\"long\": \"0123456789012345678901234567890123456789012345678901234567890123456789\"}";

static unsigned left;

/* As malloc, of which the call after `left` ones fails. */
static void *scarce(size_t n)
{
	if (left-- != 0) return malloc(n);
	left = 0;
	errno = ENOMEM;
	return NULL;
}

static json_t *load(const char *from) { return ts_json_read(from, strlen(from), false, "file"); }

static void memory_that_ends_is_no_fault_of_the_text(void **state)
{
	(void)state;
	json_t *root = NULL;
	unsigned n = 0;
	json_set_alloc_funcs(scarce, free);
	for (; root == NULL; n++) {
		left = n;
		root = load(text);
		if (root != NULL) break;
		assert_string_equal(ts_error_message(), "file: out of memory");
		assert_int_equal(ts_error_kind(), TS_KIND_MEMORY);
	}
	assert_true(n > 20);
	left = 1000;
	json_t *whole = json_loads(text, 0, NULL);
	assert_true(json_equal(root, whole));
	json_decref(root);
	json_decref(whole);
	json_set_alloc_funcs(malloc, free);
}

static void refuses(const char *wrong, const char *words)
{
	assert_null(load(wrong));
	if (strstr(ts_error_message(), words) == NULL) fail_msg("\"%s\": %s", wrong, ts_error_message());
	assert_int_not_equal(ts_error_kind(), TS_KIND_MEMORY);
}

/* Every cut of the text, and what is wrong in it. */
static void wrong_text_has_a_place(void **state)
{
	(void)state;
	char cut[sizeof text], deep[TS_JSON_DEPTH + 2];
	for (size_t n = 0; n + 1 < sizeof text; n++) {
		memcpy(cut, text, n);
		cut[n] = 0;
		refuses(cut, "; JSON is expected");
	}
	refuses("<html>", "line 1, column 1: no value");
	refuses("{\"x\": 1e999}", "too large a number");
	refuses("[9223372036854775808]", "too large an integer");
	refuses("{\"x\": 1,\n \"x\": 2}", "line 2, column 5: a duplicate name");
	refuses("{x: 1}", "line 1, column 2: a name in quotes is missing");
	refuses("[1] 2", "line 1, column 5: more than one value");
	refuses("[01]", "column 3: ',' or ']' is missing");
	refuses("[\"\\ud800\"]", "no such escape");
	refuses("[\"\\u0000\"]", "no such escape");
	refuses("[\"\xff\"]", "not UTF-8");
	refuses("{\"\xff\": 1}", "not UTF-8");
	refuses("[\"\n\"]", "column 3: a control character");
	memset(deep, '[', sizeof deep - 1);
	deep[sizeof deep - 1] = 0;
	refuses(deep, "nested more than 64 deep");
	json_t *zero = ts_json_read("[\"a\\u0000b\"]", 12, true, "file");
	assert_int_equal(json_string_length(json_array_get(zero, 0)), 3);
	json_decref(zero);
}

/* Damages a text in some places, by what JSON is made of. */
static void damage(char *to, size_t n, u32 seed)
{
	static const char *const parts[] = {"\"",
	                                    "\\",
	                                    "\\u0041",
	                                    "\\ud83d\\ude00",
	                                    "\\ud800",
	                                    "{",
	                                    "}",
	                                    "[",
	                                    "]",
	                                    ",",
	                                    ":",
	                                    "-",
	                                    "0",
	                                    "1e5",
	                                    "1.5",
	                                    "-0",
	                                    ".",
	                                    "E+",
	                                    "true",
	                                    "null",
	                                    " ",
	                                    "\n",
	                                    "\xc3\xa9",
	                                    "\xff",
	                                    "\x01",
	                                    "/",
	                                    "\\/",
	                                    "1e-400",
	                                    "123456789012345678901"};
	enum { PARTS = sizeof parts / sizeof *parts };
	for (u32 i = 0; i < 1 + ts_random(seed, 0, 7) % 3; i++) {
		const char *part = parts[ts_random(seed, 1 + 2 * i, 7) % PARTS];
		size_t at = ts_random(seed, 2 + 2 * i, 7) % (n - strlen(part));
		memcpy(to + at, part, strlen(part));
	}
}

static void what_is_read_is_what_jansson_reads(void **state)
{
	enum { CASES = 40000 };
	(void)state;
	u32 good = 0;
	for (u32 seed = 0; seed < CASES; seed++) {
		char damaged[sizeof text];
		memcpy(damaged, text, sizeof text);
		damage(damaged, sizeof text - 1, seed);
		bool zeros = seed % 2 == 0;
		size_t flags = JSON_REJECT_DUPLICATES | JSON_DECODE_ANY | (zeros ? JSON_ALLOW_NUL : 0);
		json_t *theirs = json_loadb(damaged, sizeof text - 1, flags, NULL);
		json_t *ours = ts_json_read(damaged, sizeof text - 1, zeros, "file");
		bool same = theirs == NULL ? ours == NULL : json_equal(theirs, ours);
		if (!same) fail_msg("case %u: %s", (unsigned)seed, damaged);
		good += ours != NULL;
		json_decref(theirs);
		json_decref(ours);
	}
	assert_true(good > CASES / 50 && good < CASES / 2);
}

int main(void)
{
	const struct CMUnitTest json[] = {
		cmocka_unit_test(memory_that_ends_is_no_fault_of_the_text),
		cmocka_unit_test(wrong_text_has_a_place),
		cmocka_unit_test(what_is_read_is_what_jansson_reads),
	};
	return cmocka_run_group_tests(json, NULL, NULL);
}
