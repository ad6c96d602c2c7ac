/* Sizes and shapes: products, one more, what is refused, and what is unknown. */
#include "model/shape.h"
#include "tests/model/test.h"

static ts_sizes some(void)
{
	ts_sizes sizes;
	ts_sizes_clear(&sizes);
	sizes.n[TS_DIM_mirror_pixels] = 7;
	sizes.n[TS_DIM_second_bounces] = 11;
	sizes.n[TS_DIM_lookup_samples] = 25;
	sizes.n[TS_DIM_points] = 0;
	sizes.n[TS_DIM_image_texels] = UINT64_MAX - 1;
	return sizes;
}

static void shapes_multiply_their_sizes(void **state)
{
	(void)state;
	static const struct {
		const char *shape;
		u32 n;
		u64 dims[TS_MAX_DIMS];
	} cases[] = {
		{"mirror_pixels", 1, {7}},
		{"second_bounces 4", 2, {11, 4}},
		{"mirror_pixels*lookup_samples+1", 1, {176}},
		{"mirror_pixels lookup_samples 3", 3, {7, 25, 3}},
		{"points", 1, {0}},
		{"points+1", 1, {1}},
		{"1", 1, {1}},
		{"second_bounces*4+1 2 3 4", 4, {45, 2, 3, 4}},
		{"image_texels", 1, {UINT64_MAX - 1}},
		{"2*lookup_samples*3*lookup_samples", 1, {3750}},
		{"123456789012345678", 1, {123456789012345678}},
	};
	ts_sizes sizes = some();
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		ts_shape shape;
		u64 dims[TS_MAX_DIMS];
		bool good = ts_shape_parse(&shape, cases[i].shape) && ts_shape_dims(&shape, &sizes, dims);
		if (!good) fail_msg("%s", cases[i].shape);
		assert_int_equal(shape.n, cases[i].n);
		for (u32 d = 0; d < shape.n; d++) assert_int_equal(dims[d], cases[i].dims[d]);
	}
}

static void what_is_no_shape_is_refused(void **state)
{
	(void)state;
	static const char *const shapes[] = {"",
	                                     "mirror_pixel",
	                                     "mirror_pixelss",
	                                     "points P",
	                                     "1 2 3 4 5",
	                                     "points*",
	                                     "*points",
	                                     "points**2",
	                                     "points+2",
	                                     "+1",
	                                     "points+1+1",
	                                     "points  2",
	                                     "points-1",
	                                     "1234567890123456789",
	                                     "points*points*points",
	                                     "999999999999999999*999999999999999999"};
	for (u32 i = 0; i < sizeof shapes / sizeof *shapes; i++) {
		ts_shape shape;
		if (ts_shape_parse(&shape, shapes[i])) fail_msg("\"%s\" is a shape", shapes[i]);
	}
}

/* Sizes that were not given, and products past 2^64. */
/* Every size is unknown at first, and nothing behind them is changed. */
static void every_size_is_unknown_at_first(void **state)
{
	(void)state;
	struct {
		ts_sizes sizes;
		u64 behind[4];
	} s = {.behind = {1, 2, 3, 4}};
	ts_sizes_clear(&s.sizes);
	for (u32 dim = 0; dim < TS_N_DIMS; dim++) assert_true(s.sizes.n[dim] == TS_UNKNOWN);
	for (u32 i = 0; i < 4; i++) assert_int_equal(s.behind[i], i + 1);
}

static void an_unknown_size_makes_an_unknown_shape(void **state)
{
	(void)state;
	static const char *const shapes[] = {"pieces",        "mirror_pixels pieces", "pieces*mirror_pixels",
	                                     "pieces+1",      "image_texels*2",       "image_texels*mirror_pixels+1",
	                                     "image_texels+1"};
	ts_sizes sizes = some();
	for (u32 i = 0; i < sizeof shapes / sizeof *shapes; i++) {
		ts_shape shape;
		u64 dims[TS_MAX_DIMS];
		assert_true(ts_shape_parse(&shape, shapes[i]));
		if (ts_shape_dims(&shape, &sizes, dims)) fail_msg("%s is known", shapes[i]);
		assert_true(dims[shape.n - 1] == TS_UNKNOWN);
	}
}

static void a_dimension_counts_one_size(void **state)
{
	(void)state;
	static const struct {
		const char *shape;
		ts_dim dim;
		bool image;
	} cases[] = {
		{"points", TS_DIM_points, false},
		{"pieces+1", TS_DIM_pieces, false},
		{"height width 3", TS_DIM_height, true},
		{"eye_rows width", TS_DIM_eye_rows, true},
		{"sample_rows width 3", TS_DIM_sample_rows, true},
		{"height*width+1", TS_DIM_none, false},
		{"second_bounces*4+1", TS_DIM_none, false},
		{"6", TS_DIM_none, false},
		{"grid_side grid_side", TS_DIM_grid_side, false},
		{"width height", TS_DIM_width, false},
		{"height", TS_DIM_height, false},
	};
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		ts_shape shape;
		assert_true(ts_shape_parse(&shape, cases[i].shape));
		assert_int_equal(ts_axis_counts(&shape.axis[0]), cases[i].dim);
		assert_int_equal(ts_shape_is_image(&shape), cases[i].image);
	}
}

static void a_count_does_not_overflow(void **state)
{
	(void)state;
	u64 n;
	assert_true(ts_shape_count(&n, 3, (u64[]){2, 3, 4}) && n == 24);
	assert_true(ts_shape_count(&n, 2, (u64[]){0, UINT64_MAX}) && n == 0);
	assert_true(ts_shape_count(&n, 2, (u64[]){UINT64_MAX, 0}) && n == 0);
	assert_false(ts_shape_count(&n, 2, (u64[]){1ull << 32, 1ull << 32}));
}

int main(void)
{
	const struct CMUnitTest shape[] = {
		cmocka_unit_test(shapes_multiply_their_sizes),    cmocka_unit_test(what_is_no_shape_is_refused),
		cmocka_unit_test(every_size_is_unknown_at_first), cmocka_unit_test(an_unknown_size_makes_an_unknown_shape),
		cmocka_unit_test(a_dimension_counts_one_size),    cmocka_unit_test(a_count_does_not_overflow),
	};
	return cmocka_run_group_tests(shape, NULL, NULL);
}
