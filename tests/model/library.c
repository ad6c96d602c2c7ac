/* Calls of shared libraries. */
#include <dlfcn.h>
#include <string.h>
#include "model/library.h"
#include "tests/model/test.h"

static void all_calls_are_found(void **state)
{
	static const char *const names[] = {"cosf", "sinf"};
	struct {
		float (*of[2])(float);
	} calls;
	(void)state;
	void *library = dlopen("libm.so.6", RTLD_NOW | RTLD_LOCAL);
	assert_non_null(library);
	assert_true(ts_library_find(&calls, names, 2, library));
	assert_true(calls.of[0](0.0f) > 0.5f && calls.of[1](0.0f) < 0.5f);
	dlclose(library);
}

static void a_missing_call_leaves_the_table(void **state)
{
	static const char *const names[] = {"cosf", "no_such_call"};
	unsigned char calls[2 * sizeof(ts_call)], before[sizeof calls];
	(void)state;
	void *library = dlopen("libm.so.6", RTLD_NOW | RTLD_LOCAL);
	assert_non_null(library);
	memset(calls, 0xa5, sizeof calls);
	memcpy(before, calls, sizeof calls);
	assert_false(ts_library_find(calls, names, 2, library));
	assert_memory_equal(calls, before, sizeof calls);
	dlclose(library);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(all_calls_are_found),
		cmocka_unit_test(a_missing_call_leaves_the_table),
	};
	return cmocka_run_group_tests_name("library", tests, NULL, NULL);
}
