/* The filters of surfels by the truth of the built-in checkerboard: where its squares are small the screen filter
 * halves the error at least, and its approximation is as good as exact EWA (FIGURES 12). The same geometry as there,
 * twice as large: 5 surfels a square. And of the truth itself: its few rays make noise there, and no moire. */
#include "kernels/surfels/surfel_setup.h"
#include "methods/surfels/tools/tools.h"
#include "tests/methods/surfels/surfels.h"

enum { WIDTH = 320, HEIGHT = 180 };
/* The pixel's middle shows the board, far from its sides, in the band between these distances. */
static bool is_between(u32 p, double nearest, double farthest)
{
	double f = HEIGHT / 2.0 / tan(acos(-1) / 8), i = (p % WIDTH + 0.5 - WIDTH / 2.0) / f;
	double down = (p / WIDTH + 0.5 - HEIGHT / 2.0) / f, angle = atan(down) + atan(0.125);
	double z = 2 / tan(angle), x = i * z;
	return angle > 0 && z > nearest && z < farthest && fabs(x) < 30;
}

static f32 *truth_of(const ts_scene *scene, const ts_params *params, u32 threads)
{
	f32 *truth;
	if (ts_truth_surface(&truth, scene, params, threads, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	return truth;
}

static double error_of(const ts_scene *scene, const ts_params *params, const char *method, const f32 *truth)
{
	ts_run run;
	u32 n = 0;
	double sum = 0;
	surfels_run(&run, scene, params, method, 2);
	const f32 *radiance = ts_frame_data(&run.frame, TS_B_image_radiance);
	for (u32 p = 0; p < WIDTH * HEIGHT; p++) {
		if (!is_between(p, 15, 110)) continue;
		double off = (double)radiance[3 * p] - (double)truth[3 * p];
		sum += off * off;
		n++;
	}
	assert_true(n > 4000);
	ts_run_end(&run);
	return sqrt(sum / n);
}

static void the_screen_filter_halves_far_errors(void **state)
{
	(void)state;
	ts_scene *scene;
	ts_params params = small_params(WIDTH, HEIGHT);
	params.reflectors_count = 0;
	params.surfel_depth_epsilon = 1000; /* a plane hides nothing of itself */
	params.surfels_radius = 1;
	params.truth_grid_rays = 12;
	if (ts_scene_load(&scene, "checkerboard:surfels=409600", &params, NULL) != TS_OK)
		fail_msg("%s", ts_error_message());
	f32 *truth = truth_of(scene, &params, 2);
	double least = error_of(scene, &params, "deferred", truth), ewa = error_of(scene, &params, "ewa", truth);
	params.ewa_filter = TS_FILTER_OBJECT;
	double object = error_of(scene, &params, "deferred", truth);
	print_message("# object filter %.4f, lesser radius %.4f, exact EWA %.4f\n", object, least, ewa);
	assert_true(object >= 2 * least);
	assert_true(fabs(least / ewa - 1) <= 0.1);
	free(truth);
	ts_scene_free(scene);
}

/* Radiance of the board by its albedo: ambient and the sun's, without the highlight. */
static double radiance_of(const ts_scene *scene, double albedo)
{
	const ts_light *sun = &scene->lights[0];
	const f32 *d = sun->direction;
	assert_int_equal(scene->n_lights, 1);
	double cosine = -(double)d[1] / sqrt((double)(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
	return albedo * ((double)scene->info.ambient + cosine * (double)sun->intensity[0] / acos(-1));
}

/* Where cells hold several rows of squares a ray meets light or dark, each by a half: pixels have the mean of both, and
 * deviate as means of that many coins do, each for itself. */
static void the_truth_is_as_noisy_as_coins(void **state)
{
	(void)state;
	enum { SIDE = 2 };
	ts_scene *scene;
	ts_params params = small_params(WIDTH, HEIGHT);
	params.reflectors_count = 0;
	params.truth_grid_rays = SIDE;
	if (ts_scene_load(&scene, "checkerboard:surfels=10000", &params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	f32 *truth = truth_of(scene, &params, 2), *again = truth_of(scene, &params, 1);
	assert_memory_equal(truth, again, sizeof *truth * 3 * WIDTH * HEIGHT);
	double light = radiance_of(scene, 0.75), dark = radiance_of(scene, 0.0625), half = (light - dark) / 2;
	double sum = 0, squares = 0, beside = 0;
	u32 n = 0, n_beside = 0;
	for (u32 p = 0; p < WIDTH * HEIGHT; p++) {
		if (!is_between(p, 80, 250)) continue;
		double off = (double)truth[3 * p] - (light + dark) / 2, next = (double)truth[3 * p + 3] - (light + dark) / 2;
		sum += off / half;
		squares += off * off / (half * half);
		n++;
		if (!is_between(p + 1, 80, 250)) continue;
		beside += off * next / (half * half);
		n_beside++;
	}
	double spread = sqrt(squares / n), alike = beside / n_beside / (squares / n);
	print_message("# %u pixels: mean %.3f, deviation %.3f of %.3f, with the next %.3f\n", n, sum / n, spread,
	              1.0 / SIDE, alike);
	assert_true(n > 300);
	assert_true(fabs(sum / n) < 4 * spread / sqrt(n));
	assert_true(fabs(spread * SIDE - 1) < 4 / sqrt(2.0 * n));
	assert_true(fabs(alike) < 4 / sqrt(n));
	free(truth);
	free(again);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(the_screen_filter_halves_far_errors),
	                                   cmocka_unit_test(the_truth_is_as_noisy_as_coins)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
