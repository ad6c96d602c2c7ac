/* What `info` says of a scene: its figures, as text and as JSON; the bytes are those of its arrays. */
#include <jansson.h>
#include <math.h>
#include "kernels/base/vec.h"
#include "scene/scene.h"
#include "tests/model/test.h"

static char *printed(const ts_scene *scene, bool json)
{
	char *text;
	size_t bytes;
	FILE *out = open_memstream(&text, &bytes);
	assert_non_null(out);
	assert_int_equal(ts_scene_print(scene, out, json), TS_OK);
	fclose(out);
	return text;
}

static uint64_t bytes_of(const ts_scene *s)
{
	const uint64_t arrays[][2] = {{s->n_vertices, sizeof *s->vertices},   {s->n_triangles, sizeof *s->triangles},
	                              {s->n_materials, sizeof *s->materials}, {s->n_slots, sizeof *s->slots},
	                              {s->n_images, sizeof *s->images},       {s->n_texels, sizeof *s->texels},
	                              {s->n_lights, sizeof *s->lights},       {s->n_objects, sizeof *s->objects},
	                              {s->n_surfels, sizeof *s->surfels}};
	uint64_t sum = 0;
	for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) sum += arrays[i][0] * arrays[i][1];
	return sum;
}

static void text_and_json_have_the_same_figures(void **state)
{
	(void)state;
	static const char *const specs[] = {"atrium:triangles=10000:texels=32", "checkerboard"};
	for (u32 i = 0; i < 2; i++) {
		ts_params params;
		ts_scene *scene;
		ts_params_default(&params);
		if (ts_scene_load(&scene, specs[i], &params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
		const struct {
			const char *name;
			uint64_t value;
		} figures[] = {{"triangles", scene->n_triangles}, {"vertices", scene->n_vertices}, {"texels", scene->n_texels},
		               {"surfels", scene->n_surfels},     {"images", scene->n_images},     {"lights", scene->n_lights},
		               {"bytes", bytes_of(scene)}};
		char *text = printed(scene, false), *json = printed(scene, true);
		json_t *root = json_loads(json, 0, NULL);
		assert_non_null(root);
		for (size_t k = 0; k < sizeof figures / sizeof *figures; k++) {
			char line[64];
			snprintf(line, sizeof line, "  %-21s %12llu", figures[k].name, (unsigned long long)figures[k].value);
			if (strstr(text, line) == NULL) fail_msg("no line \"%s\" in:\n%s", line, text);
			assert_int_equal(json_integer_value(json_object_get(root, figures[k].name)), figures[k].value);
		}
		assert_int_equal(json_array_size(json_object_get(root, "light")), scene->n_lights);
		assert_int_equal(json_array_size(json_object_get(root, "camera")), scene->n_cameras);
		json_decref(root);
		free(text);
		free(json);
		ts_scene_free(scene);
	}
}

/* Five radii, from the least to the greatest; by JSON they are the same. */
static void quartiles_of_surfels_are_told_in_order(void **state)
{
	(void)state;
	ts_params params;
	ts_scene *scene;
	double least, quartiles[3], most;
	ts_params_default(&params);
	TS_PARAM_SET(&params, surfels_from_mesh, 3000);
	if (ts_scene_load(&scene, "atrium:triangles=10000:texels=32", &params, NULL) != TS_OK)
		fail_msg("%s", ts_error_message());
	for (u32 i = 0; i < scene->n_surfels; i++) {
		ts_surfel *s = &scene->surfels[i];
		f32 scale = (1.0f + (f32)(i % 97)) / ts_length(ts_load3(s->u));
		ts_store3(s->u, ts_scale(ts_load3(s->u), scale));
		ts_store3(s->v, ts_scale(ts_normalize(ts_load3(s->v)), 0.5f));
	}
	char *text = printed(scene, false), *line = strstr(text, "  surfel radius");
	assert_non_null(line);
	assert_int_equal(sscanf(line, "  surfel radius %lf to %lf, quartiles %lf %lf %lf; the longer half-axis", &least,
	                        &most, &quartiles[0], &quartiles[1], &quartiles[2]),
	                 5);
	assert_true(fabs(least - 1) < 1e-3 && fabs(most - 97) < 1e-2);
	for (u32 k = 0; k < 3; k++) assert_true(fabs(quartiles[k] - 97 * (k + 1) / 4.0) < 2);
	free(text);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(text_and_json_have_the_same_figures),
	                                   cmocka_unit_test(quartiles_of_surfels_are_told_in_order)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
