/* Stochastic culling: its closed forms (FIGURES 3), independence, and what is never dropped. */
#include "tests/kernels/points/mesh.h"

enum { N = 200000 };

/* N right triangles of `pixels` samples each, densities s; *keep by free(). */
static u32 cull(u32 **keep, f32 pixels, f32 s, f32 unit, u32 seed, u32 enabled)
{
	f32 side = (f32)sqrt(2.0 * (double)pixels) / (s / unit);
	ts_piece *pieces = mesh_alloc(N, sizeof *pieces);
	f32 *scale = mesh_alloc(N, sizeof *scale);
	*keep = mesh_alloc(N, sizeof **keep);
	ts_cull_args args = {
		.pieces = pieces, .scale = scale, .keep = *keep, .unit = unit, .seed = seed, .enabled = enabled};
	u32 kept = 0;
	for (u32 i = 0; i < N; i++) {
		pieces[i] = (ts_piece){.b = {side}, .c = {0, side}, .triangle = i, .path = 1};
		scale[i] = s;
		ts_k_cull_item(&args, i);
		kept += (*keep)[i];
	}
	free(pieces);
	free(scale);
	return kept;
}

/* Of triangles of A pixels 10 A stay: ten a pixel whatever A, within four standard deviations. */
static void ten_survivors_a_pixel_whatever_the_area(void **state)
{
	(void)state;
	static const f32 areas[] = {0.09f, 0.05f, 0.02f, 0.01f, 0.001f};
	for (u32 i = 0; i < 5; i++) {
		for (u32 seed = 0; seed < 3; seed++) {
			u32 *keep;
			double p = 10.0 * areas[i], kept = cull(&keep, areas[i], 16, 0.5f, seed, 1);
			free(keep);
			assert_true(fabs(kept - p * N) <= 4 * sqrt(p * (1 - p) * N));
		}
	}
}

/* A tenth of a pixel and more always stays; less, with the switch off, too; no density never does. */
static void large_triangles_always_stay(void **state)
{
	(void)state;
	static const f32 areas[] = {0.1001f, 0.2f, 1, 100};
	u32 *keep;
	for (u32 i = 0; i < 4; i++) {
		assert_int_equal(cull(&keep, areas[i], 16, 1, 7, 1), N);
		free(keep);
	}
	assert_int_equal(cull(&keep, 0.001f, 16, 1, 7, 0), N);
	free(keep);
	for (u32 enabled = 0; enabled < 2; enabled++) {
		ts_piece piece = {.b = {1}, .c = {0, 1}, .path = 1};
		f32 scale = 0;
		u32 stays = 1;
		ts_cull_args args = {.pieces = &piece, .scale = &scale, .keep = &stays, .unit = 1, .enabled = enabled};
		ts_k_cull_item(&args, 0);
		assert_int_equal(stays, 0);
	}
}

/* The eye's pixels are 1 / density.scale^2 of the raster's: a quarter of a pixel there is a whole one here. */
static void areas_count_in_pixels_of_the_eye(void **state)
{
	(void)state;
	u32 *eye, *raster;
	assert_int_equal(cull(&eye, 0.04f, 32, 0.5f, 1, 1), cull(&raster, 0.04f, 16, 0.25f, 1, 1));
	assert_memory_equal(eye, raster, N * sizeof *eye);
	free(eye);
	free(raster);
}

/* The same in every frame; others with another seed; and a larger triangle stays where a smaller one does. */
static void the_same_triangles_stay_in_every_frame(void **state)
{
	(void)state;
	u32 *one, *two, *other, *larger;
	u32 kept = cull(&one, 0.03f, 16, 1, 5, 1);
	assert_int_equal(cull(&two, 0.03f, 16, 1, 5, 1), kept);
	assert_memory_equal(one, two, N * sizeof *one);
	cull(&other, 0.03f, 16, 1, 6, 1);
	cull(&larger, 0.06f, 16, 1, 5, 1);
	u32 both = 0;
	for (u32 i = 0; i < N; i++) {
		both += one[i] & other[i];
		assert_true(one[i] <= larger[i]);
	}
	assert_true(fabs(both - 0.09 * N) <= 4 * sqrt(0.09 * 0.91 * N));
	free(one);
	free(two);
	free(other);
	free(larger);
}

/* Neighbouring triangles and the pieces of one are dropped independently. */
static void neighbours_are_dropped_independently(void **state)
{
	(void)state;
	u32 *keep;
	cull(&keep, 0.05f, 16, 1, 0, 1);
	for (u32 step = 1; step <= 64; step *= 2) {
		u32 pairs = 0;
		for (u32 i = 0; i + step < N; i++) pairs += keep[i] & keep[i + step];
		assert_true(fabs(pairs - 0.25 * (N - step)) <= 4 * sqrt(0.25 * 0.75 * 1.5 * N));
	}
	free(keep);
	ts_piece piece = {.b = {1}, .c = {0, 0.1f}};
	f32 scale = 1;
	u32 stays, kept = 0;
	ts_cull_args args = {.pieces = &piece, .scale = &scale, .keep = &stays, .unit = 1, .enabled = 1};
	for (u32 i = 0; i < 4096 * 16; i++) {
		piece.triangle = 1000 + i / 4096;
		piece.path = 4096 + i % 4096;
		ts_k_cull_item(&args, 0);
		kept += stays;
	}
	assert_true(fabs(kept - 0.5 * 4096 * 16) <= 4 * sqrt(0.25 * 4096 * 16));
}

/* 1 - 10 A in 2^-24, within the rounding of the product; from 2^24 down to 0, never rising. */
static void thresholds_fall_as_areas_grow(void **state)
{
	(void)state;
	assert_int_equal(ts_k_cull_threshold(0), 1 << 24);
	assert_int_equal(ts_k_cull_threshold(0.1f), 0);
	assert_int_equal(ts_k_cull_threshold(1e30f), 0);
	i32 before = 1 << 24;
	for (u32 i = 0; i <= 400000; i++) {
		f32 pixels = (f32)i * 2.5e-7f;
		i32 threshold = ts_k_cull_threshold(pixels);
		assert_true(fabs(threshold - fmax(0, (1 - 10.0 * (double)pixels) * 16777216)) <= 2);
		assert_true(threshold <= before);
		before = threshold;
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(ten_survivors_a_pixel_whatever_the_area),
		cmocka_unit_test(large_triangles_always_stay),
		cmocka_unit_test(areas_count_in_pixels_of_the_eye),
		cmocka_unit_test(the_same_triangles_stay_in_every_frame),
		cmocka_unit_test(neighbours_are_dropped_independently),
		cmocka_unit_test(thresholds_fall_as_areas_grow),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
