/* The checkerboard of surfels: how many, where, how large and of what colour; and what the command says of it. */
#include <math.h>
#include "kernels/base/vec.h"
#include "methods/pipeline.h"
#include "model/core.h"
#include "scene/sources.h"
#include "tests/model/test.h"

static ts_params params;

static ts_scene *open_scene(const char *spec, const char *camera)
{
	ts_scene *scene;
	const ts_scene_options options = {.camera = camera};
	if (ts_builtin_open(&scene, spec, &params, &options) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

static int set_up(void **state)
{
	(void)state;
	ts_params_default(&params);
	return 0;
}

static void it_is_a_regular_grid_of_squares(void **state)
{
	(void)state;
	ts_scene *scene = open_scene("checkerboard:surfels=10000", NULL);
	u32 columns = 50, n_light = 0;
	assert_int_equal(scene->n_surfels, 4 * columns * columns);
	assert_int_equal(scene->n_triangles, 0);
	for (u32 i = 0; i < scene->n_surfels; i++) {
		const ts_surfel *s = &scene->surfels[i];
		double x = (i % columns + 0.5) * 1.28 - 32.0, z = -(i / columns + 0.5) * 1.28;
		assert_true(fabs((double)s->centre[0] - x) < 1e-4 && fabs((double)s->centre[2] - z) < 1e-4);
		assert_true(s->centre[1] == 0.0f);
		ts_v3 u = ts_load3(s->u), n = ts_cross(u, ts_load3(s->v));
		assert_true(fabs((double)ts_length(u) - 1.92) < 1e-5);
		assert_true(n.y > 3.6f && n.x == 0.0f && n.z == 0.0f);
		double square = floor((double)s->centre[0]) + floor((double)s->centre[2]);
		assert_true((fmod(square, 2.0) == 0.0) == (s->colour[0] > 0.5f));
		n_light += s->colour[0] > 0.5f;
	}
	assert_in_range(n_light, 4000, 6000);
	ts_scene_free(scene);
}

static void counts_and_radii_are_as_asked_for(void **state)
{
	(void)state;
	ts_scene *scene = open_scene("checkerboard", NULL);
	assert_int_equal(scene->n_surfels, 298116);
	ts_scene_free(scene);
	params.surfels_radius = 1.0f;
	scene = open_scene("checkerboard:surfels=40k", NULL);
	assert_int_equal(scene->n_surfels, 40000);
	assert_true(fabs((double)ts_length(ts_load3(scene->surfels[9].v)) - 0.64) < 1e-5);
	ts_scene_free(scene);
	set_up(NULL);
	assert_int_equal(ts_builtin_open(&scene, "checkerboard:triangles=20000", &params, NULL), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "NAME:surfels=COUNT"));
	assert_int_equal(ts_builtin_open(&scene, "checkerboard:surfels=9999", &params, NULL), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "9999 surfels are out of range"));
}

static void a_camera_looks_along_it(void **state)
{
	(void)state;
	ts_scene *scene = open_scene("checkerboard:surfels=10000", NULL);
	const ts_info *info = &scene->info;
	ts_v3 right = ts_load3(info->right), up = ts_load3(info->up), back = ts_load3(info->back);
	assert_true(ts_abs(ts_dot(up, back)) < 1e-6f && ts_abs(ts_dot(up, up) - 1.0f) < 1e-6f);
	assert_true(ts_length(ts_sub(ts_cross(right, up), back)) < 1e-6f);
	assert_true(back.z > 0.9f && back.y > 0.0f && info->eye[1] == 2.0f);
	ts_scene_free(scene);
}

/* A scene that a method cannot draw is refused in one line. */
static void methods_of_triangles_refuse_it(void **state)
{
	(void)state;
	ts_run run;
	ts_scene *scene = open_scene("checkerboard:surfels=10000", NULL);
	ts_run_begin(&run, scene, &params, 1);
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("reflections", "epr"), &run), TS_ERROR);
	ts_run_end(&run);
	assert_string_equal(ts_error_message(),
	                    "checkerboard:surfels=10000: has surfels only; reflections by epr draws triangles");
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(it_is_a_regular_grid_of_squares),
		cmocka_unit_test(counts_and_radii_are_as_asked_for),
		cmocka_unit_test(a_camera_looks_along_it),
		cmocka_unit_test(methods_of_triangles_refuse_it),
	};
	return cmocka_run_group_tests(tests, set_up, NULL);
}
