/* The kinds of backends: each by its name, and a device that is not there leaves none. */
#include "backends/backend.h"
#include "tests/model/test.h"

static void each_kind_is_found_by_its_name(void **state)
{
	(void)state;
	const ts_backend_kind *kind;
	u32 n = 0;
	for (; ts_backend_kinds[n] != NULL; n++) {
		assert_int_equal(ts_backend_find(&kind, ts_backend_kinds, ts_backend_kinds[n]->name), TS_OK);
		assert_ptr_equal(kind, ts_backend_kinds[n]);
	}
	assert_ptr_equal(ts_backend_kinds[0], &ts_c_kind);
	assert_null(ts_c_kind.open);
	assert_int_equal(ts_backend_find(&kind, ts_backend_kinds, "abacus"), TS_ERROR);
	for (u32 i = 0; i < n; i++) assert_non_null(strstr(ts_error_message(), ts_backend_kinds[i]->name));
}

static void an_absent_device_leaves_none(void **state)
{
	(void)state;
	for (u32 i = 1; ts_backend_kinds[i] != NULL; i++) {
		ts_backend other = {.name = "other"}, *backend = &other;
		const ts_backend_options options = {.device = 100000, .build = ""};
		ts_device devices[TS_MAX_DEVICES];
		u32 n;
		bool none = ts_backend_kinds[i]->devices(devices, &n) == TS_SKIPPED;
		assert_true(none == (n == 0));
		assert_int_equal(ts_backend_kinds[i]->open(&backend, &options), none ? TS_SKIPPED : TS_ERROR);
		assert_null(backend);
		if (!none) assert_non_null(strstr(ts_error_message(), "device 100000: there "));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(each_kind_is_found_by_its_name),
	                                   cmocka_unit_test(an_absent_device_leaves_none)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
