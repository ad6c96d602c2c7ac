/* The kind of each failure, by calls of the API that fail for one reason each. */
#include <pthread.h>
#include <sys/resource.h>
#include "tests/api/run.h"

static void fails_as(ts_kind kind, ts_status status, const char *words)
{
	assert_true(status == TS_ERROR || status == TS_SKIPPED);
	if (strstr(ts_error_message(), words) == NULL) fail_msg("\"%s\" does not say \"%s\"", ts_error_message(), words);
	if (ts_error_kind() != kind) fail_msg("\"%s\" is of kind %d", ts_error_message(), (int)ts_error_kind());
}

static void *kind_at_first(void *kind)
{
	*(ts_kind *)kind = ts_error_kind();
	return NULL;
}

static void before_a_failure_there_is_no_kind(void **state)
{
	(void)state;
	ts_kind kind = TS_KIND_FILE;
	pthread_t thread;
	assert_int_equal(pthread_create(&thread, NULL, kind_at_first, &kind), 0);
	assert_int_equal(pthread_join(thread, NULL), 0);
	assert_int_equal(kind, TS_KIND_NONE);
}

static void wrong_arguments_are_of_their_kind(void **state)
{
	(void)state;
	ts_scene *made;
	ts_trace *trace;
	const ts_scene_options camera = {.bytes = sizeof camera, .camera = "none such"}, small = {.bytes = 1};
	const ts_scene_options node = {.bytes = sizeof node, .reflector = "none such"};
	static const ts_vertex corner = {.position = {0, 0, 0}};
	static const ts_triangle wrong = {.vertex = {0, 1, 2}, .material = UINT32_MAX};
	const ts_scene_arrays arrays = {
		.bytes = sizeof arrays, .vertices = &corner, .n_vertices = 1, .triangles = &wrong, .n_triangles = 1};
	fails_as(TS_KIND_ARGUMENT, ts_trace_open(context, NULL, "."), "trace is NULL");
	fails_as(TS_KIND_ARGUMENT, ts_params_set(params, "width", "many"), "width");
	fails_as(TS_KIND_ARGUMENT, ts_scene_open(context, &made, SMALL, params, &small), "bytes");
	fails_as(TS_KIND_ARGUMENT, ts_scene_open(context, &made, SMALL, params, &camera), "none such");
	fails_as(TS_KIND_ARGUMENT, ts_scene_open(context, &made, "scenes/room.gltf", params, &camera), "none such");
	fails_as(TS_KIND_ARGUMENT, ts_scene_open(context, &made, "scenes/room.gltf", params, &node), "none such");
	fails_as(TS_KIND_ARGUMENT, ts_scene_make(context, &made, &arrays, params, NULL), "does not exist");
	fails_as(TS_KIND_ARGUMENT, ts_trace_run(context, &trace, scene, params, "reflections", "magic", NULL), "magic");
}

static void missing_files_are_of_their_kind(void **state)
{
	(void)state;
	ts_scene *made;
	ts_trace *trace;
	float *pixels;
	uint32_t width, height, channels;
	ts_golden_judged judged = {.bytes = sizeof judged};
	const ts_scene_options path = {.bytes = sizeof path, .path = "/nowhere/path.txt"};
	fails_as(TS_KIND_FILE, ts_trace_open(context, &trace, "/nowhere"), "/nowhere");
	fails_as(TS_KIND_FILE, ts_trace_open_npy(context, &trace, "/nowhere/eye.view.npy"), "/nowhere");
	fails_as(TS_KIND_FILE, ts_scene_open(context, &made, "/nowhere/a.glb", params, NULL), "/nowhere");
	fails_as(TS_KIND_FILE, ts_scene_open(context, &made, SMALL, params, &path), "/nowhere");
	fails_as(TS_KIND_FILE, ts_image_read(&pixels, &width, &height, &channels, "/nowhere/a.png"), "/nowhere");
	fails_as(TS_KIND_FILE, ts_image_write_png("/nowhere/a.png", (const uint8_t *)"abc", 1, 1, 3, NULL), "/nowhere");
	fails_as(TS_KIND_FILE, ts_trace_save(context, reference, "/proc/trace", NULL), "/proc");
	fails_as(TS_KIND_FILE, ts_golden_check(context, &judged, "/nowhere"), "/nowhere");
}

static void write_file(const char *path, const char *text)
{
	FILE *file = fopen(path, "wb");
	assert_non_null(file);
	assert_true(fputs(text, file) >= 0);
	assert_int_equal(fclose(file), 0);
}

