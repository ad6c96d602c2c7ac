/* Shared libraries: what is absent is told from what does not open, and from want of memory; and their calls. */
#include <dlfcn.h>
#include <string.h>
#include <sys/resource.h>
#include "model/core.h"
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

static void what_is_absent_is_told_from_what_does_not_open(void **state)
{
	void *library;
	(void)state;
	assert_int_equal(ts_library_open(&library, "libm.so.6", RTLD_NOW | RTLD_LOCAL), TS_OK);
	dlclose(library);
	assert_int_equal(ts_library_open(&library, "libno_such.so.9", RTLD_NOW | RTLD_LOCAL), TS_SKIPPED);
	assert_int_equal(ts_error_kind(), TS_KIND_LIBRARY);
	assert_non_null(strstr(ts_error_message(), "libno_such.so.9"));
	assert_int_equal(ts_library_open(&library, "/etc/passwd", RTLD_NOW | RTLD_LOCAL), TS_ERROR);
	assert_int_equal(ts_error_kind(), TS_KIND_LIBRARY);
	assert_non_null(strstr(ts_error_message(), "/etc/passwd"));
}

static void no_library_opens_without_memory(void **state)
{
	struct rlimit usual, none;
	void *library;
	(void)state;
	if (TS_TEST_SANITIZED) skip();
	assert_int_equal(getrlimit(RLIMIT_AS, &usual), 0);
	none = (struct rlimit){1, usual.rlim_max};
	assert_int_equal(setrlimit(RLIMIT_AS, &none), 0);
	ts_status status = ts_library_open(&library, "libnsl.so.1", RTLD_NOW | RTLD_LOCAL);
	assert_int_equal(setrlimit(RLIMIT_AS, &usual), 0);
	assert_int_equal(status, TS_ERROR);
	assert_int_equal(ts_error_kind(), TS_KIND_MEMORY);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(what_is_absent_is_told_from_what_does_not_open),
		cmocka_unit_test(no_library_opens_without_memory),
		cmocka_unit_test(all_calls_are_found),
		cmocka_unit_test(a_missing_call_leaves_the_table),
	};
	return cmocka_run_group_tests_name("library", tests, NULL, NULL);
}
