/* The depth grid: its texels against rational numbers, from images that are larger, smaller and no multiple of it; and
 * blocks, which hold each texel once. */
#include <string.h>
#include "kernels/hulls/depth_grid.h"
#include "tests/kernels/seeded.h"

/* floor((i + 1/2) to / from) in rational numbers; a pixel that the grid has texels enough for is shown by its own. */
static void texels_are_those_of_rational_numbers(void **state)
{
	(void)state;
	for (u32 n = 0; n < 20000; n++) {
		u32 from = 1 + below(4096), to = 1 + below(4096), i = below(from), k = ts_k_resample(i, from, to);
		assert_true(k < to);
		assert_true((u64)k * 2 * from <= (2 * (u64)i + 1) * to && (2 * (u64)i + 1) * to < ((u64)k + 1) * 2 * from);
		if (to >= from) assert_int_equal(ts_k_resample(k, to, from), i);
	}
	assert_int_equal(ts_k_resample(16383, 16384, 4096), 4095);
}

enum { MOST_PIXELS = 200 * 150, MOST_TEXELS = 160 * 160 };

/* Depths that are numbers of pixels: which a texel shows, and whether the grid shows them all. */
static void check_grid(u32 grid, u32 width, u32 height)
{
	static ts_gpixel pixels[MOST_PIXELS];
	static f32 depths[MOST_TEXELS + 1];
	static bool shown[MOST_PIXELS];
	u32 n_shown = 0, n_wide = width < grid ? width : grid, n_high = height < grid ? height : grid;
	for (u32 i = 0; i < width * height; i++) pixels[i].depth = (f32)i;
	memset(shown, 0, sizeof shown);
	depths[grid * grid] = -1;
	ts_depth_grid_args args = {.pixels = pixels, .depths = depths, .grid = grid, .width = width, .height = height};
	for (u32 i = 0; i < grid * grid; i++) ts_k_depth_grid_item(&args, i);
	for (u32 y = 0; y < grid; y++) {
		for (u32 x = 0; x < grid; x++) {
			u32 column = (u32)floor((x + 0.5) * width / grid), row = (u32)floor((y + 0.5) * height / grid);
			assert_true(depths[y * grid + x] == (f32)(row * width + column));
			n_shown += !shown[row * width + column];
			shown[row * width + column] = true;
		}
	}
	assert_int_equal(n_shown, n_wide * n_high);
	assert_true(depths[grid * grid] == -1);
}

static void the_grid_shows_the_nearest_pixels(void **state)
{
	(void)state;
	static const u32 sizes[][2] = {{130, 50}, {96, 96}, {32, 160}, {7, 150}, {200, 3}, {1, 1}};
	for (u32 grid = 32; grid <= 160; grid += 32) {
		for (u32 k = 0; k < sizeof sizes / sizeof *sizes; k++) check_grid(grid, sizes[k][0], sizes[k][1]);
	}
}

/* Blocks are numbered by rows, and so are texels within them. */
static void blocks_hold_each_texel_once(void **state)
{
	(void)state;
	for (u32 side = 1; side <= 5; side++) {
		u32 grid = side * 32;
		for (u32 i = 0; i < grid * grid; i++) {
			u32 x = i % grid, y = i / grid, block = ts_k_block_of(grid, x, y);
			assert_int_equal(block, y / 32 * side + x / 32);
			assert_int_equal(ts_k_block_texel(grid, block, x % 32, y % 32), i);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(texels_are_those_of_rational_numbers),
		seeded_test(the_grid_shows_the_nearest_pixels),
		seeded_test(blocks_hold_each_texel_once),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
