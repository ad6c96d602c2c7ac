/* Plans: what each method derives from parameters, counts and requests, by the closed forms of its file; what a method
 * sets itself reaches its stages; a replay follows what a trace holds. */
#include "kernels/points/view_density.h"
#include "tests/methods/small.h"

static ts_params params;
static ts_scene *scene;

static int begin(void **state)
{
	(void)state;
	params = small_params(64, 36);
	scene = small_scene(&params);
	return 0;
}

static int end(void **state)
{
	(void)state;
	ts_scene_free(scene);
	return 0;
}

static const ts_pipeline *find(const char *effect, const char *method)
{
	const ts_pipeline *pipeline = ts_pipeline_find(effect, method);
	assert_non_null(pipeline);
	return pipeline;
}

static ts_plan plan_of(const char *effect, const char *method, const ts_params *p, const ts_counts *counts,
                       const ts_request *request)
{
	ts_run run;
	ts_run_begin(&run, scene, p, 1);
	const ts_params taken = ts_pipeline_params(find(effect, method), p);
	ts_pipeline_plan(find(effect, method), &run, counts, request);
	assert_memory_equal(&run.params, &taken, sizeof taken);
	assert_int_equal(run.n_units, run.plan.units);
	ts_run_end(&run);
	return run.plan;
}

/* Every member has one row, and rows tell what is there. */
static void each_member_has_one_row(void **state)
{
	(void)state;
	ts_plan plan;
	u32 n = TS_PLAN_ROWS;
	for (u32 i = 0; i < n; i++) ((u32 *)(void *)&plan)[i] = 100 + i;
	for (u32 i = 0; i < n; i++) {
		assert_int_equal(ts_plan_value(&plan, &ts_plan_table[i]), 100 + i);
		for (u32 k = 0; k < i; k++) {
			bool same = strcmp(ts_plan_table[i].part, ts_plan_table[k].part) == 0;
			assert_false(same && strcmp(ts_plan_table[i].name, ts_plan_table[k].name) == 0);
		}
	}
}

static void reflections_plan_by_their_method(void **state)
{
	(void)state;
	u32 n = scene->info.n_reflectors;
	ts_params p = params;
	ts_plan epr = plan_of("reflections", "epr", &p, NULL, NULL), mvr = plan_of("reflections", "mvr", &p, NULL, NULL);
	assert_true(n > 1 && epr.units == n && mvr.units == n && epr.batch == 1 && mvr.batch == 1);
	assert_true(epr.offscreen.side == 0 && !epr.offscreen.all && epr.points.rate == TS_RATE_EYE);
	assert_true(mvr.offscreen.side == p.cube_max_px && mvr.offscreen.all);
	p.cube_px = 48;
	p.density_rate = TS_DENSITY_RATE_PAPER;
	ts_plan ivir = plan_of("reflections", "ivir", &p, NULL, NULL), vir = plan_of("reflections", "vir", &p, NULL, NULL);
	assert_true(ivir.points.rate == TS_RATE_PAPER && ivir.offscreen.side == 0 && !ivir.offscreen.all);
	assert_true(vir.points.rate == TS_RATE_VIR && vir.offscreen.side == 48 && vir.offscreen.all);
	p.mvr_faces = TS_MVR_FACES_ADAPTIVE;
	mvr = plan_of("reflections", "mvr", &p, NULL, NULL);
	assert_true(mvr.offscreen.side == 0 && !mvr.offscreen.all);
}

static void shadows_plan_their_samples_and_maps(void **state)
{
	(void)state;
	ts_params p = params;
	p.lamp_views = 40;
	p.lamp_cubes = 7;
	p.lamp_views_a_pass = 20;
	p.depth_map_px = 96;
	ts_plan soft = plan_of("soft-shadows", "vir", &p, NULL, NULL),
			omni = plan_of("omni-shadows", "epr", &p, NULL, NULL);
	assert_true(soft.units == 40 && soft.lights.samples == 40 && soft.batch == 20 && soft.offscreen.side == 96);
	assert_true(omni.units == 7 && omni.lights.samples == 7 && omni.batch == 3 && omni.offscreen.side == 96);
	assert_true(soft.lights.taps == 0 && !soft.lights.own && soft.points.rate == TS_RATE_VIR);
	p.lamp_source = TS_LAMP_SCENE;
	ts_plan pcss = plan_of("soft-shadows", "pcss", &p, NULL, NULL);
	assert_true(pcss.units == scene->n_lights && pcss.lights.own && pcss.lights.taps > 1 && pcss.batch == 20);
}

