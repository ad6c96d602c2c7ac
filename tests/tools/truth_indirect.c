/* Truths of indirect light of several families: a scene in which they tend to each other as reflective shadow maps
 * grow. */
#include <math.h>
#include "methods/hulls/tools/tools.h"
#include "methods/raster/tools/truth_gather.h"
#include "methods/views/tools/tools.h"
#include "tests/model/test.h"

/* Means of irradiance over the picture: of the truths, and of `direct`, which asks for no visibility. */
typedef struct {
	double lights, bounce, vpls, direct;
} means;

static double mean(const ts_run *run)
{
	const f32 *e = ts_frame_data(&run->frame, TS_B_indirect_irradiance);
	u64 n = ts_frame_n(&run->frame, TS_B_indirect_irradiance);
	double sum = 0;
	for (u64 i = 0; i < n; i++) sum += (double)e[i];
	return sum / (double)n;
}

static means means_of(const ts_scene *scene, ts_params params, u32 rsm_px)
{
	ts_run run;
	ts_truth *truth;
	means m;
	params.rsm_px = rsm_px;
	params.truth_bounce_rays = 128;
	params.vpl_gather_near = 1;
	ts_run_begin(&run, scene, &params, 2);
	assert_int_equal(ts_truth_indirect_begin(&run, "indirect"), TS_OK);
	assert_int_equal(ts_run_stage(&run, ts_stage_find("direct")), TS_OK);
	m.direct = mean(&run);
	assert_int_equal(ts_truth_new(&truth, &run), TS_OK);
	assert_int_equal(ts_truth_lights(truth, &run, NULL), TS_OK);
	m.lights = mean(&run);
	assert_int_equal(ts_truth_bounce(truth, &run, NULL), TS_OK);
	m.bounce = mean(&run);
	assert_int_equal(ts_truth_vpls(truth, &run, NULL), TS_OK);
	m.vpls = mean(&run);
	ts_truth_free(truth);
	ts_run_end(&run);
	print_message("%u px: direct %.5f, lights %.5f, bounce %.5f, vpls %.5f\n", (unsigned)rsm_px, m.direct, m.lights,
	              m.bounce, m.vpls);
	return m;
}

static void truths_tend_to_each_other(void **state)
{
	(void)state;
	ts_scene *scene;
	ts_params params;
	ts_params_default(&params);
	params.width = 48;
	params.height = 27;
	params.reflectors_count = 0;
	if (ts_scene_load(&scene, "dining:triangles=10000:texels=32", &params, NULL) != TS_OK)
		fail_msg("%s", ts_error_message());
	means coarse = means_of(scene, params, 8), fine = means_of(scene, params, 48);
	ts_scene_free(scene);
	assert_true(fine.lights < fine.direct && coarse.lights < coarse.direct);
	assert_true(fabs(fine.lights / fine.bounce - 1) < 0.05);
	assert_true(fabs(fine.vpls / fine.lights - 1) < 0.05);
}

int main(void)
{
	const struct CMUnitTest indirect[] = {cmocka_unit_test(truths_tend_to_each_other)};
	return cmocka_run_group_tests(indirect, NULL, NULL);
}
