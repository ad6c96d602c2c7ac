/* Crumbs along depth edges: pixels of surfels that are coloured otherwise than the surface and all its neighbours
 * there, by a ball of triangles. Most are backs of surfels, for samples of two-sided triangles have a surfel on
 * either side. */
#include "surfels.h"
#include "../../../src/kernels/base/scene.h"
#include "../../../src/methods/surfels/tools/tools.h"

enum { SIDE = 160, COLUMNS = 40, ROWS = 20 };
#define CRUMB 0.1

static ts_v3 on_ball(u32 i, u32 k)
{
	f32 turn = (f32)i / COLUMNS, tilt = (f32)k / ROWS * 0.5f;
	return ts_v3_make(ts_sin_turn(tilt) * ts_cos_turn(turn), ts_cos_turn(tilt), ts_sin_turn(tilt) * ts_sin_turn(turn));
}

static u32 add_vertex(ts_build *build, u32 i, u32 k)
{
	ts_vertex v = {.colour = {1, 1, 1, 1}};
	ts_store3(v.position, on_ball(i, k));
	ts_store3(v.normal, on_ball(i, k));
	return ts_build_vertex(build, &v);
}

static ts_scene *ball(const ts_params *params, bool two_sided)
{
	ts_build *build = ts_build_new("ball");
	const ts_light sun = {.direction = {0.3f, -0.2f, -0.8f}, .intensity = {3, 3, 3}};
	ts_material paint = ts_material_default();
	paint.flags = two_sided ? TS_DOUBLE_SIDED : 0;
	u32 material = ts_build_material(build, &paint);
	ts_build_light(build, &sun);
	for (u32 i = 0; i < COLUMNS; i++) {
		for (u32 k = 0; k < ROWS; k++) {
			u32 v[4] = {add_vertex(build, i, k), add_vertex(build, i, k + 1), add_vertex(build, i + 1, k),
			            add_vertex(build, i + 1, k + 1)};
			if (k + 1 < ROWS) ts_build_triangle(build, v[0], v[3], v[1], material);
			if (k > 0) ts_build_triangle(build, v[0], v[2], v[3], material);
		}
	}
	return surfels_finish(build, params, ts_v3_make(0, 0, 3), 0.125f);
}

/* By more than CRUMB beyond all that the truth has at the pixel and beside it. */
static bool is_crumb(const f32 *radiance, const f32 *truth, u32 p)
{
	const i32 beside[5] = {0, -1, 1, -SIDE, SIDE};
	for (u32 k = 0; k < 3; k++) {
		double least = INFINITY, most = -INFINITY, value = (double)radiance[3 * p + k];
		for (u32 i = 0; i < 5; i++) {
			double known = (double)truth[3 * ((i32)p + beside[i]) + (i32)k];
			least = fmin(least, known);
			most = fmax(most, known);
		}
		if (value < least - CRUMB || value > most + CRUMB) return true;
	}
	return false;
}

static u32 crumbs_of(bool two_sided, const char *method)
{
	ts_run run;
	f32 *truth;
	u32 n = 0;
	ts_params params = small_params(SIDE, SIDE);
	params.reflectors_count = 0;
	params.surfels_from_mesh = 6000;
	params.truth_grid_rays = 8;
	ts_scene *scene = ball(&params, two_sided);
	if (ts_truth_surface(&truth, scene, &params, 2) != TS_OK) fail_msg("%s", ts_error_message());
	surfels_run(&run, scene, &params, method, 2);
	const f32 *radiance = ts_frame_data(&run.frame, TS_B_image_radiance);
	for (u32 p = SIDE; p < SIDE * (SIDE - 1); p++) n += is_crumb(radiance, truth, p);
	print_message("# %s, %s: %u crumbs\n", method, two_sided ? "two-sided" : "fronts alone", n);
	ts_run_end(&run);
	ts_scene_free(scene);
	free(truth);
	return n;
}

static void test_backs(void **state)
{
	(void)state;
	static const char *const methods[] = {"deferred", "ewa"};
	for (u32 i = 0; i < 2; i++) {
		u32 both = crumbs_of(true, methods[i]), fronts = crumbs_of(false, methods[i]);
		assert_true(both > 100 && 3 * fronts < 2 * both);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_backs)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
