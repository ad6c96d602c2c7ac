/* The receding checkerboard of surfels, with each filter, against its supersampled pattern (FIGURES 12): what the
 * screen filter is for, how near its approximation comes to exact EWA, and how many fragments that takes. */
#include "kernels/surfels/surfel_setup.h"
#include "tests/methods/surfels/surfels.h"

/* The image of FIGURES 12 is the lower part of this: the horizon 20 rows above row TOP, its first four rows left
 * out. */
enum { WIDTH = 320, HEIGHT = 360, HORIZON = 180, TOP = 184, FAR_END = 210, MIDDLE_END = 250 };
#define FOCAL 220.0
#define SPACING 0.1

static double pattern(double x, double z) { return ((i64)floor(x * 2) + (i64)floor(z * 2)) & 1 ? 1 : 0; }

/* The mean of 12 x 12 samples. */
static double truth_at(u32 x, u32 y)
{
	double sum = 0;
	for (u32 k = 0; k < 144; k++) {
		double v = (y + (k / 12 + 0.5) / 12 - HORIZON) / FOCAL, u = (x + (k % 12 + 0.5) / 12 - WIDTH / 2) / FOCAL,
			   z = 1 / v;
		sum += pattern(u * z, z);
	}
	return sum / 144;
}

static ts_scene *board(const ts_params *params, double radius)
{
	ts_build *build = ts_build_new("board");
	double farthest = FOCAL / (TOP - HORIZON) * 1.3, nearest = FOCAL / (HEIGHT - HORIZON) * 0.8;
	surfels_random = 0;
	for (double z = nearest; z < farthest; z += SPACING) {
		for (double x = -0.8 * farthest; x < 0.8 * farthest; x += SPACING) {
			double px = x + (surfels_uniform() - 0.5) * SPACING * 0.3,
				   pz = z + (surfels_uniform() - 0.5) * SPACING * 0.3;
			if (fabs(FOCAL * px / pz) > WIDTH / 2 + 40) continue;
			f32 c = (f32)pattern(px, pz);
			surfels_add(build, ts_v3_make((f32)px, -1, (f32)-pz), ts_v3_make(0, 1, 0), (f32)(radius * SPACING), 1,
			            ts_v3_make(c, c, c));
		}
	}
	f32 yfov = (f32)(2 * atan(HEIGHT / (2 * FOCAL)) / (2 * 3.14159265358979));
	return surfels_finish(build, params, ts_v3_make(0, 0, 0), yfov);
}

typedef struct {
	double far, middle, near, fragments;
	u32 holes;
} figures;

static figures measure(const ts_scene *scene, const ts_params *params, const char *method, const char *name)
{
	ts_run run;
	figures f = {.far = 0};
	u64 fragments = 0;
	surfels_run(&run, scene, params, method, 2);
	const ts_gpixel *pixels = ts_frame_data(&run.frame, TS_B_gbuffer_pixel);
	const i64 *sums = ts_frame_data(&run.frame, TS_B_surfel_blend_sum);
	for (u32 y = TOP; y < HEIGHT; y++) {
		for (u32 x = 0; x < WIDTH; x++) {
			u32 p = y * WIDTH + x;
			double off = (double)pixels[p].albedo[0] - truth_at(x, y);
			double *band = y < FAR_END ? &f.far : y < MIDDLE_END ? &f.middle : &f.near;
			*band += off * off;
			fragments += (u64)sums[8 * p + 7];
			f.holes += sums[8 * p + 7] == 0;
		}
	}
	ts_run_end(&run);
	f.far = sqrt(f.far / ((FAR_END - TOP) * WIDTH));
	f.middle = sqrt(f.middle / ((MIDDLE_END - FAR_END) * WIDTH));
	f.near = sqrt(f.near / ((HEIGHT - MIDDLE_END) * WIDTH));
	f.fragments = (double)fragments / ((HEIGHT - TOP) * WIDTH);
	print_message("# %-16s far %.4f middle %.4f near %.4f, %.1f fragments a pixel\n", name, f.far, f.middle, f.near,
	              f.fragments);
	assert_int_equal(f.holes, 0);
	return f;
}

static ts_params board_params(void)
{
	ts_params params = small_params(WIDTH, HEIGHT);
	params.reflectors_count = 0;
	params.surfel_depth_epsilon = 1000; /* a plane hides nothing of itself */
	return params;
}

static void the_screen_filter_halves_the_far_error(void **state)
{
	(void)state;
	ts_params params = board_params();
	ts_scene *scene = board(&params, 1);
	figures least = measure(scene, &params, "deferred", "lesser radius"),
			ewa = measure(scene, &params, "ewa", "exact EWA");
	params.ewa_filter = TS_FILTER_OBJECT;
	figures object = measure(scene, &params, "deferred", "object filter");
	assert_true(object.far >= 2 * least.far);
	assert_true(fabs(least.far / ewa.far - 1) <= 0.1);
	assert_true(fabs(least.near / ewa.near - 1) <= 0.02 && fabs(object.near / ewa.near - 1) <= 0.02);
	ts_scene_free(scene);
}

static void filters_take_as_many_fragments_as_figured(void **state)
{
	(void)state;
	ts_params params = board_params();
	ts_scene *scene = board(&params, 1.5);
	figures one = measure(scene, &params, "deferred", "sigma 1");
	params.ewa_screen_radius = 1.41421356f;
	figures more = measure(scene, &params, "deferred", "sigma sqrt 2");
	params.ewa_filter = TS_FILTER_OBJECT;
	figures none = measure(scene, &params, "deferred", "object filter");
	assert_true(fabs(none.fragments / 7 - 1) <= 0.1);
	assert_true(fabs(one.fragments / 19 - 1) <= 0.1);
	assert_true(fabs(more.fragments / 33 - 1) <= 0.1);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(the_screen_filter_halves_the_far_error),
	                                   cmocka_unit_test(filters_take_as_many_fragments_as_figured)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
