/* JSON: memory that ends anywhere while it is read is told from text that is wrong. */
#include "model/json.h"
#include "tests/model/test.h"

static const char text[] = "{\"names\": [\"a\", \"b\\u00e9\"], \"deep\": {\"x\": [1, 2.5, -3e9, true, null]}, "
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

static json_t *load(const char *from, json_error_t *error)
{
	errno = 0;
	return json_loadb(from, strlen(from), JSON_REJECT_DUPLICATES, error);
}

static void memory_that_ends_is_no_fault_of_the_text(void **state)
{
	(void)state;
	json_t *root = NULL;
	unsigned n = 0;
	json_set_alloc_funcs(scarce, free);
	for (; root == NULL; n++) {
		json_error_t error;
		char why[TS_JSON_WHY];
		left = n;
		root = load(text, &error);
		if (root == NULL) assert_string_equal(ts_json_why(why, &error), "out of memory");
	}
	json_decref(root);
	json_set_alloc_funcs(malloc, free);
	assert_true(n > 20);
}

/* Every cut of the text, and a wrong number, are faults of the text. */
static void wrong_text_has_a_place(void **state)
{
	(void)state;
	json_error_t error;
	char why[TS_JSON_WHY], cut[sizeof text];
	for (size_t n = 0; n + 1 < sizeof text; n++) {
		memcpy(cut, text, n);
		cut[n] = 0;
		assert_null(load(cut, &error));
		assert_false(ts_json_no_memory(&error));
		assert_non_null(strstr(ts_json_why(why, &error), "line 1, column "));
	}
	assert_null(load("{\"x\": 1e999}", &error));
	assert_non_null(strstr(ts_json_why(why, &error), "real number overflow"));
}

int main(void)
{
	const struct CMUnitTest json[] = {
		cmocka_unit_test(memory_that_ends_is_no_fault_of_the_text),
		cmocka_unit_test(wrong_text_has_a_place),
	};
	return cmocka_run_group_tests(json, NULL, NULL);
}