static void truths_ask_for_samples_of_each_light(void **state)
{
	(void)state;
	const ts_request request = {.samples = 50};
	ts_params p = params;
	ts_plan soft = plan_of("soft-shadows", "mvr", &p, NULL, &request);
	ts_plan omni = plan_of("omni-shadows", "mvr", &p, NULL, &request);
	assert_true(soft.units == 50 && soft.lights.samples == 50 && omni.units == 50 && omni.lights.samples == 50);
	p.lamp_source = TS_LAMP_SCENE;
	soft = plan_of("soft-shadows", "mvr", &p, NULL, &request);
	assert_int_equal(soft.units, 50 * scene->n_lights);
	const ts_counts counts = {.reflectors = 0, .lights = 3, .cubes = TS_NONE, .views = TS_NONE, .lamps = TS_NONE};
	assert_int_equal(plan_of("soft-shadows", "mvr", &p, &counts, &request).units, 150);
}

/* The radiance of the picture. */
static void picture_of(f32 *radiance, const ts_pipeline *pipeline, const ts_params *p)
{
	ts_run run;
	ts_run_begin(&run, scene, p, 1);
	assert_int_equal(ts_pipeline_run(pipeline, &run), TS_OK);
	memcpy(radiance, ts_frame_data(&run.frame, TS_B_image_radiance), 64 * 36 * 3 * sizeof *radiance);
	ts_run_end(&run);
}

/* The example of RECIPES: its picture is that of --set, whatever is typed. */
static void pictures_show_what_a_method_sets(void **state)
{
	(void)state;
	static f32 plain[64 * 36 * 3], asked[64 * 36 * 3], own[64 * 36 * 3];
	const ts_pipeline *mvr = find("reflections", "mvr");
	ts_pipeline supersample = *mvr;
	supersample.steps = ts_pipeline_steps(mvr);
	supersample.sets.param = "mvr.filter";
	supersample.sets.value = "supersample";
	ts_params p = params;
	picture_of(plain, mvr, &p);
	picture_of(own, &supersample, &p);
	p.mvr_filter = TS_MVR_SUPERSAMPLE;
	picture_of(asked, mvr, &p);
	assert_memory_equal(own, asked, sizeof own);
	assert_memory_not_equal(own, plain, sizeof own);
}

static void plans_have_what_a_method_sets(void **state)
{
	(void)state;
	ts_plan plan = plan_of("particles", "manylods", &params, NULL, NULL);
	assert_int_equal(params.view_map_field, TS_VIEW_FIELD_HALF);
	assert_true(plan.views.field == TS_VIEW_FIELD_ALL && plan.units == 0);
	assert_int_equal(plan_of("indirect", "manylods", &params, NULL, NULL).views.field, TS_VIEW_FIELD_HALF);
	ts_params taken = ts_pipeline_params(find("particles", "manylods"), &params), wanted = params;
	wanted.view_map_field = TS_VIEW_FIELD_ALL;
	assert_memory_equal(&taken, &wanted, sizeof taken);
}

static void units_are_those_that_a_trace_holds(void **state)
{
	(void)state;
	ts_counts none = ts_scene_counts(scene), counts = none;
	ts_plan plan = plan_of("reflections", "epr", &params, &none, NULL);
	ts_plan same = plan_of("reflections", "epr", &params, NULL, NULL);
	assert_memory_equal(&plan, &same, sizeof plan);
	counts.cubes = 2;
	counts.views = 12;
	counts.lamps = 3;
	assert_int_equal(plan_of("reflections", "epr", &params, &counts, NULL).units, 2);
	assert_int_equal(plan_of("omni-shadows", "ivir", &params, &counts, NULL).units, 2);
	assert_int_equal(plan_of("soft-shadows", "ivir", &params, &counts, NULL).units, 12);
	counts = none;
	counts.lamps = 3;
	assert_int_equal(plan_of("soft-shadows", "pcss", &params, &counts, NULL).units, 3);
	assert_int_equal(plan_of("soft-shadows", "mvr", &params, &counts, NULL).units, params.lamp_views);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_member_has_one_row),
		cmocka_unit_test(reflections_plan_by_their_method),
		cmocka_unit_test(shadows_plan_their_samples_and_maps),
		cmocka_unit_test(truths_ask_for_samples_of_each_light),
		cmocka_unit_test(pictures_show_what_a_method_sets),
		cmocka_unit_test(plans_have_what_a_method_sets),
		cmocka_unit_test(units_are_those_that_a_trace_holds),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
