/* Seams of made-up images whose changes are known, and corners at known heights above a triangle of light. */
#include <math.h>
#include "methods/hulls/tools/borders.h"
#include "tests/model/test.h"

enum { SIDE = 64, PIXELS = SIDE * SIDE, HALF = SIDE / 2, INNER = HALF - 1 };

/* A pixel a texel of a grid of 2 x 2 blocks, one box each. */
typedef struct {
	ts_gpixel pixels[PIXELS];
	u32 boxes[PIXELS];
	f32 hulls[3 * PIXELS], direct[3 * PIXELS];
} image;

/* Direct is 2, 4 and 8 and grows along rows; hulls are so too, and have `step` more of it right of the middle, and
 * `slope` more a pixel down. */
static void make(image *im, f32 grows, f32 step, f32 slope)
{
	for (u32 i = 0; i < PIXELS; i++) {
		u32 x = i % SIDE, y = i / SIDE;
		im->pixels[i] = (ts_gpixel){.depth = 0.5f, .normal = {0, 0, 1}};
		im->boxes[i] = y / HALF * 2 + x / HALF;
		for (u32 c = 0; c < 3; c++) {
			f32 base = (f32)(2u << c);
			im->direct[3 * i + c] = base + grows * base * ((f32)x - (SIDE - 1) / 2.0f);
			im->hulls[3 * i + c] = im->direct[3 * i + c] + (x < HALF ? 0 : step * base) + slope * base * (f32)y;
		}
	}
}

static ts_borders measured(const image *im)
{
	const ts_borders_of of = {im->pixels, im->boxes, im->hulls, im->direct, SIDE, SIDE, SIDE};
	return ts_borders_measure(&of);
}

static void is_near(double x, double right)
{
	if (!(fabs(x - right) <= 1e-6)) fail_msg("%.9g, not %.9g", x, right);
}

/* Of 128 pairs across borders 64 lie in the one that hulls step at, and 64 in the one that they cross by their slope;
 * half of those within boxes are below each other. */
static void steps_at_borders_are_measured(void **state)
{
	(void)state;
	static image im;
	static const f32 cases[][3] = {
		{0, 0, 0}, {0.0078125f, 0, 0}, {0, 0.25f, 0}, {0.0078125f, -0.5f, 0}, {0, 0.25f, 0.0625f}};
	for (u32 k = 0; k < sizeof cases / sizeof *cases; k++) {
		make(&im, cases[k][0], cases[k][1], cases[k][2]);
		ts_borders found = measured(&im);
		is_near(found.across, (fabs((double)cases[k][1]) + (double)cases[k][2]) / 2);
		is_near(found.within, (double)cases[k][2] / 2);
	}
}

/* Pairs with the sky, with another depth or normal, and within a block of two boxes do not count; just within the
 * bounds they do. */
static void unlike_pairs_do_not_count(void **state)
{
	(void)state;
	static image im;
	const u32 middle = 10 * SIDE + 10;
	const double one = 9.0 / (4 * INNER * HALF * 2); /* a pixel that is apart from its four neighbours, by all pairs */
	const struct {
		ts_gpixel pixel;
		u32 box;
		bool counts;
	} cases[] = {
		{{.depth = 0.5f, .normal = {0, 0, 1}}, 0, true},
		{{.depth = 0.5f, .normal = {0, 0, 1}}, 4, false},
		{{.depth = 1.0f, .normal = {0, 0, 1}}, 0, false},
		{{.depth = 0.5f - 0.0098f, .normal = {0, 0, 1}}, 0, true},
		{{.depth = 0.5f + 0.0098f, .normal = {0, 0, 1}}, 0, true},
		{{.depth = 0.5f - 0.0105f, .normal = {0, 0, 1}}, 0, false},
		{{.depth = 0.5f + 0.0105f, .normal = {0, 0, 1}}, 0, false},
		{{.depth = 0.5f, .normal = {0.14f, 0, 0.9902f}}, 0, true},
		{{.depth = 0.5f, .normal = {0.15f, 0, 0.9887f}}, 0, false},
	};
	for (u32 k = 0; k < sizeof cases / sizeof *cases; k++) {
		make(&im, 0, 0, 0);
		im.pixels[middle] = cases[k].pixel;
		im.boxes[middle] = cases[k].box;
		for (u32 c = 0; c < 3; c++) im.hulls[3 * middle + c] *= 10;
		ts_borders found = measured(&im);
		assert_true(found.across == 0);
		is_near(found.within, cases[k].counts ? 4 * one : 0);
	}
}

/* Without light, or pixels that are alike, there is nothing to divide by. */
static void without_light_there_is_no_seam(void **state)
{
	(void)state;
	static image im;
	make(&im, 0, 0.5f, 0);
	for (u32 i = 0; i < 3 * PIXELS; i++) im.direct[i] = 0;
	ts_borders found = measured(&im);
	assert_true(isnan(found.across) && isnan(found.within));
	make(&im, 0, 0.5f, 0);
	for (u32 i = 0; i < PIXELS; i++) im.pixels[i].depth = 1;
	found = measured(&im);
	assert_true(isnan(found.across) && isnan(found.within));
}

/* In sixteenths of a side: from above 0 on it faces, above 1 the ramp counts it, from 5 on in full. */
static void corners_face_from_their_heights_on(void **state)
{
	(void)state;
	static const f32 heights[] = {-16, 0, 0.5f, 1, 1.5f, 4.9375f, 5, 16};
	enum { N = sizeof heights / sizeof *heights };
	for (f32 side = 0.25f; side < 5; side *= 2) {
		const ts_patch patches[2] = {
			{.a = {1, 2, 3}, .b = {1 + side, 2, 3}, .c = {1, 2 + side, 3}, .normal = {0, 0, 1}}, {.pad = 0}};
		ts_moment corners[N];
		for (u32 i = 0; i < N; i++) corners[i] = (ts_moment){.position = {7, -1, 3 + heights[i] * side / 16}};
		ts_facing_pairs pairs = ts_facing_count(corners, N, patches, 2);
		assert_true(pairs.facing == 6 && pairs.counted == 4 && pairs.full == 2);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(steps_at_borders_are_measured), cmocka_unit_test(unlike_pairs_do_not_count),
		cmocka_unit_test(without_light_there_is_no_seam), cmocka_unit_test(corners_face_from_their_heights_on)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
