/* Trees: each kind of node, walked and as JSON. */
#include <errno.h>
#include <jansson.h>
#include "tests/api/api.h"

static void trees_are_walked_by_index_and_name(void **state)
{
	(void)state;
	static const char text[] = "{\"whole\":-7,\"part\":1.5,\"yes\":true,\"no\":false,\"word\":\"a\\\"b\",\"none\":null,"
							   "\"list\":[1,[2]],\"object\":{\"in\":3}}";
	static const ts_tree_kind kinds[] = {TS_TREE_INTEGER, TS_TREE_REAL, TS_TREE_BOOL, TS_TREE_BOOL,
	                                     TS_TREE_TEXT,    TS_TREE_NULL, TS_TREE_LIST, TS_TREE_OBJECT};
	ts_tree *root = (ts_tree *)json_loads(text, 0, NULL);
	assert_int_equal(ts_tree_kind_of(root), TS_TREE_OBJECT);
	assert_int_equal(ts_tree_n(root), 8);
	for (size_t i = 0; i < 8; i++) {
		assert_int_equal(ts_tree_kind_of(ts_tree_at(root, i)), kinds[i]);
		assert_ptr_equal(ts_tree_get(root, ts_tree_name(root, i)), ts_tree_at(root, i));
	}
	assert_null(ts_tree_at(root, 8));
	assert_null(ts_tree_name(root, 8));
	assert_null(ts_tree_get(root, "other"));
	assert_int_equal(ts_tree_integer(ts_tree_get(root, "whole")), -7);
	assert_true(ts_tree_real(ts_tree_get(root, "whole")) == -7);
	assert_true(ts_tree_real(ts_tree_get(root, "part")) == 1.5);
	assert_int_equal(ts_tree_integer(ts_tree_get(root, "part")), 0);
	assert_int_equal(ts_tree_integer(ts_tree_get(root, "yes")), 1);
	assert_int_equal(ts_tree_integer(ts_tree_get(root, "no")), 0);
	assert_string_equal(ts_tree_text(ts_tree_get(root, "word")), "a\"b");
	assert_null(ts_tree_text(ts_tree_get(root, "whole")));
	const ts_tree *list = ts_tree_get(root, "list");
	assert_int_equal(ts_tree_n(list), 2);
	assert_null(ts_tree_name(list, 0));
	assert_null(ts_tree_get(list, "in"));
	assert_int_equal(ts_tree_integer(ts_tree_at(ts_tree_at(list, 1), 0)), 2);
	char *json = ts_tree_json(root);
	assert_string_equal(json, text);
	free(json);
	ts_tree_free(root);
}

static long left = -1; /* allocations of jansson until one fails; below 0: none does */

static void *allocate(size_t bytes)
{
	if (left < 0 || left-- > 0) return malloc(bytes);
	errno = ENOMEM;
	return NULL;
}

static void without_memory_there_is_no_json(void **state)
{
	(void)state;
	ts_tree *root = (ts_tree *)json_pack("{s:i,s:{s:s}}", "first", 1, "second", "third", "text");
	char *json = NULL;
	long n = 0;
	json_set_alloc_funcs(allocate, free);
	for (; json == NULL; n++) {
		left = n;
		json = ts_tree_json(root);
		left = -1;
		if (json == NULL) assert_non_null(strstr(ts_error_message(), "memory"));
	}
	json_set_alloc_funcs(malloc, free);
	assert_string_equal(json, "{\"first\":1,\"second\":{\"third\":\"text\"}}");
	assert_true(n > 1);
	free(json);
	ts_tree_free(root);
	assert_null(ts_tree_json(NULL));
	assert_non_null(strstr(ts_error_message(), "node"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(trees_are_walked_by_index_and_name),
	                                   cmocka_unit_test(without_memory_there_is_no_json)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
