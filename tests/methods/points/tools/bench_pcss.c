/* The penumbra that tables of soft shadows print: the shadow of an edge halfway from the lamp, from both ends of a
 * diameter of the lamp, projected into the lamp's depth map. */
#include <math.h>
#include "kernels/raster/offscreen.h"
#include "methods/points/tools/benches.h"
#include "scene/lamp.h"
#include "scene/view.h"
#include "study/measure.h"
#include "tests/methods/small.h"
#include "tools/tools.h"

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

static ts_status look(ts_run *run, void *user)
{
	penumbra *p = user;
	ts_stand own[TS_N_STANDS];
	const ts_info *info = ts_frame_data(&run->frame, TS_B_scene_info);
	const ts_lamp *lamp = ts_frame_data(&run->frame, TS_B_lamp_shape);
	const ts_offscreen *view = ts_frame_data(&run->frame, TS_B_offscreen_view);
	const ts_stand *stands = run->scene->n_stands == TS_N_STANDS ? run->scene->stands : own;
	ts_lamp_stands(own, info);
	p->found = ts_bench_penumbra(run);
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
	if (ts_measure_run(&m, ts_pipeline_find(effect, method), scene, &params, &how, look, &p) != TS_OK)
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
	const struct CMUnitTest tests[] = {cmocka_unit_test(penumbras_are_as_wide_as_projected)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
