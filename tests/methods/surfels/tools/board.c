/* The filters of surfels by the truth of the built-in checkerboard: where its squares are small the screen filter
 * halves the error at least, and its approximation is as good as exact EWA (FIGURES 12). The same geometry as there,
 * twice as large: 5 surfels a square. */
#include "../surfels.h"
#include "../../../../src/methods/surfels/tools/tools.h"

enum { WIDTH = 320, HEIGHT = 180 };
#define FARTHEST 110.0
#define NEAREST 15.0

/* The pixel's middle shows the board, far from its sides, in the band between these distances. */
static bool is_far(u32 p)
{
	double f = HEIGHT / 2.0 / tan(acos(-1) / 8), i = (p % WIDTH + 0.5 - WIDTH / 2.0) / f;
	double down = (p / WIDTH + 0.5 - HEIGHT / 2.0) / f, angle = atan(down) + atan(0.125);
	double z = 2 / tan(angle), x = i * z;
	return angle > 0 && z > NEAREST && z < FARTHEST && fabs(x) < 30;
}

static double error_of(const ts_scene *scene, const ts_params *params, const char *method, const f32 *truth)
{
	ts_run run;
	u32 n = 0;
	double sum = 0;
	surfels_run(&run, scene, params, method, 2);
	const f32 *radiance = ts_frame_data(&run.frame, TS_B_image_radiance);
	for (u32 p = 0; p < WIDTH * HEIGHT; p++) {
		if (!is_far(p)) continue;
		double off = (double)radiance[3 * p] - (double)truth[3 * p];
		sum += off * off;
		n++;
	}
	assert_true(n > 4000);
	ts_run_end(&run);
	return sqrt(sum / n);
}

static void test_far_band(void **state)
{
	(void)state;
	f32 *truth;
	ts_scene *scene;
	ts_params params = small_params(WIDTH, HEIGHT);
	params.reflectors_count = 0;
	params.surfel_depth_epsilon = 1000; /* a plane hides nothing of itself */
	params.surfels_radius = 1;
	params.truth_grid_rays = 12;
	if (ts_scene_open(&scene, "checkerboard:surfels=409600", &params, NULL) != TS_OK)
		fail_msg("%s", ts_error_message());
	if (ts_truth_surface(&truth, scene, &params, 2) != TS_OK) fail_msg("%s", ts_error_message());
	double least = error_of(scene, &params, "deferred", truth), ewa = error_of(scene, &params, "ewa", truth);
	params.ewa_filter = TS_FILTER_OBJECT;
	double object = error_of(scene, &params, "deferred", truth);
	print_message("# object filter %.4f, lesser radius %.4f, exact EWA %.4f\n", object, least, ewa);
	assert_true(object >= 2 * least);
	assert_true(fabs(least / ewa - 1) <= 0.1);
	free(truth);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_far_band)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
