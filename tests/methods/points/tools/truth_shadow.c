/* Truth of shadows: closed forms of a square and of a half plane between lamps and a floor, what stops light and what
 * does not, MVR, which tends to it as its depth maps grow, and more samples than an index holds. */
#include <math.h>
#include "kernels/base/shade.h"
#include "methods/pipeline.h"
#include "methods/points/tools/tools.h"
#include "scene/lamp.h"
#include "tests/model/test.h"
#include "tests/truth/world.h"

enum { SIDE = 64, TOP = 4 }; /* pixels of the eye; height of the lamps */

/* A floor at y = 0, seen from y = 1 straight down to 2 on each side; x to the right, z down in the image. */
static world *world_new(void)
{
	world *w = malloc(sizeof *w);
	assert_non_null(w);
	world_begin(w);
	world_quad(w, ts_v3_make(-9, 0, -9), ts_v3_make(-9, 0, 9), ts_v3_make(9, 0, 9), ts_v3_make(9, 0, -9), ONE_SIDED, 0);
	return w;
}

/* A rectangle at height y, its front up or down. */
static void cover(world *w, f32 y, f32 x0, f32 x1, f32 z, u32 material, bool up)
{
	ts_v3 a = ts_v3_make(x0, y, -z), b = ts_v3_make(x0, y, z), c = ts_v3_make(x1, y, z), d = ts_v3_make(x1, y, -z);
	if (up)
		world_quad(w, a, b, c, d, material, 0);
	else
		world_quad(w, a, d, c, b, material, 0);
}

static void see(world *w)
{
	world_pose(w);
	w->run.params.width = w->run.params.height = SIDE;
	ts_view *eye = ts_frame_make1(&w->run.frame, TS_B_eye_view, 1);
	*eye = (ts_view){.eye = {0, 1, 0},
	                 .right = {1, 0, 0},
	                 .up = {0, 0, -1},
	                 .back = {0, 1, 0},
	                 .near = 0.001f,
	                 .focal = SIDE / 4.0f,
	                 .width = SIDE,
	                 .height = SIDE};
	assert_int_equal(ts_run_stage(&w->run, ts_stage_find("eye")), TS_OK);
}

/* Where the floor is that a row or column of pixels sees. */
static double place(u32 pixel) { return (pixel + 0.5 - SIDE / 2) / (SIDE / 4.0); }

static ts_offscreen *make_views(world *w, u32 n)
{
	ts_lamp *lamp = ts_frame_make1(&w->run.frame, TS_B_lamp_shape, 1);
	*lamp = (ts_lamp){.samples = n};
	return ts_frame_make1(&w->run.frame, TS_B_offscreen_view, n);
}

/* A lamp in one point, whose depth map shows what is within `reach` a unit ahead. */
static void look_down(world *w, ts_v3 eye, f32 reach)
{
	ts_offscreen *view = make_views(w, 1);
	*view = (ts_offscreen){.focal = 32 / reach,
	                       .right = {1, 0, 0},
	                       .up = {0, 0, -1},
	                       .back = {0, 1, 0},
	                       .near = 0.001f,
	                       .width = SIDE,
	                       .height = SIDE,
	                       .reach = {reach, reach},
	                       .object = TS_NONE};
	ts_store3(view->eye, eye);
}

static const u32 *resolve(world *w)
{
	ts_truth *truth;
	assert_int_equal(ts_truth_new(&truth, &w->run), TS_OK);
	assert_int_equal(ts_truth_samples(truth, &w->run, NULL), TS_OK);
	ts_truth_free(truth);
	return ts_frame_data(&w->run.frame, TS_B_shadow_test_lit);
}

static void end(world *w)
{
	ts_run_end(&w->run);
	free(w);
}

/* Half way down, a square of 1/2 throws a shadow of 1; past the image of the depth map it is not known, and lit. */
static void check_square(f32 reach)
{
	world *w = world_new();
	cover(w, TOP / 2, -0.25f, 0.25f, 0.25f, TWO_SIDED, true);
	see(w);
	look_down(w, ts_v3_make(0, TOP, 0), reach);
	const u32 *lit = resolve(w);
	double border = fmin(0.5, (double)reach * TOP);
	for (u32 i = 0; i < SIDE * SIDE; i++) {
		double far = fmax(fabs(place(i % SIDE)), fabs(place(i / SIDE)));
		assert_true(fabs(far - border) > 1e-3);
		assert_int_equal(lit[i], far > border);
	}
	end(w);
}

static void a_square_casts_twice_its_size(void **state)
{
	(void)state;
	check_square(1);
	check_square(0.11f);
}

/* Lit pixels under a cover of all of the floor at height y; none if that is negative. */
static u32 lit_below(f32 y, u32 material, bool up, f32 lamp_y)
{
	world *w = world_new();
	if (y >= 0) cover(w, y, -9, 9, 9, material, up);
	see(w);
	look_down(w, ts_v3_make(0, lamp_y, 0), 1000);
	const u32 *lit = resolve(w);
	u32 n = 0;
	for (u32 i = 0; i < SIDE * SIDE; i++) n += lit[i];
	end(w);
	return n;
}

