/* Loads hostile files, each in a process of its own: those that hostile_files.py makes, held against its manifest, and
 * where $TS_SCENES has them those of another project, and good scenes. A file gets 10 seconds, a process 4 GiB. */
#include <dlfcn.h>
#include <limits.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include "image/codec.h"
#include "model/core.h"
#include "scene/scene.h"
#include "tests/model/test.h"
#include "tests/scene/folder.h"
#include "tests/scratch.h"

/* What came of a file. `text`: why it was refused, or what its process printed, which did not end well. */
typedef struct {
	enum { LOADED, REFUSED, CRASHED } end;
	u32 triangles; /* without reflectors */
	char text[1024];
} outcome;

/* Of LeakSanitizer, if it is there; exit() would wait for threads of the image module, which the process lacks. */
extern int __lsan_do_recoverable_leak_check(void) __attribute__((weak));

static bool is_one_line(const char *text) { return text[0] != '\0' && strpbrk(text, "\r\n") == NULL; }

/* Opens a file, with reflectors added, and tells the outcome. */
static void load_and_report(const char *path, int to)
{
	ts_params params;
	ts_scene *scene;
	outcome o = {.end = REFUSED};
	ts_params_default(&params);
	params.reflectors_count = 2;
	if (ts_scene_load(&scene, path, &params, NULL) == TS_OK) o.end = LOADED;
	if (o.end == LOADED) o.triangles = (u32)scene->n_triangles_file;
	if (o.end == REFUSED) snprintf(o.text, sizeof o.text, "%s", ts_error_message());
	ts_scene_free(scene);
	assert_int_equal(write(to, &o, sizeof o), sizeof o);
}

/* The process that opens a file: what it prints is kept. */
static void begin_child(FILE *printed)
{
	struct rlimit limit = {(rlim_t)4 << 30, (rlim_t)4 << 30};
	alarm(10);
	if (!TS_TEST_SANITIZED) setrlimit(RLIMIT_AS, &limit);
	if (dup2(fileno(printed), 1) < 0 || dup2(fileno(printed), 2) < 0) _exit(1);
}

static void crash(outcome *o, int status, FILE *printed)
{
	o->end = CRASHED;
	int n = snprintf(o->text, sizeof o->text, "wait status %d, printed: ", status);
	rewind(printed);
	size_t more = fread(o->text + n, 1, sizeof o->text - (size_t)n - 1, printed);
	o->text[(size_t)n + more] = '\0';
}

/* Opens a file in a process of its own, which must end well and print nothing. */
static outcome load(const char *path)
{
	outcome o;
	int ends[2], status = 0;
	FILE *printed = tmpfile();
	assert_non_null(printed);
	assert_int_equal(pipe(ends), 0);
	fflush(NULL);
	pid_t child = fork();
	if (child == 0) {
		begin_child(printed);
		load_and_report(path, ends[1]);
		_exit(__lsan_do_recoverable_leak_check != NULL && __lsan_do_recoverable_leak_check() != 0);
	}
	close(ends[1]);
	bool told = read(ends[0], &o, sizeof o) == sizeof o;
	close(ends[0]);
	assert_int_equal(waitpid(child, &status, 0), child);
	fseek(printed, 0, SEEK_END);
	if (!told || status != 0 || ftell(printed) != 0) crash(&o, status, printed);
	fclose(printed);
	return o;
}

/* Cuts the first column off a line and returns it. */
static char *column(char **line)
{
	char *text = *line, *end = strpbrk(text, "\t\n");
	*line = end ? end + 1 : text + strlen(text);
	if (end) *end = '\0';
	return text;
}

/* What the validator refuses and a reader may pass over: RFC 8259, section 8.1. */
static bool has_mark(const char *file)
{
	return strcmp(file, "glb/bom.glb") == 0 || strcmp(file, "json/bom.gltf") == 0;
}

static bool is_as_expected(const outcome *o, const char *expected, const char *words)
{
	bool any = strcmp(expected, "safe") == 0 || strcmp(expected, "valid") == 0;
	if (o->end == CRASHED || (o->end == REFUSED && !is_one_line(o->text))) return false;
	if (any) return true;
	if (strncmp(expected, "refuse", 6) == 0) return o->end == REFUSED && strstr(o->text, words) != NULL;
	return o->end == LOADED && o->triangles == (u32)strtoul(expected, NULL, 10);
}

/* Opens the files that a list names, in a folder; returns how many end otherwise than it says. */
static u32 walk(FILE *list, const char *folder, bool with_words)
{
	char line[4096], path[PATH_MAX];
	u32 count[3] = {0}, wrong = 0;
	while (fgets(line, sizeof line, list)) {
		static const char *const ends[] = {"loaded", "refused", "crashed"};
		char *rest = line, *file = column(&rest), *expected = column(&rest), *words = with_words ? column(&rest) : "";
		snprintf(path, sizeof path, "%s/%s", folder, file);
		outcome o = load(path);
		if (!with_words && has_mark(file)) expected = "valid";
		bool good = is_as_expected(&o, expected, words);
		count[o.end]++;
		wrong += !good;
		if (good && getenv("TS_VERBOSE") == NULL) continue;
		fprintf(stderr, "%s%s: expected %s %s, was %s, %u triangles: %s\n", good ? "" : "WRONG ", file, expected, words,
		        ends[o.end], o.triangles, o.text);
	}
	fclose(list);
	print_message("%s: %u loaded, %u refused, %u crashed, %u wrong\n", folder, count[0], count[1], count[2], wrong);
	return wrong;
}

static void hostile_files_end_as_their_manifest_says(void **state)
{
	(void)state;
	char command[2 * SCRATCH_PATH];
	snprintf(command, sizeof command, "/usr/bin/python3 tests/scene/open/hostile_files.py '%s'", scratch_path("made"));
	assert_int_equal(system(command), 0);
	FILE *list = fopen(scratch_path("made/manifest.tsv"), "r");
	assert_non_null(list);
	assert_int_equal(walk(list, scratch_path("made/files"), true), 0);
}

static void files_of_the_validator_end_as_listed(void **state)
{
	(void)state;
	char folder[PATH_MAX], path[PATH_MAX + 16], titles[4096];
	snprintf(folder, sizeof folder, "%s/hostile/khronos-validator", scenes_folder());
	snprintf(path, sizeof path, "%s/expected.tsv", folder);
	FILE *list = fopen(path, "r");
	if (!list) {
		print_message("%s is absent; set TS_SCENES\n", path);
		skip();
	}
	assert_non_null(fgets(titles, sizeof titles, list));
	assert_int_equal(walk(list, folder, false), 0);
}

/* The good scenes beside the corpus, as far as they are there. */
static void good_scenes_have_all_their_triangles(void **state)
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
		snprintf(path, sizeof path, "%s/%s", scenes_folder(), good[i].file);
		if (access(path, R_OK) != 0) continue;
		n++;
		outcome o = load(path);
		if (o.end != LOADED) fail_msg("%s", o.text);
		if (o.triangles != good[i].triangles) fail_msg("%s: %u triangles of %u", path, o.triangles, good[i].triangles);
	}
	if (n == 0) {
		print_message("%s has none of them; set TS_SCENES\n", scenes_folder());
		skip();
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(hostile_files_end_as_their_manifest_says),
		cmocka_unit_test(files_of_the_validator_end_as_listed),
		cmocka_unit_test(good_scenes_have_all_their_triangles),
	};
	/* So that not each process begins with it. */
	if (dlopen(TS_IMAGE_MODULE, RTLD_NOW | RTLD_LOCAL) == NULL) print_message("%s\n", dlerror());
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}
