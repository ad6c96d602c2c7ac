/* Launches on a device. A launch asks for all items. Where the device ends long loops, kernels that know bands are
 * launched a band at a time. Kernels of points that lie by pieces are launched over the pieces. */
#include "backends/devices/device.h"
#include "backends/kernels.h"
#include "tests/model/test.h"

static struct {
	u32 n_calls;
	ts_kernel kernel;
	u64 n;
	u8 args[TS_ARGUMENTS];
} asked;

static ts_status enqueue(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	(void)backend, (void)frame;
	asked.n_calls++;
	asked.kernel = launch->kernel;
	asked.n = n;
	memcpy(asked.args, args, ts_kernel_args(launch->kernel)->bytes);
	return TS_OK;
}

/* Arguments of which every byte is 0x5a. */
static void launch(ts_kernel kernel, bool ends_loops, u64 n)
{
	_Alignas(16) u8 args[TS_ARGUMENTS];
	ts_frame *frame = calloc(1, sizeof *frame);
	ts_backend backend = {.ends_loops = ends_loops};
	const ts_launch of = {.kernel = kernel};
	assert_non_null(frame);
	memset(args, 0x5a, sizeof args);
	asked.n_calls = 0;
	assert_int_equal(ts_device_launch(&backend, frame, &of, args, n, enqueue), TS_OK);
	free(frame);
}

static size_t others_of(ts_kernel kernel)
{
	switch (kernel) {
	case TS_KERNEL_eye: return offsetof(ts_eye_args, others);
	case TS_KERNEL_cube_face: return offsetof(ts_cube_face_args, others);
	case TS_KERNEL_depth_map: return offsetof(ts_depth_map_args, others);
	case TS_KERNEL_rsm: return offsetof(ts_rsm_args, others);
	case TS_KERNEL_scatter_pieces: return offsetof(ts_scatter_args, others);
	case TS_KERNEL_shadow_splat_pieces: return offsetof(ts_shadow_splat_args, of.others);
	default: return 0;
	}
}

static void assert_untouched(size_t from, size_t to)
{
	for (size_t i = from; i < to; i++) assert_int_equal(asked.args[i], 0x5a);
}

/* Every kernel, for few items and for many. */
static void bands_shorten_the_loops_of_an_item(void **state)
{
	(void)state;
	static const u64 counts[] = {1, 4096, 5000, (1 << 20) - 1, 1 << 20, 1 << 24};
	static const u32 bands[] = {256, 256, 209, 1, 1, 1};
	for (u32 kernel = 0; kernel < TS_N_KERNELS; kernel++) {
		size_t bytes = ts_kernel_args((ts_kernel)kernel)->bytes, at = others_of((ts_kernel)kernel);
		for (u32 i = 0; i < 6; i++) {
			u32 others;
			if (kernel == TS_KERNEL_splat) continue;
			launch((ts_kernel)kernel, false, counts[i]);
			assert_true(asked.n_calls == 1 && asked.kernel == kernel && asked.n == counts[i]);
			assert_untouched(0, bytes);
			launch((ts_kernel)kernel, true, counts[i]);
			assert_true(asked.n_calls == 1 && asked.kernel == kernel);
			assert_int_equal(asked.n, at != 0 ? counts[i] * bands[i] : counts[i]);
			if (at == 0) assert_untouched(0, bytes);
			if (at == 0) continue;
			memcpy(&others, asked.args + at, sizeof others);
			assert_int_equal(others, bands[i] - 1);
			assert_untouched(0, at);
			assert_untouched(at + sizeof others, bytes);
		}
	}
}

/* Points by pieces go piece by piece, but where loops end, and where points are marked. */
static void points_by_pieces_go_piece_by_piece(void **state)
{
	(void)state;
	u32 offset[2];
	for (u32 way = 0; way < 8; way++) {
		ts_splat_args args = {.n_pieces = 7, .mark = way & 1, .from.offset = (way & 2) != 0 ? offset : NULL};
		ts_backend backend = {.ends_loops = (way & 4) != 0};
		ts_frame *frame = calloc(1, sizeof *frame);
		const ts_launch of = {.kernel = TS_KERNEL_splat};
		assert_non_null(frame);
		assert_int_equal(ts_device_launch(&backend, frame, &of, &args, 100, enqueue), TS_OK);
		assert_int_equal(asked.kernel, way == 2 ? TS_KERNEL_splat_pieces : TS_KERNEL_splat);
		assert_int_equal(asked.n, way == 2 ? 7 : 100);
		free(frame);
	}
}

static void no_items_launch_nothing(void **state)
{
	(void)state;
	launch(TS_KERNEL_eye, true, 0);
	assert_int_equal(asked.n_calls, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(bands_shorten_the_loops_of_an_item),
	                                   cmocka_unit_test(points_by_pieces_go_piece_by_piece),
	                                   cmocka_unit_test(no_items_launch_nothing)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
