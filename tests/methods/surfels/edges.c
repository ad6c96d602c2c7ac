/* Crumbs along depth edges: pixels of surfels that are coloured otherwise than the surface and all its neighbours
 * there, by a ball of two-sided triangles. Most are backs of surfels, which surfels.sides=front leaves out. */
#include <touchstone/image.h>
#include "kernels/base/scene.h"
#include "kernels/surfels/surfel_setup.h"
#include "methods/surfels/tools/tools.h"
#include "tests/methods/surfels/surfels.h"

enum { SIDE = 160, COLUMNS = 40, ROWS = 20 };

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

static ts_scene *ball(const ts_params *params)
{
	ts_build *build = ts_build_new("ball");
	const ts_light sun = {.direction = {0.3f, -0.2f, -0.8f}, .intensity = {3, 3, 3}};
	ts_material paint = ts_material_default();
	paint.flags = TS_DOUBLE_SIDED;
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

static u32 crumbs_of(u32 sides, const char *method)
{
	ts_run run;
	f32 *truth;
	ts_params params = small_params(SIDE, SIDE);
	params.reflectors_count = 0;
	params.surfels_from_mesh = 6000;
	params.surfels_sides = sides;
	params.ewa_outline = TS_OUTLINE_FILTER;
	params.truth_grid_rays = 4;
	ts_scene *scene = ball(&params);
	if (ts_truth_surface(&truth, scene, &params, 2, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	surfels_run(&run, scene, &params, method, 2);
	const f32 *radiance = ts_frame_data(&run.frame, TS_B_image_radiance);
	u32 n = (u32)ts_metrics_crumbs(NULL, truth, radiance, SIDE, SIDE);
	print_message("# %s, %s: %u crumbs\n", method, sides == TS_SIDES_MATERIAL ? "both sides" : "fronts alone", n);
	ts_run_end(&run);
	ts_scene_free(scene);
	free(truth);
	return n;
}

/* Pixels that show a surfel. */
static u32 cover(const ts_scene *scene, const ts_params *params, bool *covered)
{
	ts_run run;
	u32 n = 0;
	surfels_run(&run, scene, params, "deferred", 2);
	const u64 *heaviest = ts_frame_data(&run.frame, TS_B_surfel_blend_heaviest);
	for (u32 i = 0; i < SIDE * SIDE; i++) n += covered[i] = heaviest[i] != TS_EMPTY;
	ts_run_end(&run);
	return n;
}

/* The screen filter makes no outline wider; with ewa.outline=filter it does, everywhere. */
static void the_screen_filter_widens_no_outline(void **state)
{
	(void)state;
	static bool object[SIDE * SIDE], both[SIDE * SIDE], wider[SIDE * SIDE];
	ts_params params = small_params(SIDE, SIDE);
	params.reflectors_count = 0;
	params.surfels_from_mesh = 6000;
	ts_scene *scene = ball(&params);
	params.ewa_filter = TS_FILTER_OBJECT;
	u32 n_object = cover(scene, &params, object);
	params.ewa_filter = TS_FILTER_MIN;
	u32 n_both = cover(scene, &params, both);
	params.ewa_outline = TS_OUTLINE_FILTER;
	u32 n_wider = cover(scene, &params, wider);
	assert_int_equal(n_object, n_both);
	assert_memory_equal(object, both, sizeof both);
	for (u32 i = 0; i < SIDE * SIDE; i++) assert_true(wider[i] || !both[i]);
	print_message("# %u pixels, %u with the screen filter's own\n", n_both, n_wider);
	assert_true((double)(n_wider - n_both) > 0.4 * 2 * 3.14159 * sqrt(n_both / 3.14159));
	ts_scene_free(scene);
}

static void fronts_alone_leave_fewer_crumbs(void **state)
{
	(void)state;
	static const char *const methods[] = {"deferred", "ewa"};
	for (u32 i = 0; i < 2; i++) {
		u32 both = crumbs_of(TS_SIDES_MATERIAL, methods[i]), fronts = crumbs_of(TS_SIDES_FRONT, methods[i]);
		assert_true(both > 100 && 3 * fronts < 2 * both);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(the_screen_filter_widens_no_outline),
	                                   cmocka_unit_test(fronts_alone_leave_fewer_crumbs)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
