/* Bands, as on a device that ends long loops: the bits of whole items, whatever makes the items. */
#include <string.h>
#include "backends/devices/device.h"
#include "tests/model/test.h"
#include "trace/emitted/sums.h"

static u64 items[TS_N_KERNELS];

/* On the host, where buffers already are. */
static ts_status run_items(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	(void)backend;
	(void)frame;
	items[launch->kernel] += n;
	ts_c_launch(launch->kernel, args, n, 2);
	return TS_OK;
}

static u64 n_items;
static ts_status count_items(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	(void)backend;
	(void)frame;
	(void)launch;
	(void)args;
	n_items = n;
	return TS_OK;
}

static ts_status launch(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	return ts_device_launch(backend, frame, launch, args, n, run_items);
}

static void sums_of(ts_sums *sums, const char *effect, const char *method, bool ends_loops)
{
	ts_c_backend c;
	ts_params params;
	ts_scene *scene;
	ts_params_default(&params);
	params.width = 64; /* most is taller than there are bands */
	params.height = 360;
	params.cube_max_px = 256;
	params.depth_map_px = 256;
	params.rsm_px = 128;
	params.lamp_views = 5;
	params.lamp_cubes = 2;
	assert_int_equal(ts_params_set(&params, "points.buffered", "off"), TS_OK);
	assert_int_equal(ts_scene_load(&scene, "dining:triangles=10000:texels=32", &params, NULL), TS_OK);
	ts_c_begin(&c, 2);
	c.backend.launch = launch;
	c.backend.ends_loops = ends_loops;
	memset(items, 0, sizeof items);
	ts_how how = {.threads = 2, .backend = &c.backend};
	const ts_status status = ts_sums_of(sums, ts_pipeline_find(effect, method), scene, &params, &how);
	if (status != TS_OK) fail_msg("%s %s: %s", effect, method, ts_error_message());
	ts_scene_free(scene);
}

/* The kernels that draw rows, or points by pieces, get many items for each; points are splatted one by one. */
static void bands_have_the_bits_of_whole_items(void **state)
{
	(void)state;
	static const struct {
		const char *effect, *method;
		ts_kernel kernel;
	} runs[] = {
		{"reflections", "mvr", TS_KERNEL_eye},
		{"reflections", "mvr", TS_KERNEL_cube_face},
		{"soft-shadows", "mvr", TS_KERNEL_depth_map},
		{"indirect", "hulls", TS_KERNEL_rsm},
		{"reflections", "ivir", TS_KERNEL_scatter_pieces},
		{"omni-shadows", "epr", TS_KERNEL_shadow_splat_pieces},
	};
	for (u32 i = 0; i < sizeof runs / sizeof *runs; i++) {
		ts_sums whole, banded;
		sums_of(&whole, runs[i].effect, runs[i].method, false);
		const u64 n = items[runs[i].kernel];
		sums_of(&banded, runs[i].effect, runs[i].method, true);
		assert_true(n != 0 && items[runs[i].kernel] > 8 * n);
		assert_memory_equal(whole.hex, banded.hex, sizeof whole.hex);
	}
}

static bool knows_bands(const ts_arg_list *list)
{
	for (const ts_arg *row = list->rows; row < list->rows + list->n; row++) {
		if (strcmp(row->name, "others") == 0) return true;
		if (row->role == TS_ROLE_INNER && knows_bands(row->inner())) return true;
	}
	return false;
}

/* Each kernel whose arguments have bands gets them, but those that share a struct with one: they are over points or
 * texels. */
static void every_kernel_that_knows_bands_gets_them(void **state)
{
	(void)state;
	static u64 args[TS_ARGUMENTS / sizeof(u64)];
	ts_backend backend = {.ends_loops = true};
	for (u32 k = 0; k < TS_N_KERNELS; k++) {
		const ts_launch of = {(ts_kernel)k, {TS_ALL}};
		const bool shares = k == TS_KERNEL_scatter || k == TS_KERNEL_shadow_splat || k == TS_KERNEL_rsm_patch;
		ts_frame frame = {.bytes = 0};
		u64 n = 1000;
		assert_int_equal(ts_device_launch(&backend, &frame, &of, args, n, count_items), TS_OK);
		if ((n_items > n) != (knows_bands(ts_kernel_args((ts_kernel)k)) && !shares))
			fail_msg("%s: %u items of %u", ts_kernel_name((ts_kernel)k), (unsigned)n_items, (unsigned)n);
	}
}

static void points_by_bands_go_one_by_one(void **state)
{
	(void)state;
	ts_sums by_pieces, by_points;
	sums_of(&by_pieces, "reflections", "epr", false);
	assert_true(items[TS_KERNEL_splat_pieces] != 0);
	sums_of(&by_points, "reflections", "epr", true);
	assert_true(items[TS_KERNEL_splat_pieces] == 0 && items[TS_KERNEL_splat] != 0);
	assert_memory_equal(by_pieces.hex, by_points.hex, sizeof by_pieces.hex);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(bands_have_the_bits_of_whole_items),
	                                   cmocka_unit_test(every_kernel_that_knows_bands_gets_them),
	                                   cmocka_unit_test(points_by_bands_go_one_by_one)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
