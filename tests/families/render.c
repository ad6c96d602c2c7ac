/* The public API, used as its header says. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>
#include <touchstone/touchstone.h>

static ts_scene *open_scene(ts_params *params)
{
	ts_scene *scene = NULL;
	ts_params_default(params);
	assert_int_equal(ts_params_set(params, "width", "96"), TS_OK);
	assert_int_equal(ts_params_set(params, "height", "64"), TS_OK);
	assert_int_equal(ts_params_set(params, "reflectors.count", "2"), TS_OK);
	assert_int_equal(ts_params_set(params, "cube.max_px", "32"), TS_OK);
	assert_int_equal(ts_scene_open(&scene, "gallery:triangles=10000:texels=32", params, NULL), TS_OK);
	return scene;
}

static void test_render(void **state)
{
	(void)state;
	ts_params params;
	ts_scene *scene = open_scene(&params);
	for (int i = 0; i < 2; i++) {
		const char *method = i == 0 ? "epr" : "mvr";
		ts_render *render = NULL;
		ts_buffer_view image;
		assert_int_equal(ts_render_run(&render, scene, &params, "reflections", method, 2), TS_OK);
		assert_int_equal(ts_render_buffer(render, "image.srgb", &image), TS_OK);
		assert_int_equal(image.n_dims, 3);
		assert_int_equal(image.shape[0], 64);
		assert_int_equal(image.shape[1], 96);
		assert_int_equal(image.shape[2], 3);
		assert_int_equal(image.element_bytes, 1);
		assert_string_equal(image.element, "u8");
		assert_string_equal(image.order, "sequence");
		const uint8_t *pixels = image.data;
		assert_false(memcmp(pixels, pixels + 3, 96 * 64 * 3 - 3) == 0);
		assert_true(ts_render_counter(render, "shading operations") > 0);
		assert_int_equal(ts_render_counter(render, "no such counter"), 0);
		ts_render_free(render);
	}
	ts_scene_free(scene);
}

static void test_refusals(void **state)
{
	(void)state;
	ts_params params;
	ts_scene *scene = open_scene(&params);
	ts_render *render = (ts_render *)&params;
	assert_int_equal(ts_render_run(&render, scene, &params, "reflections", "magic", 1), TS_ERROR);
	assert_null(render);
	assert_non_null(strstr(ts_error_message(), "magic"));
	ts_buffer_view view;
	assert_int_equal(ts_render_run(&render, scene, &params, "reflections", "mvr", 0), TS_OK);
	assert_int_equal(ts_render_buffer(render, "points.key", &view), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "points.key"));
	assert_int_equal(ts_render_buffer(render, "points", &view), TS_ERROR);
	ts_render_free(render);
	params.lookup_bounces = 5;
	assert_int_equal(ts_render_run(&render, scene, &params, "reflections", "epr", 1), TS_ERROR);
	assert_null(render);
	assert_non_null(strstr(ts_error_message(), "lookup.bounces"));
	ts_render_free(NULL);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_render), cmocka_unit_test(test_refusals)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