/* What turns its back to the lamp stops no light, as depth maps have it. */
static void backs_stop_no_light(void **state)
{
	(void)state;
	const u32 all = SIDE * SIDE;
	assert_int_equal(lit_below(2, ONE_SIDED, true, TOP), 0);
	assert_int_equal(lit_below(2, ONE_SIDED, false, TOP), all);
	assert_int_equal(lit_below(2, TWO_SIDED, false, TOP), 0);
	assert_int_equal(lit_below(2, CUT, true, TOP), all);
	assert_int_equal(lit_below(2, UNCUT, true, TOP), 0);
	assert_int_equal(lit_below(TOP + 1, TWO_SIDED, true, TOP), all);
	assert_int_equal(lit_below(TOP - 0.0005f, TWO_SIDED, true, TOP), all); /* before the near plane */
}

/* A floor does not shade itself, however low the lamp; what lies on it by a hair does. The eye is below the cover
 * then. */
static void a_floor_does_not_shade_itself(void **state)
{
	(void)state;
	assert_int_equal(lit_below(-1, 0, true, 0.01f), SIDE * SIDE);
	world *w = world_new();
	cover(w, 0.0001f, -9, 9, 9, ONE_SIDED, false);
	cover(w, 0.0002f, -9, 9, 9, ONE_SIDED, true);
	see(w);
	look_down(w, ts_v3_make(0, TOP, 0), 10);
	ts_view *eye = ts_frame_data(&w->run.frame, TS_B_eye_view);
	const u64 *seen = ts_frame_data(&w->run.frame, TS_B_eye_depth_triangle);
	assert_true((u32)seen[0] / 2 == 2); /* the eye sees the upper one, which nothing shades */
	assert_int_equal(resolve(w)[0], 1);
	eye->eye[1] = 0.00015f;
	eye->near = 0.000001f;
	assert_int_equal(ts_run_stage(&w->run, ts_stage_find("eye")), TS_OK);
	seen = ts_frame_data(&w->run.frame, TS_B_eye_depth_triangle);
	assert_true((u32)seen[0] / 2 == 0); /* now the floor, through the backs of both */
	const u32 *lit = resolve(w);
	for (u32 i = 0; i < SIDE * SIDE; i++) assert_int_equal(lit[i], 0);
	end(w);
}

/* The part of a disc of radius 1 beyond a line at -t from its middle. */
static double beyond(double t)
{
	t = fmax(-1, fmin(1, t));
	return 0.5 + (asin(t) + t * sqrt(1 - t * t)) / acos(-1);
}

/* The views of an area light that shines down, as the methods' are made. */
static void shine_down(world *w, u32 kind, f32 radius, u32 n)
{
	const ts_lens lens = {.side = 512, .fov = 120};
	ts_light light = {.kind = kind, .position = {0, TOP, 0}, .direction = {0, -1, 0}};
	ts_info info = {.box_min = {-9, 0, -9}, .box_max = {9, TOP, 9}, .hall_min = {-9, -9}, .hall_max = {9, 9}};
	ts_offscreen *views = make_views(w, n);
	for (u32 k = 0; k < n; k++) {
		ts_lamp_view(&views[k], &light, radius, k, n, &info, &lens);
		views[k].light = 0;
	}
}

/* A half plane over x < 0 at half the height: from the floor at x its edge cuts the disc at -x, the sun at -x / TOP. */
static void check_penumbra(u32 kind, f32 radius, double scale)
{
	enum { N = 1024 };
	world *w = world_new();
	cover(w, TOP / 2, -9, 0, 9, TWO_SIDED, true);
	see(w);
	shine_down(w, kind, radius, N);
	const u32 *lit = resolve(w);
	double sum = 0;
	u32 soft = 0;
	for (u32 i = 0; i < SIDE * SIDE; i++) {
		double share = beyond(place(i % SIDE) / scale), error = fabs((double)lit[i] / N - share);
		soft += share > 0 && share < 1;
		sum += error;
		assert_true(error < 0.01);
	}
	print_message("kind %u: %u pixels in penumbra, mean error %.5f\n", (unsigned)kind, (unsigned)soft,
	              sum / (SIDE * SIDE));
	assert_true(soft > SIDE * SIDE / 4 && sum / (SIDE * SIDE) < 0.002);
	end(w);
}

static void a_half_plane_casts_its_penumbra(void **state)
{
	(void)state;
	check_penumbra(TS_LIGHT_KIND_SPOT, 1, 1);
	check_penumbra(TS_LIGHT_KIND_DIRECTIONAL, 0.5f, 0.5 * TOP / 2);
}

static ts_params small_params(void)
{
	ts_params p;
	ts_params_default(&p);
	p.width = 160;
	p.height = 90;
	p.reflectors_count = 0;
	p.lamp_views = p.lamp_cubes = 4;
	p.truth_area_samples = 4;
	return p;
}

