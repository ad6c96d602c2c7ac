/* What tables look at beside figures: how large mirrors are in the picture, in closed form of their boxes; the largest
 * face; and penumbras: the shadow of an edge halfway from the lamp, from both ends of a diameter of the lamp, projected
 * into the lamp's depth map. */
#include <math.h>
#include "kernels/raster/offscreen.h"
#include "methods/points/tools/benches.h"
#include "scene/lamp.h"
#include "scene/view.h"
#include "study/measure.h"
#include "tests/methods/small.h"
#include "tools/tools.h"

static double look_at(const char *name, const ts_run *run)
{
	const ts_table_code *code = ts_points_codes;
	while (strcmp(code->name, name) != 0) code++;
	return code->look(run);
}

enum { MIRRORS = 4 };

/* An eye in the origin that looks along -z: what is at depth z is focal / z times as large in the picture. */
static void fill(ts_run *run)
{
	ts_view *eye = ts_frame_make1(&run->frame, TS_B_eye_view, 1);
	ts_face *cubes = ts_frame_make1(&run->frame, TS_B_cube_size_face, MIRRORS);
	assert_true(eye != NULL && cubes != NULL);
	*eye = (ts_view){.right = {1, 0, 0}, .up = {0, 1, 0}, .back = {0, 0, 1}, .focal = 100, .near = 0.01f};
	eye->width = 320;
	eye->height = 240;
	memset(cubes, 0, MIRRORS * sizeof *cubes);
	cubes[0] = (ts_face){.box_min = {-3, -1, -9}, .box_max = {5, 1, -4}, .n = 200}; /* 8 wide, 4 away */
	cubes[1] = (ts_face){.box_min = {-90, -90, -91}, .box_max = {90, 90, -1}};      /* out of sight */
	cubes[2] = (ts_face){.box_min = {1, -2, -8}, .box_max = {2, 7, -5}, .n = 16};   /* 9 high, 5 away */
	cubes[3] = (ts_face){.box_min = {6, 2, -25}, .box_max = {10, 6, -20}, .n = 16}; /* from 6 / 25 to 10 / 20 */
}

static void mirrors_are_as_large_as_their_boxes_in_the_picture(void **state)
{
	(void)state;
	ts_run run = {0};
	fill(&run);
	ts_face *cubes = ts_frame_data(&run.frame, TS_B_cube_size_face);
	double right = (800 / 4.0 + 900 / 5.0 + fmax(1000 / 20.0 - 600 / 25.0, 600 / 20.0 - 200 / 25.0)) / 3;
	assert_float_equal(look_at("projected_size", &run), right, 1e-4);
	for (u32 r = 0; r < 3; r++) cubes[r].n = 0;
	assert_float_equal(look_at("projected_size", &run), 26, 1e-4);
	cubes[3].n = 0;
	assert_true(isnan(look_at("projected_size", &run)));
	ts_frame_clear(&run.frame);
}

static void a_method_without_cubes_has_no_size(void **state)
{
	(void)state;
	ts_run run = {0};
	assert_true(isnan(look_at("projected_size", &run)));
	fill(&run);
	ts_frame_drop(&run.frame, TS_B_cube_size_face);
	assert_true(isnan(look_at("projected_size", &run)));
	ts_frame_clear(&run.frame);
}

static void a_run_without_a_lamp_has_no_penumbra(void **state)
{
	(void)state;
	ts_run run = {0};
	ts_params_default(&run.params);
	assert_true(isnan(look_at("penumbra", &run)));
}

static void the_largest_face_is_that_of_any_cube(void **state)
{
	(void)state;
	enum { CUBES = 5 };
	ts_run run = {0};
	assert_true(isnan(look_at("largest_face", &run)));
	ts_face *cubes = ts_frame_make1(&run.frame, TS_B_cube_size_face, CUBES);
	assert_non_null(cubes);
	for (u32 largest = 0; largest < CUBES; largest++) {
		for (u32 i = 0; i < CUBES; i++) cubes[i] = (ts_face){.n = i == largest ? 77 : 16 + i};
		assert_true(look_at("largest_face", &run) == 77);
	}
	ts_frame_cut(&run.frame, TS_B_cube_size_face, 2);
	cubes = ts_frame_data(&run.frame, TS_B_cube_size_face);
	assert_true(look_at("largest_face", &run) == 17);
	ts_frame_cut(&run.frame, TS_B_cube_size_face, 0);
	assert_true(isnan(look_at("largest_face", &run)));
	ts_frame_clear(&run.frame);
}

