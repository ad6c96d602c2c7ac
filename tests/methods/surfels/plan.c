/* Plans of surfels: the scene's own lights, whatever is typed, and the filter of each method. */
#include "tests/methods/small.h"

static void surfels_plan_for_the_scenes_lights(void **state)
{
	(void)state;
	ts_params params = small_params(64, 36);
	ts_scene *scene = small_scene(&params);
	ts_counts counts = ts_scene_counts(scene);
	const ts_pipeline *deferred = ts_pipeline_find("surfels", "deferred"), *ewa = ts_pipeline_find("surfels", "ewa");
	ts_plan plan;
	assert_int_equal(params.lamp_source, TS_LAMP_LAMP);
	ts_plan_make(&plan, deferred, &params, &counts, NULL);
	assert_true(plan.lights.own && !plan.surfels.exact && plan.units == scene->n_lights);
	ts_plan_make(&plan, ewa, &params, &counts, NULL);
	assert_true(plan.lights.own && plan.surfels.exact && plan.units == scene->n_lights);
	ts_params taken = ts_pipeline_params(ewa, &params), wanted = params;
	wanted.lamp_source = TS_LAMP_SCENE;
	assert_memory_equal(&taken, &wanted, sizeof taken);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(surfels_plan_for_the_scenes_lights)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