/* Root of the mean square of what is lit apart, of all samples. */
static double apart(const u32 *a, const u32 *b, u64 n, u32 samples)
{
	double sum = 0;
	for (u64 i = 0; i < n; i++) sum += pow(((double)a[i] - (double)b[i]) / samples, 2);
	return sqrt(sum / (double)n);
}

static double mvr_apart(const char *effect, const ts_scene *scene, const ts_params *params, u32 map_px, const u32 *lit)
{
	ts_run run;
	ts_run_begin(&run, scene, params, 2);
	run.params.depth_map_px = map_px;
	assert_int_equal(ts_pipeline_run(ts_pipeline_find(effect, "mvr"), &run), TS_OK);
	const u32 *mvr = ts_frame_data(&run.frame, TS_B_shadow_test_lit);
	double rms = apart(mvr, lit, ts_frame_n(&run.frame, TS_B_shadow_test_lit), params->lamp_views);
	print_message("%s of %s: maps of %u px: %.4f apart\n", effect, scene->name, (unsigned)map_px, rms);
	ts_run_end(&run);
	return rms;
}

/* As many samples of the area as the methods have are the very same; more are others. */
static void check_area(ts_truth *truth, ts_run *run, const u32 *lit)
{
	u64 n = ts_frame_n(&run->frame, TS_B_shadow_test_lit);
	assert_int_equal(ts_truth_area(truth, run, NULL), TS_OK);
	assert_memory_equal(ts_frame_data(&run->frame, TS_B_shadow_test_lit), lit, n * sizeof *lit);
	run->params.truth_area_samples = 64;
	assert_int_equal(ts_truth_area(truth, run, NULL), TS_OK);
	const ts_lamp *lamp = ts_frame_data(&run->frame, TS_B_lamp_shape);
	const u32 *area = ts_frame_data(&run->frame, TS_B_shadow_test_lit);
	u64 finer = 0;
	assert_int_equal(lamp->samples, 64);
	for (u64 i = 0; i < n; i++) {
		assert_true(area[i] <= 64);
		finer += area[i] % 16 != 0;
	}
	assert_true(finer > n / 200);
}

static void check_effect(const char *effect, const char *spec)
{
	ts_scene *scene;
	ts_run run;
	ts_truth *truth;
	ts_params params = small_params();
	if (ts_scene_load(&scene, spec, &params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	ts_run_begin(&run, scene, &params, 2);
	assert_int_equal(ts_truth_shadow_begin(&run, effect), TS_OK);
	assert_int_equal(ts_truth_new(&truth, &run), TS_OK);
	assert_int_equal(ts_truth_samples(truth, &run, NULL), TS_OK);
	u64 n = ts_frame_n(&run.frame, TS_B_shadow_test_lit);
	u32 *lit = malloc(n * sizeof *lit);
	assert_non_null(lit);
	memcpy(lit, ts_frame_data(&run.frame, TS_B_shadow_test_lit), n * sizeof *lit);
	double coarse = mvr_apart(effect, scene, &params, 64, lit), fine = mvr_apart(effect, scene, &params, 1024, lit);
	assert_true(fine > 0 && fine < 0.1 && fine < coarse / 2);
	check_area(truth, &run, lit);
	free(lit);
	ts_truth_free(truth);
	ts_run_end(&run);
	ts_scene_free(scene);
}

static void soft_shadows_tend_to_the_truth(void **state) { check_effect("soft-shadows", *state); }
static void omni_shadows_tend_to_the_truth(void **state) { check_effect("omni-shadows", *state); }

/* The product of samples and lights fits no index of views; in 32 bits it may be anything, of the first pair 0. */
static void check_too_many(u32 n_lamps, const char *message)
{
	world *w = world_new();
	see(w);
	ts_frame_make1(&w->run.frame, TS_B_lamp_shape, n_lamps);
	w->run.params.truth_area_samples = 65536;
	ts_truth *truth;
	assert_int_equal(ts_truth_new(&truth, &w->run), TS_OK);
	assert_int_equal(ts_truth_area(truth, &w->run, NULL), TS_ERROR);
	assert_string_equal(ts_error_message(), message);
	ts_truth_free(truth);
	end(w);
}

static void too_many_samples_are_refused(void **state)
{
	(void)state;
	check_too_many(65536, "truth.area_samples=65536: of 65536 lights at most 16 each would be right");
	check_too_many(17, "truth.area_samples=65536: of 17 lights at most 61680 each would be right");
}

int main(void)
{
	static char atrium[] = "atrium:triangles=10000:texels=32", gallery[] = "gallery:triangles=10000:texels=32";
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_square_casts_twice_its_size),
		cmocka_unit_test(backs_stop_no_light),
		cmocka_unit_test(a_floor_does_not_shade_itself),
		cmocka_unit_test(a_half_plane_casts_its_penumbra),
		cmocka_unit_test(too_many_samples_are_refused),
		{"soft: atrium", soft_shadows_tend_to_the_truth, NULL, NULL, atrium},
		{"omni: gallery", omni_shadows_tend_to_the_truth, NULL, NULL, gallery},
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