typedef struct {
	double found, spot, ball; /* texels */
} penumbra;

/* Where the shadow of the edge ends whose light is `aside` radii from the lamp's middle. */
static double end_of(const ts_offscreen *view, const ts_stand *stand, f32 radius, f32 aside)
{
	ts_v3 lamp = ts_load3(stand->position), target = ts_load3(stand->target);
	ts_v3 edge = ts_scale(ts_add(lamp, target), 0.5f);
	ts_v3 end = ts_mad(lamp, ts_load3(view->right), aside * radius);
	ts_v3 shadow = ts_add(edge, ts_sub(edge, end)); /* as far behind the edge */
	ts_camera_k k = ts_k_offscreen(view);
	ts_corner corner = ts_k_to_view(&k, shadow);
	return (double)ts_k_project(&k, &corner).x;
}

static ts_status take(ts_run *run, void *user)
{
	penumbra *p = user;
	ts_stand own[TS_N_STANDS];
	const ts_info *info = ts_frame_data(&run->frame, TS_B_scene_info);
	const ts_lamp *lamp = ts_frame_data(&run->frame, TS_B_lamp_shape);
	const ts_offscreen *view = ts_frame_data(&run->frame, TS_B_offscreen_view);
	const ts_stand *stands = run->scene->n_stands == TS_N_STANDS ? run->scene->stands : own;
	ts_lamp_stands(own, info);
	p->found = look_at("penumbra", run);
	p->spot =
		end_of(view, &stands[TS_STAND_SPOT], lamp->radius, -1) - end_of(view, &stands[TS_STAND_SPOT], lamp->radius, 1);
	p->ball = (double)(lamp->radius / ts_view_hall(info).half.y) * TS_PARAM(&run->params, depth_map_px);
	return TS_OK;
}

static penumbra penumbra_of(const char *effect, const char *method, f32 radius, u32 px)
{
	ts_params params = small_params(32, 18);
	TS_PARAM_SET(&params, lamp_radius, radius);
	TS_PARAM_SET(&params, depth_map_px, px);
	TS_PARAM_SET(&params, lamp_views, 1);
	TS_PARAM_SET(&params, lamp_cubes, 1);
	ts_scene *scene = small_scene(&params);
	ts_measure m = {.whole = true};
	penumbra p;
	const ts_how how = {.threads = 2};
	if (ts_measure_run(&m, ts_pipeline_find(effect, method), scene, &params, &how, take, &p) != TS_OK)
		fail_msg("%s", ts_error_message());
	ts_scene_free(scene);
	return p;
}

static void assert_near(double found, double wanted)
{
	if (!(fabs(found - wanted) < 1e-3 * wanted)) fail_msg("%g texels, not %g", found, wanted);
}

static void penumbras_are_as_wide_as_projected(void **state)
{
	(void)state;
	static const char *const methods[] = {"mvr", "pcss", "ivir"};
	for (u32 m = 0; m < 3; m++) {
		for (u32 px = 64; px <= 128; px *= 2) {
			penumbra p = penumbra_of("soft-shadows", methods[m], 0.0625f * (f32)(m + 1), px);
			assert_near(p.found, p.spot);
		}
	}
	penumbra p = penumbra_of("omni-shadows", "ivir", 0.0625f, 64);
	assert_near(p.found, p.ball);
}

int main(void)
{
	ts_tools_begin();
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(mirrors_are_as_large_as_their_boxes_in_the_picture),
		cmocka_unit_test(a_method_without_cubes_has_no_size),
		cmocka_unit_test(a_run_without_a_lamp_has_no_penumbra),
		cmocka_unit_test(the_largest_face_is_that_of_any_cube),
		cmocka_unit_test(penumbras_are_as_wide_as_projected),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
