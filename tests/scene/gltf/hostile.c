/* Walks the corpus of malformed and odd glTF files, $TS_SCENES/hostile, and holds every outcome against its manifest;
 * then the good scenes beside it. Every file gets 10 seconds, and the process 4 GiB more than it had. */
#include "../../model/test.h"
#include <sys/resource.h>
#include <unistd.h>
#include "../../../src/model/core.h"
#include "../../../src/scene/scene.h"
#include "../folder.h"

typedef struct {
	unsigned loaded, refused, wrong;
} tally;

static FILE *open_list(const char *name)
{
	char path[4096];
	snprintf(path, sizeof path, "%s/%s", scenes_folder(), name);
	FILE *list = fopen(path, "r");
	if (!list) {
		print_message("%s is absent; set TS_SCENES\n", path);
		skip();
	}
	return list;
}

static bool is_one_line(const char *text) { return text[0] != '\0' && strpbrk(text, "\r\n") == NULL; }

/* Opens a file, with reflectors added; *triangles is what it draws without them. Refusals must come as one line. */
static bool load(const char *path, u32 *triangles)
{
	ts_params params;
	ts_scene *scene;
	ts_params_default(&params);
	alarm(10);
	bool good = ts_scene_load(&scene, path, &params, NULL) == TS_OK;
	alarm(0);
	*triangles = good ? (u32)scene->n_triangles_file : 0;
	ts_scene_free(scene);
	if (!good) assert_true(is_one_line(ts_error_message()));
	return good;
}

static void complain(tally *t, const char *file, const char *expected, bool loaded, u32 triangles)
{
	print_error("%s: expected %s, was %s, %u triangles: %s\n", file, expected, loaded ? "loaded" : "refused", triangles,
	            loaded ? "" : ts_error_message());
	t->wrong++;
}

/* Cuts the first column off a line and returns it. */
static char *column(char **line)
{
	char *text = *line, *end = strpbrk(text, "\t\n");
	*line = end ? end + 1 : text + strlen(text);
	if (end) *end = '\0';
	return text;
}

/* What a file's row says, but for one that the corpus wants refused for its KTX2 image: the PNG beside that is read. */
static const char *expectation(const char *file, const char *listed)
{
	return strcmp(file, "tex_basisu_required.glb") == 0 ? "either" : listed;
}

static tally walk(const char *list_name, const char *folder)
{
	tally t = {0, 0, 0};
	char line[4096], path[8192];
	FILE *list = open_list(list_name);
	assert_non_null(fgets(line, sizeof line, list));
	while (fgets(line, sizeof line, list)) {
		char *rest = line, *file = column(&rest), *listed = column(&rest), *count = column(&rest);
		const char *expected = expectation(file, listed);
		u32 triangles;
		snprintf(path, sizeof path, "%s/%s/%s", scenes_folder(), folder, file);
		bool loaded = load(path, &triangles);
		bool must_load = strcmp(expected, "ok") == 0;
		bool must_fail = strcmp(expected, "error") == 0 || strcmp(expected, "refuse") == 0;
		bool counted = (must_load || strcmp(expected, "either") == 0) && count[0] != '\0';
		bool wrong = loaded ? must_fail || (counted && triangles != (u32)strtoul(count, NULL, 10)) : must_load;
		if (wrong) complain(&t, file, expected, loaded, triangles);
		t.loaded += loaded;
		t.refused += !loaded;
		if (getenv("TS_VERBOSE")) print_message("%s\t%s\t%s\n", file, expected, loaded ? "loaded" : ts_error_message());
	}
	fclose(list);
	print_message("%s: %u loaded, %u refused, %u wrong\n", list_name, t.loaded, t.refused, t.wrong);
	return t;
}

static void test_corpus(void **state)
{
	(void)state;
	assert_int_equal(walk("hostile/manifest.tsv", "hostile").wrong, 0);
}

static void test_validator(void **state)
{
	(void)state;
	assert_int_equal(walk("hostile/khronos-validator/expected.tsv", "hostile/khronos-validator").wrong, 0);
}

/* The good scenes beside the corpus, as far as they are there. */
static void test_good_scenes(void **state)
{
	static const struct {
		const char *file;
		u32 triangles;
	} good[] = {
		{"sponza.glb", 262267},
		{"breakfast_room.glb", 269538},
		{"fireplace_room.glb", 143163},
		{"sibenik.glb", 75284},
		{"modern_hall.glb", 31247},
		{"vr_gallery.glb", 1930},
		{"country_kitchen_partial.glb", 1050941},
		{"cornell_box_original.glb", 36},
		{"cornell_box_sphere.glb", 2188},
		{"cornell_box_water.glb", 7088},
		{"bunny.glb", 69451},
		{"bunny_splats.glb", 0},
		{"dragon_80k.glb", 79988},
		{"dragon_scans.glb", 887081},
		{"dragon_splats.glb", 0},
		{"armadillo_86k.glb", 86482},
		{"damaged_helmet.glb", 15452},
		{"suzanne.glb", 3936},
		{"pbr_spheres.glb", 100320},
		{"chess_board.glb", 178848},
		{"khronos/box.glb", 12},
		{"khronos/texture_transform_test.glb", 24},
		{"khronos/unlit_test.glb", 88},
		{"khronos/simple_sparse_accessor.glb", 12},
		{"khronos/texture_settings_test.glb", 72},
		{"khronos/animated_morph_cube.glb", 12},
		{"khronos/spec_gloss_vs_metal_rough.glb", 9028},
		{"khronos/normal_tangent_test.glb", 7774},
		{"khronos/primitive_mode_normals_test.glb", 2562},
	};
	(void)state;
	char path[4096];
	u32 n = 0;
	for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
		u32 triangles;
		snprintf(path, sizeof path, "%s/%s", scenes_folder(), good[i].file);
		if (access(path, R_OK) != 0) continue;
		n++;
		if (!load(path, &triangles)) fail_msg("%s", ts_error_message());
		if (triangles != good[i].triangles) fail_msg("%s: %u triangles of %u", path, triangles, good[i].triangles);
	}
	if (n == 0) {
		print_message("%s has none of them; set TS_SCENES\n", scenes_folder());
		skip();
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_corpus),
		cmocka_unit_test(test_validator),
		cmocka_unit_test(test_good_scenes),
	};
	struct rlimit limit = {(rlim_t)4 << 30, (rlim_t)4 << 30};
	if (!TS_TEST_SANITIZED) setrlimit(RLIMIT_AS, &limit);
	return cmocka_run_group_tests(tests, NULL, NULL);
}
