/* Opening scenes: what is refused, and how a loaded scene is described. */
#include <jansson.h>
#include <sys/stat.h>
#include <unistd.h>
#include "kernels/base/shade.h"
#include "model/core.h"
#include "scene/build.h"
#include "tests/model/test.h"
#include "tests/scratch.h"

static ts_params params;

static int set_up(void **state)
{
	ts_params_default(&params);
	return scratch_begin(state);
}

static void refuse(const char *spec, const ts_scene_options *options, const char *words)
{
	ts_scene *scene = (ts_scene *)&params;
	assert_int_equal(ts_scene_load(&scene, spec, &params, options), TS_ERROR);
	assert_null(scene);
	const char *message = ts_error_message();
	assert_null(strchr(message, '\n'));
	if (!strstr(message, spec) || !strstr(message, words)) fail_msg("\"%s\" does not say \"%s\"", message, words);
}

static void a_missing_scene_is_refused(void **state)
{
	(void)state;
	refuse("no-such-scene", NULL, "built in are atrium, gallery, ");
	refuse("", NULL, "no such scene");
	refuse("no-such-scene.gltf", NULL, "No such file");
	refuse(scratch_path("nothing.glb"), NULL, "No such file");
	refuse(scratch_path("nothing.obj"), NULL, "No such file");
}

static void what_is_no_scene_is_refused(void **state)
{
	(void)state;
	refuse(scratch_root, NULL, "is a directory");
	const char *path = scratch_path("scene.obj");
	FILE *file = fopen(path, "w");
	assert_non_null(file);
	fclose(file);
	refuse(path, NULL, "must end in .gltf, .glb or .ply");
	assert_int_equal(unlink(path), 0);
	path = scratch_path("pipe.gltf");
	assert_int_equal(mkfifo(path, 0600), 0);
	refuse(path, NULL, "not a regular file");
	assert_int_equal(unlink(path), 0);
}

static void an_empty_file_is_refused(void **state)
{
	(void)state;
	const char *const names[2] = {"empty.gltf", "empty.glb"};
	for (int i = 0; i < 2; i++) {
		const char *path = scratch_path("%s", names[i]);
		FILE *file = fopen(path, "w");
		assert_non_null(file);
		fclose(file);
		refuse(path, NULL, "empty.gl");
		assert_int_equal(unlink(path), 0);
	}
}

static void wrong_options_of_scenes_are_refused(void **state)
{
	(void)state;
	const ts_scene_options reflector = {.reflector = "teapot"}, camera = {.camera = "nowhere"};
	refuse("atrium:triangles=10k", &reflector, "built-in scenes have no named nodes");
	refuse("atrium:triangles=10k", &camera, "nowhere");
	refuse("atrium:triangles=-1", NULL, "triangles");
	refuse("atrium:colour=red", NULL, "atrium");
}

static void built_in_scenes_open_with_their_mirrors(void **state)
{
	(void)state;
	ts_scene *scene;
	params.reflectors_count = 3;
	assert_int_equal(ts_scene_load(&scene, "atrium:triangles=10k", &params, NULL), TS_OK);
	assert_int_equal(scene->info.n_reflectors, 3);
	assert_in_range(scene->n_triangles_file, 5000, 20000);
	ts_scene_free(scene);
	ts_scene_free(NULL);
}

/* A scene with a hostile name, a camera, a lamp and a note. */
static ts_scene *described(void)
{
	ts_build *build = ts_build_new("bad\nname\x1b\xc2\x9b");
	assert_non_null(build);
	for (u32 i = 0; i < 3; i++) {
		ts_vertex v = {.position = {(f32)(i == 1), (f32)(i == 2), 0.0f}};
		ts_build_vertex(build, &v);
	}
	ts_build_triangle(build, 0, 1, 2, 0xffffffffu);
	ts_camera camera = {.name = "\xff not UTF-8"};
	ts_build_camera(build, &camera);
	ts_light lamp = {.kind = TS_LIGHT_KIND_POINT, .intensity = {0.1f, 2.0f, 3.0f}};
	ts_build_light(build, &lamp);
	ts_build_note(build, "sampler %d: its filter is ignored", 7);
	ts_build_note(build, "a\xc2\x9b"
	                     "b\nc");
	ts_scene *scene;
	assert_int_equal(ts_build_finish(build, &params, NULL, &scene), TS_OK);
	return scene;
}

static char *print(const ts_scene *scene, int json)
{
	FILE *out = tmpfile();
	assert_non_null(out);
	assert_int_equal(ts_scene_print(scene, out, json), TS_OK);
	size_t size = (size_t)ftell(out);
	char *text = calloc(size + 1, 1);
	assert_non_null(text);
	rewind(out);
	assert_int_equal(fread(text, 1, size, out), size);
	fclose(out);
	return text;
}

static void texts_of_a_scene_are_cleaned(void **state)
{
	(void)state;
	ts_scene *scene = described();
	char *text = print(scene, 0);
	assert_non_null(strstr(text, "bad?name???\n"));
	assert_non_null(strstr(text, "point, intensity 0.1 2 3"));
	assert_non_null(strstr(text, "note: sampler 7: its filter is ignored"));
	assert_non_null(strstr(text, "note: a??b?c\n"));
	assert_non_null(strstr(text, "circling"));
	assert_null(strchr(text, 0x1b));
	free(text);
	ts_scene_free(scene);
}

static void json_keeps_names_and_numbers(void **state)
{
	(void)state;
	ts_scene *scene = described();
	char *text = print(scene, 1);
	json_error_t error;
	json_t *root = json_loads(text, 0, &error);
	assert_non_null(root);
	assert_string_equal(json_string_value(json_object_get(root, "scene")), "bad\nname\x1b\xc2\x9b");
	assert_int_equal(json_integer_value(json_object_get(root, "triangles")), 1);
	assert_int_equal(json_integer_value(json_object_get(root, "vertices")), 3);
	assert_int_equal(json_integer_value(json_object_get(root, "bytes")), 3 * 80 + 16 + 80 + 64 + 48);
	assert_int_equal(json_array_size(json_object_get(root, "camera")), 1);
	json_t *light = json_array_get(json_object_get(root, "light"), 0);
	assert_string_equal(json_string_value(json_object_get(light, "kind")), "point");
	assert_true((f32)json_real_value(json_array_get(json_object_get(light, "intensity"), 0)) == 0.1f);
	json_decref(root);
	free(text);
	ts_scene_free(scene);
}

static void a_full_disk_is_an_error(void **state)
{
	(void)state;
	FILE *out = fopen("/dev/full", "w");
	if (!out) skip();
	ts_scene *scene = described();
	assert_int_equal(ts_scene_print(scene, out, 0), TS_ERROR);
	ts_scene_free(scene);
	fclose(out);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_missing_scene_is_refused),
		cmocka_unit_test(what_is_no_scene_is_refused),
		cmocka_unit_test(an_empty_file_is_refused),
		cmocka_unit_test(wrong_options_of_scenes_are_refused),
		cmocka_unit_test(built_in_scenes_open_with_their_mirrors),
		cmocka_unit_test(texts_of_a_scene_are_cleaned),
		cmocka_unit_test(json_keeps_names_and_numbers),
		cmocka_unit_test(a_full_disk_is_an_error),
	};
	return cmocka_run_group_tests(tests, set_up, scratch_end);
}