static void damaged_files_are_of_their_kind(void **state)
{
	(void)state;
	static const char *const scenes[][2] = {
		{"a.glb", "glTF"},
		{"b.gltf", "{}"},
		{"c.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"},
		{"d.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"scenes\": [{\"nodes\": [1]}]}"}};
	char folder[FOLDER], path[PATH];
	ts_scene *made;
	ts_trace *trace;
	float *pixels;
	uint8_t *rgba;
	uint32_t width, height, channels;
	make_folder(folder);
	for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
		snprintf(path, sizeof path, "%s/%s", folder, scenes[i][0]);
		write_file(path, scenes[i][1]);
		fails_as(TS_KIND_FORMAT, ts_scene_open(context, &made, path, params, NULL), scenes[i][0]);
	}
	snprintf(path, sizeof path, "%s/path.txt", folder);
	write_file(path, "no frame\n");
	const ts_scene_options options = {.bytes = sizeof options, .path = path};
	fails_as(TS_KIND_FORMAT, ts_scene_open(context, &made, SMALL, params, &options), "path.txt:1");
	snprintf(path, sizeof path, "%s/eye.view.npy", folder);
	write_file(path, "no array");
	fails_as(TS_KIND_FORMAT, ts_trace_open_npy(context, &trace, path), "eye.view.npy");
	snprintf(path, sizeof path, "%s/trace.json", folder);
	write_file(path, "{\"format\": \"touchstone-trace\"}");
	fails_as(TS_KIND_FORMAT, ts_trace_open(context, &trace, folder), "version is missing");
	write_file(path, "{\"format\": \"touchstone-trace\", \"version\": 1, \"contract\": 1, \"order\": \"canonical\", "
	                 "\"pipeline\": \"epr\", \"buffers\": [], \"params\": {\"width\": \"many\"}}");
	fails_as(TS_KIND_FORMAT, ts_trace_open(context, &trace, folder), "width");
	fails_as(TS_KIND_FORMAT, ts_image_read(&pixels, &width, &height, &channels, path), "expected");
	fails_as(TS_KIND_FORMAT, ts_image_decode(&rgba, &width, &height, "no picture", 10, 100, "bytes"), "bytes");
	remove_folder(folder);
}

/* A sanitizer has an address space of its own. */
static void too_little_memory_is_of_its_kind(void **state)
{
	(void)state;
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	skip();
#endif
	ts_scene *made;
	struct rlimit usual;
	assert_int_equal(getrlimit(RLIMIT_AS, &usual), 0);
	assert_int_equal(setrlimit(RLIMIT_AS, &(struct rlimit){(rlim_t)1 << 20, usual.rlim_max}), 0);
	ts_status status = ts_scene_open(context, &made, "atrium:triangles=1M", params, NULL);
	assert_int_equal(setrlimit(RLIMIT_AS, &usual), 0);
	fails_as(TS_KIND_MEMORY, status, "no memory");
}

static void missing_devices_are_of_their_kind(void **state)
{
	(void)state;
	ts_context *none;
	ts_device_info device = {.bytes = sizeof device};
	assert_int_equal(setenv("OCL_ICD_VENDORS", "/nonexistent", 1), 0);
	const ts_context_options options = {.bytes = sizeof options, .backend = "opencl"};
	fails_as(TS_KIND_DEVICE, ts_context_open(&none, &options), "no OpenCL device");
	fails_as(TS_KIND_DEVICE, ts_device_at(&device, "c", 1), "no device 1");
	const ts_context_options unknown = {.bytes = sizeof unknown, .backend = "metal"};
	fails_as(TS_KIND_ARGUMENT, ts_context_open(&none, &unknown), "metal");
}

static int at_once(void *user)
{
	(void)user;
	return 1;
}

static void ended_runs_are_of_their_kind(void **state)
{
	(void)state;
	ts_context *ended;
	ts_trace *trace;
	ts_truth_image *image;
	const ts_context_options options = {.bytes = sizeof options, .cancelled = at_once};
	done(ts_context_open(&ended, &options));
	fails_as(TS_KIND_CANCELLED, ts_trace_run(ended, &trace, scene, params, "reflections", "mvr", NULL), "cancelled");
	fails_as(TS_KIND_CANCELLED, ts_truth_render(ended, &image, scene, params, "reflections", "B"), "cancelled");
	ts_context_close(ended);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(before_a_failure_there_is_no_kind), cmocka_unit_test(wrong_arguments_are_of_their_kind),
		cmocka_unit_test(missing_files_are_of_their_kind),   cmocka_unit_test(damaged_files_are_of_their_kind),
		cmocka_unit_test(too_little_memory_is_of_its_kind),  cmocka_unit_test(missing_devices_are_of_their_kind),
		cmocka_unit_test(ended_runs_are_of_their_kind),
	};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}
