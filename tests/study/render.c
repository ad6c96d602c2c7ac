/* Pictures of a render that are compared: which with which, and over which pixels. */
#include <math.h>
#include "study/render.h"
#include "tests/model/test.h"

enum { WIDTH = 16, HEIGHT = 12, PIXELS = WIDTH * HEIGHT };

static ts_render render;
static ts_job job;
static f32 radiance[3][3 * PIXELS];
static u8 srgb[3][3 * PIXELS], seen[PIXELS], near[PIXELS], elsewhere[PIXELS];

/* The upper half of the picture is sky; of the lower one the left half is near light. */
static void begin(void)
{
	memset(&render, 0, sizeof render);
	memset(&job, 0, sizeof job);
	ts_params_default(&job.params);
	TS_PARAM_SET(&job.params, width, WIDTH);
	TS_PARAM_SET(&job.params, height, HEIGHT);
	render.job = &job;
	render.effect = "indirect";
	assert_int_equal(ts_methods_find(render.methods, &render.n_methods, "indirect", "hulls,direct"), TS_OK);
	for (u32 i = 0; i < PIXELS; i++) {
		seen[i] = i >= PIXELS / 2;
		near[i] = seen[i] && i % WIDTH < WIDTH / 2;
		elsewhere[i] = seen[i] && !near[i];
	}
}

/* A picture of light 1; where one of the marks is 0, 2 or 3. */
static void paint(ts_picture *picture, u32 at, const u8 *marks, f32 light)
{
	for (u32 i = 0; i < 3 * PIXELS; i++) {
		radiance[at][i] = marks != NULL && marks[i / 3] ? light : 1;
		srgb[at][i] = 100;
	}
	*picture = (ts_picture){.radiance = radiance[at], .srgb = srgb[at], .seen = seen};
}

static void light_is_compared_near_and_elsewhere(void **state)
{
	(void)state;
	begin();
	ts_picture *hulls = &render.pictures[0], *truth = &render.truths[0];
	paint(truth, 0, NULL, 1);
	paint(hulls, 1, elsewhere, 3);
	hulls->near = near;
	hulls->elsewhere = elsewhere;
	assert_int_equal(ts_render_compare(&render), TS_OK);
	assert_int_equal(render.n_pairs, 1);
	const ts_pair *pair = &render.pairs[0];
	assert_ptr_equal(pair->reference, truth);
	assert_ptr_equal(pair->image, hulls);
	assert_true(pair->parted);
	assert_int_equal(pair->light.pixels, PIXELS / 2);
	assert_int_equal(pair->near.pixels, PIXELS / 4);
	assert_int_equal(pair->elsewhere.pixels, PIXELS / 4);
	assert_true(pair->near.squares == 0 && pair->near.relative == 0);
	assert_true(pair->elsewhere.squares == 4.0 * 3 * PIXELS / 4 && pair->elsewhere.relative == 2);
	assert_true(pair->light.squares == pair->elsewhere.squares && pair->light.beyond == 0.5);
}

/* Without triangles of light there is one part; without frames before no flicker, and without mirrors none of them. */
static void without_lights_there_is_one_part(void **state)
{
	(void)state;
	begin();
	paint(&render.truths[0], 0, NULL, 1);
	paint(&render.pictures[0], 1, seen, 2);
	paint(&render.pictures[1], 2, near, 2);
	assert_int_equal(ts_render_compare(&render), TS_OK);
	assert_int_equal(render.n_pairs, 3);
	for (u32 i = 0; i < 3; i++) {
		assert_false(render.pairs[i].parted);
		assert_int_equal(render.pairs[i].near.pixels, 0);
		assert_int_equal(render.pairs[i].elsewhere.pixels, 0);
		assert_int_equal(render.pairs[i].reflective.pixels, 0);
		assert_int_equal(render.pairs[i].all.pixels, PIXELS);
		assert_true(isnan(render.pairs[i].flicker));
	}
	assert_true(render.pairs[0].light.relative == 1 && render.pairs[1].light.relative == sqrt(0.5));
	assert_ptr_equal(render.pairs[2].reference, &render.pictures[1]);
	assert_ptr_equal(render.pairs[2].image, &render.pictures[0]);
	assert_string_equal(render.pairs[2].share, "");
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(light_is_compared_near_and_elsewhere),
	                                   cmocka_unit_test(without_lights_there_is_one_part)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
