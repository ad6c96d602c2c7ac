/* Goldens in memory: which difference is the first, and how it is told. */
#include <math.h>
#include "golden/golden.h"
#include "kernels/base/num.h"
#include "tests/model/test.h"

/* A file of n elements of that buffer, all bytes 0. */
static ts_golden_file file_of(ts_buffer_id id, u32 n_dims, const u64 *shape)
{
	ts_golden_file file = {.npy = {.n_dims = n_dims, .data_at = 128}};
	ts_shape_count(&file.npy.n, n_dims, shape);
	memcpy(file.npy.shape, shape, n_dims * sizeof *shape);
	file.bytes = file.taken = (size_t)(128 + file.npy.n * ts_buffer_table[id].element_bytes);
	file.data = calloc(file.bytes, 1);
	assert_non_null(file.data);
	return file;
}

/* Byte `at` of the data becomes `value`: this is told. */
static void tells(ts_buffer_id id, u32 n_dims, const u64 *shape, size_t at, int value, const char *expected)
{
	char text[256];
	ts_golden_file a = file_of(id, n_dims, shape), b = file_of(id, n_dims, shape);
	ts_golden_first(text, sizeof text, id, &a, &b);
	assert_string_equal(text, "");
	b.data[128 + at] = (char)value;
	ts_golden_first(text, sizeof text, id, &a, &b);
	assert_string_equal(text, expected);
	free(a.data);
	free(b.data);
}

static void elements_and_fields_are_told(void **state)
{
	(void)state;
	const u64 image[3] = {4, 5, 3}, list[1] = {7}, depth[2] = {4, 5};
	tells(TS_B_image_radiance, 3, image, 4 * 22 + 3, 0x80,
	      "element [1, 2, 1]: golden 0x0p+0 (00000000) here -0x0p+0 (80000000)");
	tells(TS_B_image_srgb, 3, image, 59, 255, "element [3, 4, 2]: golden 0 (0x0) here 255 (0xff)");
	tells(TS_B_eye_depth_triangle, 2, depth, 8 * 6 + 7, 1,
	      "element [1, 1]: golden 0 (0x0) here 72057594037927936 (0x100000000000000)");
	tells(TS_B_points_record, 1, list, 32 * 3 + 8, 1,
	      "element [3], field centre[2]: golden 0x0p+0 (00000000) here 0x1p-149 (00000001)");
	tells(TS_B_points_record, 1, list, 32 * 6, 1,
	      "element [6], field centre[0]: golden 0x0p+0 (00000000) here 0x1p-149 (00000001)");
	tells(TS_B_points_record, 1, list, 32 * 6 + 20, 1, "element [6], field flags: golden 0 (0x0) here 1 (0x1)");
	tells(TS_B_align_frame, 1, list, 48 + 4 + 3, 0x80,
	      "element [0], field q[1]: golden 0 (0x00000000) here -2147483648 (0x80000000)");
	tells(TS_B_cube_size_face, 1, list, 64 + 48 + 1, 1, "element [1], field offset: golden 0 (0x0) here 256 (0x100)");
}

static void every_byte_is_told(void **state)
{
	(void)state;
	const u64 shape[1] = {2};
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_golden_file a = file_of((ts_buffer_id)id, 1, shape), b = file_of((ts_buffer_id)id, 1, shape);
		for (size_t at = 128; at < a.bytes; at++) {
			char text[256];
			b.data[at] = 1;
			ts_golden_first(text, sizeof text, (ts_buffer_id)id, &a, &b);
			assert_int_equal(text[9], '0' + (int)((at - 128) / ts_buffer_table[id].element_bytes));
			assert_non_null(strstr(text, " here "));
			b.data[at] = 0;
		}
		free(a.data);
		free(b.data);
	}
}

static void other_shapes_are_told(void **state)
{
	(void)state;
	char text[256];
	ts_golden_file a = file_of(TS_B_cull_keep, 1, (u64[]){6}), b = file_of(TS_B_cull_keep, 2, (u64[]){2, 3});
	ts_golden_first(text, sizeof text, TS_B_cull_keep, &a, &b);
	assert_string_equal(text, "shape: golden [6] here [2, 3]");
	free(a.data);
	free(b.data);
}

/* Two goldens whose digests are all zeros. */
static void make_same(ts_golden *a, ts_golden *b)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) memset(a->sums.hex[id], '0', TS_DIGEST_BYTES - 1);
	*b = *a;
}

static void the_first_stage_is_told_first(void **state)
{
	(void)state;
	static ts_golden a, b;
	char text[512];
	const ts_pipeline *mvr = ts_pipeline_find("reflections", "mvr");
	make_same(&a, &b);
	assert_int_equal(ts_golden_compare(text, sizeof text, &a, &b, mvr, false), TS_OK);
	/* shade.radiance stands before cube_face.mip in records.def, but mvr makes it after. */
	a.sums.hex[TS_B_shade_radiance][5] = '1';
	a.sums.hex[TS_B_cube_face_mip][5] = '1';
	assert_int_equal(ts_golden_compare(text, sizeof text, &a, &b, mvr, false), TS_DIFFERENT);
	assert_string_equal(text, "07-cube_face.mip.npy: SHA-256: golden 0000010000000000... here 0000000000000000...");
	b.sums.hex[TS_B_scene_light][0] = 0;
	assert_int_equal(ts_golden_compare(text, sizeof text, &a, &b, mvr, false), TS_DIFFERENT);
	assert_string_equal(text, "00-scene.light.npy: in SHA256SUMS, but not made here");
	b.bytes[TS_B_scene_image] = 100;
	assert_int_equal(ts_golden_compare(text, sizeof text, &a, &b, mvr, true), TS_ERROR);
	assert_string_equal(ts_error_message(), "small/00-scene.image.npy: there is no such file");
}

