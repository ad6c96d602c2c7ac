/* Arrays in parts, as on a device that cannot allocate them at once: the same bits. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>
#include <string.h>
#include "../../src/trace/sums.h"

static ts_status sums_of(ts_sums *sums, const char *method, const ts_params *params, const ts_how *how)
{
	ts_scene *scene;
	assert_int_equal(ts_scene_open(&scene, "atrium:triangles=10000", params, NULL), TS_OK);
	ts_status status = ts_sums_of(sums, ts_pipeline_find("reflections", method), scene, params, how);
	ts_scene_free(scene);
	return status;
}

/* Points of 6 MB, texels of 2 MB, in parts of one MiB; with copies, and in the order of arrival without digests. */
static void test_parts(void **state)
{
	(void)state;
	ts_params params;
	ts_params_default(&params);
	params.width = 240;
	params.height = 135;
	params.bounces = 2;
	ts_sums right, found;
	assert_int_equal(sums_of(&right, "epr", &params, &(ts_how){ .threads = 2 }), TS_OK);
	for (u32 copies = 0; copies < 2; copies++) {
		ts_how how = { .threads = 2 };
		ts_backend_options options = { .work_group = 64, .build = "", .copies = copies != 0, .part_bytes = 1 << 20 };
		ts_status status = ts_opencl_kind.open(&how.backend, &options);
		if (status == TS_SKIPPED) {
			const char *require = getenv("TS_REQUIRE");
			assert_false(require != NULL && strstr(require, "opencl") != NULL);
			skip();
		}
		assert_int_equal(status, TS_OK);
		assert_int_equal(sums_of(&found, "epr", &params, &how), TS_OK);
		assert_memory_equal(right.hex, found.hex, sizeof right.hex);
		how.backend->close(how.backend);
	}
}

/* More parts than there may be are refused with one line. */
static void test_too_many(void **state)
{
	(void)state;
	ts_params params;
	ts_params_default(&params);
	params.width = 240;
	params.height = 135;
	ts_how how = { .threads = 2 };
	ts_sums found;
	ts_backend_options options = { .work_group = 64, .build = "", .part_bytes = 1 << 16 };
	if (ts_opencl_kind.open(&how.backend, &options) != TS_OK) skip();
	assert_int_equal(sums_of(&found, "epr", &params, &how), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "allocates"));
	how.backend->close(how.backend);
}

int main(void)
{
	const struct CMUnitTest tests[] = { cmocka_unit_test(test_parts), cmocka_unit_test(test_too_many) };
	return cmocka_run_group_tests(tests, NULL, NULL);
}
