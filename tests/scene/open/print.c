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

/* ---- a scene by hand ---- */

enum { NODES = 23 };

static char names[NODES][16], camera_names[2][16] = {"left", "ri\nght"}, note[] = "a note";
static ts_light lights[3];
static ts_camera cameras[2];
static ts_named_node nodes[NODES];
static char *notes[1] = {note};

static ts_scene scene_by_hand(u32 camera, u32 n_nodes)
{
	static char name[] = "by hand";
	for (u32 i = 0; i < 3; i++) {
		f32 x = (f32)(10 * i);
		lights[i] = (ts_light){.kind = i,
		                       .position = {x + 1, x + 2, x + 3},
		                       .direction = {x + 4, x + 5, x + 6},
		                       .intensity = {x + 7, x + 8, x + 9}};
	}
	for (u32 i = 0; i < 2; i++) cameras[i].name = camera_names[i];
	for (u32 i = 0; i < NODES; i++) {
		snprintf(names[i], sizeof names[i], "node %u", (unsigned)i);
		nodes[i] = (ts_named_node){names[i], 100 + i};
	}
	return (ts_scene){
		.name = name,
		.info = {.box_min = {1, 2, 3}, .box_max = {4, 5, 6}, .hall_min = {7, 8}, .hall_max = {9, 10}, .ambient = 0.25f},
		.lights = lights,
		.n_lights = 3,
		.cameras = cameras,
		.n_cameras = 2,
		.camera = camera,
		.nodes = nodes,
		.n_nodes = n_nodes,
		.notes = notes,
		.n_notes = 1};
}

/* Each line by itself, in order. */
static void text_has_a_line_for_each_part(void **state)
{
	(void)state;
	static const char *const right[] = {"by hand\n",
	                                    "  box x                 1 to 4\n  box y                 2 to 5\n",
	                                    "  box z                 3 to 6\n",
	                                    "  hall x                7 to 9\n  hall z                8 to 10\n",
	                                    "  ambient               0.25\n",
	                                    "  light 0               directional, intensity 7 8 9\n",
	                                    "  light 1               point, intensity 17 18 19\n",
	                                    "  light 2               spot, intensity 27 28 29\n"};
	for (u32 camera = 0; camera <= 2; camera++) {
		u32 n_nodes = camera < 2 ? 20 + 3 * camera : 0;
		const ts_scene scene = scene_by_hand(camera < 2 ? camera : TS_NONE, n_nodes);
		char *text = printed(&scene, false), *at = text, line[100];
		for (u32 i = 0; i < sizeof right / sizeof *right; i++) {
			if ((at = strstr(at, right[i])) == NULL) fail_msg("no \"%s\", or not there, in:\n%s", right[i], text);
		}
		for (u32 i = 0; i < 2; i++) {
			snprintf(line, sizeof line, "\n  camera %u              %s%s\n", (unsigned)i, i == 0 ? "left" : "ri?ght",
			         i == camera ? " (chosen)" : "");
			assert_non_null(strstr(text, line));
		}
		assert_int_equal(strstr(text, "\n  eye                   circling\n") != NULL, camera == 2);
		for (u32 i = 0; i < NODES; i++) {
			snprintf(line, sizeof line, "\n  node                  %12u  triangles: node %u\n", 100 + (unsigned)i,
			         (unsigned)i);
			assert_int_equal(strstr(text, line) != NULL, i < n_nodes && i < 20);
		}
		assert_int_equal(strstr(text, "\n  3 more nodes; as JSON all are listed\n") != NULL, n_nodes == NODES);
		assert_int_equal(strstr(text, "more nodes") != NULL, n_nodes == NODES);
		assert_non_null(strstr(text, "a note\n"));
		free(text);
	}
}

/* The numbers of an array from `first` on, in steps of 1. */
static void is_row(const json_t *row, double first, size_t n)
{
	assert_int_equal(json_array_size(row), n);
	for (size_t i = 0; i < n; i++) assert_true(json_real_value(json_array_get(row, i)) == first + (double)i);
}

static void json_has_all_parts_of_a_scene(void **state)
{
	(void)state;
	static const char *const kinds[] = {"directional", "point", "spot"};
	for (u32 camera = 0; camera <= 2; camera++) {
		const ts_scene scene = scene_by_hand(camera < 2 ? camera : TS_NONE, NODES);
		char *json = printed(&scene, true);
		json_t *root = json_loads(json, 0, NULL);
		assert_non_null(root);
		assert_string_equal(json_string_value(json_object_get(root, "scene")), "by hand");
		is_row(json_object_get(root, "box_min"), 1, 3);
		is_row(json_object_get(root, "box_max"), 4, 3);
		is_row(json_object_get(root, "hall_min"), 7, 2);
		is_row(json_object_get(root, "hall_max"), 9, 2);
		assert_true(json_real_value(json_object_get(root, "ambient")) == 0.25);
		for (u32 i = 0; i < 3; i++) {
			const json_t *light = json_array_get(json_object_get(root, "light"), i);
			assert_string_equal(json_string_value(json_object_get(light, "kind")), kinds[i]);
			is_row(json_object_get(light, "position"), 10 * i + 1, 3);
			is_row(json_object_get(light, "direction"), 10 * i + 4, 3);
			is_row(json_object_get(light, "intensity"), 10 * i + 7, 3);
		}
		const json_t *eye = json_object_get(root, "eye"), *node = json_object_get(root, "nodes");
		if (camera < 2) assert_int_equal(json_integer_value(eye), camera);
		if (camera == 2) assert_string_equal(json_string_value(eye), "circling");
		assert_string_equal(json_string_value(json_array_get(json_object_get(root, "camera"), 0)), "left");
		assert_int_equal(json_array_size(json_object_get(root, "camera")), 2);
		assert_int_equal(json_array_size(node), NODES);
		for (u32 i = 0; i < NODES; i++) {
			const json_t *one = json_array_get(node, i);
			assert_string_equal(json_string_value(json_object_get(one, "name")), names[i]);
			assert_int_equal(json_integer_value(json_object_get(one, "triangles")), 100 + i);
		}
		assert_string_equal(json_string_value(json_array_get(json_object_get(root, "notes"), 0)), note);
		assert_null(json_object_get(root, "surfel_radius"));
		json_decref(root);
		free(json);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(text_and_json_have_the_same_figures), cmocka_unit_test(quartiles_of_surfels_are_told_in_order),
		cmocka_unit_test(text_has_a_line_for_each_part), cmocka_unit_test(json_has_all_parts_of_a_scene)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