/* A stored file that is not what the list says is told, also where both digests are the same. */
static void damaged_files_are_told(void **state)
{
	(void)state;
	static ts_golden a, b;
	char text[512];
	const ts_pipeline *mvr = ts_pipeline_find("reflections", "mvr");
	make_same(&a, &b);
	a.file[TS_B_image_srgb] = file_of(TS_B_image_srgb, 3, (u64[]){4, 5, 3});
	strcpy(a.file[TS_B_image_srgb].hex, a.sums.hex[TS_B_image_srgb]);
	assert_int_equal(ts_golden_compare(text, sizeof text, &a, &b, mvr, false), TS_OK);
	assert_string_equal(text, "");
	a.file[TS_B_image_srgb].hex[3] = '1';
	assert_int_equal(ts_golden_compare(text, sizeof text, &a, &b, mvr, false), TS_DIFFERENT);
	assert_non_null(strstr(text, "image.srgb.npy: small/ does not hold what SHA256SUMS says"));
	a.sums.hex[TS_B_image_srgb][3] = '2';
	assert_int_equal(ts_golden_compare(text, sizeof text, &a, &b, mvr, false), TS_DIFFERENT);
	assert_non_null(strstr(text, "0000000000000000...; small/ does not hold"));
	ts_golden_free(&a);
}

static void numbers_that_none_may_have_are_counted(void **state)
{
	(void)state;
	const f32 good[6] = {0, -1, 0x1p127f, 0x1p-100f, -0x1p-100f, 1};
	const f32 bad[6] = {-0.0f, 1, INFINITY, -INFINITY, NAN, 0x1.fffffep-101f};
	assert_int_equal(ts_golden_strays(TS_B_image_radiance, good, sizeof good), 0);
	assert_int_equal(ts_golden_strays(TS_B_image_radiance, bad, sizeof bad), 5);
	assert_int_equal(ts_golden_strays(TS_B_lookup_point, bad, sizeof bad), 0);
	const u64 one = (u64)ts_f2u(1) << 32, infinite = (u64)ts_f2u(INFINITY) << 32 | 7;
	const u64 keys[4] = {TS_EMPTY, 3, one, infinite};
	assert_int_equal(ts_golden_strays(TS_B_splat_depth_index, keys, sizeof keys), 1);
	assert_int_equal(ts_golden_strays(TS_B_eye_depth_triangle, keys, sizeof keys), 2);
	assert_int_equal(ts_golden_strays(TS_B_points_key, keys, sizeof keys), 0);
	ts_point points[2] = {{.centre = {1, 2, 3}, .length = NAN, .piece = 0x7f800000u}, {.centre = {1, INFINITY, 3}}};
	assert_int_equal(ts_golden_strays(TS_B_points_record, points, sizeof points), 2);
	ts_face faces[2] = {{.offset = ~0ull}, {.radius = NAN, .object = ~0u}};
	assert_int_equal(ts_golden_strays(TS_B_cube_size_face, faces, sizeof faces), 1);
	ts_align align = {.q = {-1, -1, -1, -1, -1, -1}, .v = {0, 0, NAN}};
	assert_int_equal(ts_golden_strays(TS_B_align_frame, &align, sizeof align), 1);
}

static void constant_images_are_seen(void **state)
{
	(void)state;
	static ts_golden golden;
	assert_true(ts_golden_is_constant(&golden));
	golden.file[TS_B_image_srgb] = file_of(TS_B_image_srgb, 3, (u64[]){4, 5, 3});
	ts_golden_file *file = &golden.file[TS_B_image_srgb];
	file->data = realloc(file->data, file->bytes + 1);
	assert_non_null(file->data);
	file->data[file->bytes] = 1; /* is no pixel */
	char *pixels = file->data + 128;
	for (u32 i = 0; i < 20; i++) pixels[3 * i + 1] = 7;
	assert_true(ts_golden_is_constant(&golden));
	pixels[59] = 1;
	assert_false(ts_golden_is_constant(&golden));
	ts_golden_free(&golden);
}

int main(void)
{
	const struct CMUnitTest golden[] = {
		cmocka_unit_test(elements_and_fields_are_told),
		cmocka_unit_test(every_byte_is_told),
		cmocka_unit_test(other_shapes_are_told),
		cmocka_unit_test(the_first_stage_is_told_first),
		cmocka_unit_test(numbers_that_none_may_have_are_counted),
		cmocka_unit_test(constant_images_are_seen),
		cmocka_unit_test(damaged_files_are_told),
	};
	return cmocka_run_group_tests(golden, NULL, NULL);
}
