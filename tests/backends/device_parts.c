/* Arrays in parts, as on a device that cannot allocate them at once: the same bits. */
#include "tests/backends/device.h"
#include "trace/emitted/sums.h"

static ts_status sums_of(ts_sums *sums, ts_backend *backend)
{
	ts_params params;
	ts_scene *scene;
	ts_params_default(&params);
	params.width = 240;
	params.height = 135;
	params.lookup_bounces = 2;
	assert_int_equal(ts_scene_load(&scene, "atrium:triangles=10000:texels=32", &params, NULL), TS_OK);
	ts_how how = {.threads = 2, .backend = backend};
	ts_status status = ts_sums_of(sums, ts_pipeline_find("reflections", "epr"), scene, &params, &how);
	ts_scene_free(scene);
	return status;
}

/* Points of 6 MB and texels of 2 MB in parts of one MiB, in the host's memory and in copies. */
static void in_parts(const ts_backend_kind *kind)
{
	ts_sums right, found;
	if (kind == &ts_cuda_kind) return; /* has no limit but its memory */
	assert_int_equal(sums_of(&right, NULL), TS_OK);
	for (u32 copies = 0; copies < 2; copies++) {
		ts_backend *backend =
			device_open(kind, (ts_backend_options){.work_group = 64, .part_bytes = 1 << 20, .copies = copies != 0});
		if (sums_of(&found, backend) != TS_OK) fail_msg("%s", ts_error_message());
		assert_memory_equal(right.hex, found.hex, sizeof right.hex);
		backend->close(backend);
	}
}

static void arrays_in_parts_have_the_same_bits(void **state)
{
	(void)state;
	device_each(in_parts);
}

/* More parts than there may be are refused with one line. */
static void too_many(const ts_backend_kind *kind)
{
	ts_sums found;
	if (kind == &ts_cuda_kind) return;
	ts_backend *backend = device_open(kind, (ts_backend_options){.work_group = 64, .part_bytes = 1 << 16});
	assert_int_equal(sums_of(&found, backend), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "allocates"));
	backend->close(backend);
}

static void too_many_parts_are_refused(void **state)
{
	(void)state;
	device_each(too_many);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(arrays_in_parts_have_the_same_bits),
	                                   cmocka_unit_test(too_many_parts_are_refused)};
	device_begin();
	return cmocka_run_group_tests(tests, NULL, NULL);
}
