/* Truth C: factor 1 is MVR itself, a greater one the means of a larger MVR, and what cannot be is refused. */
#include "kernels/base/num.h"
#include "methods/pipeline.h"
#include "methods/points/tools/tools.h"
#include "tests/status.h"
#include "tests/truth/soup.h"

enum { WIDTH = 64, HEIGHT = 48 };

static ts_params params;
static ts_scene *scene;

static int set_up(void **state)
{
	(void)state;
	ts_params_default(&params);
	params.width = WIDTH;
	params.height = HEIGHT;
	params.reflectors_count = 3;
	params.reflectors_px = 12;
	params.cube_max_px = 32;
	scene = soup_open(&params, 2000);
	return scene == NULL;
}

static int tear_down(void **state)
{
	(void)state;
	ts_scene_free(scene);
	return 0;
}

static f32 *truth_c(u32 factor, u32 threads)
{
	f32 *radiance;
	assert_int_equal(ts_truth_c(&radiance, scene, &params, factor, threads), TS_OK);
	return radiance;
}

/* MVR's own picture at these parameters; by free(). */
static f32 *mvr(const ts_params *with)
{
	size_t bytes = (size_t)with->width * with->height * 3 * sizeof(f32);
	ts_run run;
	ts_run_begin(&run, scene, with, 2);
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("reflections", "mvr"), &run), TS_OK);
	f32 *radiance = malloc(bytes);
	assert_non_null(radiance);
	memcpy(radiance, ts_frame_data(&run.frame, TS_B_image_radiance), bytes);
	ts_run_end(&run);
	return radiance;
}

static void factor_one_is_mvr_itself(void **state)
{
	(void)state;
	f32 *c = truth_c(1, 2), *m = mvr(&params);
	assert_memory_equal(c, m, sizeof(f32) * WIDTH * HEIGHT * 3);
	free(c);
	free(m);
}

/* By hand: four times four pixels of an enlarged MVR, and no dependence on threads. */
static void pixels_are_means_of_a_larger_mvr(void **state)
{
	(void)state;
	ts_params big = params;
	big.width *= 4;
	big.height *= 4;
	big.cube_max_px *= 4;
	big.cube_hysteresis *= 4;
	f32 *c = truth_c(4, 2), *again = truth_c(4, 1), *m = mvr(&big);
	for (u32 i = 0; i < WIDTH * HEIGHT * 3; i++) {
		u32 x = i / 3 % WIDTH, y = i / 3 / WIDTH;
		double sum = 0;
		for (u32 k = 0; k < 16; k++) sum += (double)m[((y * 4 + k / 4) * WIDTH * 4 + x * 4 + k % 4) * 3 + i % 3];
		assert_true(ts_abs((f32)(sum / 16) - c[i]) <= 1e-6f * (1 + c[i]));
	}
	assert_memory_equal(c, again, sizeof(f32) * WIDTH * HEIGHT * 3);
	free(c);
	free(again);
	free(m);
}

static void refuse(const ts_params *with, u32 factor, const char *words)
{
	f32 *radiance = (f32 *)&params;
	assert_int_equal(ts_truth_c(&radiance, scene, with, factor, 2), TS_ERROR);
	assert_null(radiance);
	says(words);
}

static void what_cannot_be_supersampled_is_refused(void **state)
{
	(void)state;
	refuse(&params, 0, "factor 0");
	refuse(&params, 17, "factor 17");
	ts_params wide = params;
	wide.width = 8192;
	refuse(&wide, 4, "width");
	wide = params;
	wide.cube_px = 4096;
	refuse(&wide, 2, "cube.px");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(factor_one_is_mvr_itself),
		cmocka_unit_test(pixels_are_means_of_a_larger_mvr),
		cmocka_unit_test(what_cannot_be_supersampled_is_refused),
	};
	return cmocka_run_group_tests(tests, set_up, tear_down);
}
