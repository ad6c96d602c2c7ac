/* One call of the library for tests/faults/commands.txt: api CALL IN, where IN holds what scripts/faults made. What the
 * call needs is made first; only then allocations count. A call that fails says why on standard error, as the command
 * does, and is made again when memory is back. What comes out of it is summed up in the file `sum`. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <touchstone/touchstone.h>

enum { PATH = 1024, SIDE = 8 };

static ts_context *context;
static ts_params *params;
static ts_scene *scene;
static ts_trace *first, *second; /* the other a port's, with a wrong pixel */
static ts_tree *tree;
static char in[PATH];
static uint64_t sum;

static void add(const void *data, size_t bytes)
{
	for (size_t i = 0; i < bytes; i++) sum = (sum ^ ((const uint8_t *)data)[i]) * 1099511628211u;
}

/* The file of that name in IN. */
static const char *file(const char *name)
{
	static char path[2 * PATH];
	snprintf(path, sizeof path, "%s/%s", in, name);
	return path;
}

static ts_status add_image(ts_trace *trace)
{
	const ts_buffer_view *image = ts_trace_buffer(trace, "image.srgb");
	if (image == NULL) return TS_ERROR;
	add(image->data, (size_t)(image->shape[0] * image->shape[1] * 3));
	return TS_OK;
}

static ts_status add_tree(ts_tree *answer)
{
	char *json = answer != NULL ? ts_tree_json(answer) : NULL;
	if (json != NULL) add(json, strlen(json));
	free(json);
	return json != NULL ? TS_OK : TS_ERROR;
}

/* What needs nothing. */

static ts_status open_context(uint32_t threads)
{
	ts_context *made;
	ts_status status =
		ts_context_open(&made, &(ts_context_options){.bytes = sizeof(ts_context_options), .threads = threads});
	ts_context_close(made);
	return status;
}

static ts_status context_one(void) { return open_context(1); }
static ts_status context_two(void) { return open_context(2); }

static ts_status set_params(void)
{
	ts_params *made, *copy = NULL;
	ts_status status = ts_params_make(&made);
	if (status == TS_OK) status = ts_params_set(made, "eye.fov", "45.5");
	if (status == TS_OK) status = ts_params_copy(&copy, made);
	ts_params_free(made);
	ts_params_free(copy);
	return status;
}

static ts_status walk_tables(void)
{
	for (size_t i = 0; ts_method_at(i) != NULL; i++) add(ts_method_at(i)->name, strlen(ts_method_at(i)->name));
	for (size_t i = 0; ts_stage_at(i) != NULL; i++) add(ts_stage_at(i)->name, strlen(ts_stage_at(i)->name));
	for (size_t i = 0; ts_vector_at(i) != NULL; i++) add(ts_vector_at(i)->name, strlen(ts_vector_at(i)->name));
	for (size_t i = 0; ts_probe_at(i) != NULL; i++) add(ts_probe_at(i)->methods, strlen(ts_probe_at(i)->methods));
	for (size_t i = 0; ts_truth_at(i) != NULL; i++) add(ts_truth_at(i)->name, strlen(ts_truth_at(i)->name));
	return TS_OK;
}

/* Scenes. */

static ts_status open_scene(const char *spec)
{
	ts_scene *made;
	ts_status status = ts_scene_open(context, &made, spec, params, NULL);
	ts_scene_free(made);
	return status;
}

static ts_status scene_gltf(void) { return open_scene(file("room.gltf")); }
static ts_status scene_ply(void) { return open_scene(file("splats.ply")); }
static ts_status scene_builtin(void) { return open_scene("atrium:triangles=10000:texels=32"); }

static ts_status scene_arrays(void)
{
	static const ts_vertex corners[3] = {{.position = {-1, 0, 1}, .normal = {0, 1, 0}, .colour = {1, 1, 1, 1}},
	                                     {.position = {1, 0, 1}, .normal = {0, 1, 0}, .colour = {1, 1, 1, 1}},
	                                     {.position = {1, 0, -1}, .normal = {0, 1, 0}, .colour = {1, 1, 1, 1}}};
	static const ts_triangle face = {.vertex = {0, 1, 2}, .material = TS_NO_INDEX};
	const ts_scene_arrays arrays = {
		.bytes = sizeof arrays, .vertices = corners, .n_vertices = 3, .triangles = &face, .n_triangles = 1};
	ts_scene *made;
	ts_status status = ts_scene_make(context, &made, &arrays, params, NULL);
	ts_scene_free(made);
	return status;
}

/* Traces. */

static ts_status run(const char *effect, const char *method)
{
	ts_trace *made;
	ts_status status = ts_trace_run(context, &made, scene, params, effect, method, NULL);
	if (status == TS_OK) status = add_image(made);
	ts_trace_close(made);
	return status;
}

static ts_status run_epr(void) { return run("reflections", "epr"); }
static ts_status run_ivir(void) { return run("reflections", "ivir"); }

static ts_status write_trace(void)
{
	const ts_write_options options = {.bytes = sizeof options, .compress = 1};
	return ts_trace_write(context, "out", scene, params, "reflections", "mvr", &options);
}

static ts_status save_trace(void) { return ts_trace_save(context, first, "out", "a port"); }

static ts_status open_trace(void)
{
	ts_trace *made;
	ts_status status = ts_trace_open(context, &made, file("frame-0/trace-epr"));
	if (status == TS_OK) status = add_image(made);
	ts_trace_close(made);
	return status;
}

static ts_status candidate(void)
{
	ts_trace *made;
	const ts_buffer_view *image = ts_trace_buffer(first, "image.srgb");
	size_t bytes = image != NULL ? (size_t)(image->shape[0] * image->shape[1] * 3) : 0;
	ts_status status = ts_trace_candidate(context, &made, first, 0);
	if (status == TS_OK) status = ts_trace_put(made, "image.srgb", image->n_dims, image->shape, image->data, bytes);
	if (status == TS_OK) status = add_image(made);
	ts_trace_close(made);
	return status;
}

/* Answers. */

static ts_status add_answer(ts_status status, ts_tree *answer)
{
	if (status != TS_ERROR) status = add_tree(answer);
	ts_tree_free(answer);
	return status;
}

static ts_status add_verdicts(ts_status status, ts_verdicts *verdicts)
{
	if (status != TS_ERROR) status = add_answer(TS_OK, ts_verdicts_tree(verdicts));
	ts_verdicts_free(verdicts);
	return status;
}

static ts_status compare(void)
{
	ts_verdicts *verdicts;
	ts_status status = ts_compare(context, &verdicts, first, second, NULL);
	return add_verdicts(status, verdicts);
}

static ts_status replay(void)
{
	ts_verdicts *verdicts;
	ts_status status = ts_replay(context, &verdicts, "splat", first, second, NULL);
	return add_verdicts(status, verdicts);
}

static ts_status probe(void)
{
	ts_tree *answer;
	ts_status status = ts_probe_pixel(context, &answer, first, 8, 8, NULL);
	return add_answer(status, answer);
}

static ts_status explain(void)
{
	const ts_explain_options options = {.bytes = sizeof options, .stage = "splat", .item_said = 1, .item = 3};
	ts_tree *answer;
	ts_status status = ts_explain_item(context, &answer, &options, first, NULL, NULL);
	return add_answer(status, answer);
}

static ts_status json(void) { return add_tree(tree); }

static ts_status html(void)
{
	ts_html *page;
	ts_verdicts *verdicts = NULL;
	ts_status status = ts_html_open(context, &page, NULL);
	if (status == TS_OK) status = ts_html_add_trace(page, first);
	if (status == TS_OK && ts_compare(context, &verdicts, first, second, NULL) == TS_ERROR) status = TS_ERROR;
	if (status == TS_OK)
		status = ts_html_add_verdicts(page, verdicts, first, second, NULL, "{\"case\": \"a long name\"}");
	if (status == TS_OK) status = ts_html_write(page, "page.html");
	ts_verdicts_free(verdicts);
	ts_html_close(page);
	return status;
}

static ts_status rendering(void)
{
	const ts_rendering_options options = {.bytes = sizeof options, .methods = "mvr"};
	ts_rendering *made;
	ts_status status = ts_rendering_make(context, &made, scene, params, "reflections", &options);
	const ts_rendering_picture *picture = status == TS_OK ? ts_rendering_picture_at(made, 0) : NULL;
	if (picture != NULL) add(picture->srgb, (size_t)picture->width * picture->height * 3);
	ts_rendering_free(made);
	return status;
}

static ts_status truth(void)
{
	ts_truth_image *image;
	ts_status status = ts_truth_render(context, &image, scene, params, "reflections", "A");
	if (status == TS_OK) add(image->srgb, (size_t)image->width * image->height * 3);
	ts_truth_image_free(image);
	return status;
}

static ts_status golden(void)
{
	ts_golden_judged judged = {.bytes = sizeof judged};
	ts_status status = ts_golden_check(context, &judged, file("golden"));
	add(judged.text, strlen(judged.text));
	return status;
}

static ts_status words(void)
{
	static uint32_t out[1 << 20];
	ts_vector_judged judged = {.bytes = sizeof judged};
	ts_status status = ts_vector_words(context, NULL, out, "normalize");
	if (status == TS_OK) status = ts_vector_check(context, &judged, "normalize", out);
	return status;
}

/* Pictures. */

static const ts_image_text texts[] = {{"Software", "touchstone"}, {NULL, NULL}};

static ts_status write_png(void)
{
	uint8_t pixels[SIDE * SIDE * 3] = {1, 2, 3};
	return ts_image_write_png("picture.png", pixels, SIDE, SIDE, 3, texts);
}

static ts_status write_exr(void)
{
	float pixels[SIDE * SIDE * 3] = {1, 2, 3};
	return ts_image_write_exr("picture.exr", pixels, SIDE, SIDE, 3, texts);
}

static ts_status read_image(const char *name)
{
	float *pixels;
	uint32_t width, height, channels;
	ts_status status = ts_image_read(&pixels, &width, &height, &channels, file(name));
	if (status == TS_OK) add(pixels, (size_t)width * height * channels * sizeof *pixels);
	free(pixels);
	return status;
}

static ts_status read_png(void) { return read_image("mvr.png"); }
static ts_status read_exr(void) { return read_image("mvr.exr"); }

static uint8_t png[1 << 16]; /* mvr.png */
static size_t png_bytes;

static ts_status decode_png(void)
{
	uint8_t *rgba;
	uint32_t width, height;
	ts_status status = ts_image_decode(&rgba, &width, &height, png, png_bytes, 1 << 20, "mvr.png");
	if (status == TS_OK) add(rgba, (size_t)width * height * 4);
	free(rgba);
	return status;
}

typedef struct {
	const char *name;
	ts_status (*make)(void);
	int needs; /* 1: a context; 2: also a scene; 3: also traces */
} call;

static const call calls[] = {
	{"context", context_one, 0},
	{"threads", context_two, 0},
	{"params", set_params, 0},
	{"tables", walk_tables, 0},
	{"gltf", scene_gltf, 1},
	{"ply", scene_ply, 1},
	{"arrays", scene_arrays, 1},
	{"builtin", scene_builtin, 1},
	{"epr", run_epr, 2},
	{"ivir", run_ivir, 2},
	{"write", write_trace, 2},
	{"save", save_trace, 3},
	{"open", open_trace, 1},
	{"candidate", candidate, 3},
	{"compare", compare, 3},
	{"replay", replay, 3},
	{"probe", probe, 3},
	{"explain", explain, 3},
	{"json", json, 3},
	{"html", html, 3},
	{"rendering", rendering, 2},
	{"truth", truth, 2},
	{"golden", golden, 1},
	{"words", words, 1},
	{"write_png", write_png, 0},
	{"read_png", read_png, 0},
	{"decode_png", decode_png, 0},
	{"write_exr", write_exr, 0},
	{"read_exr", read_exr, 0},
};
enum { N_CALLS = sizeof calls / sizeof *calls };

static void need(ts_status status)
{
	if (status == TS_OK) return;
	fprintf(stderr, "api: %s\n", ts_error_message());
	exit(3);
}

static void port(void)
{
	static uint8_t pixels[1 << 12];
	const ts_buffer_info *buffer;
	need(ts_trace_candidate(context, &second, first, 0));
	for (size_t i = 0; (buffer = ts_buffer_at(i)) != NULL; i++) {
		if (!ts_trace_has(first, buffer->name)) continue;
		const ts_buffer_view *view = ts_trace_buffer(first, buffer->name);
		size_t bytes = view->element_bytes;
		for (uint32_t k = 0; k < view->n_dims; k++) bytes *= (size_t)view->shape[k];
		bool picture = strcmp(buffer->name, "image.srgb") == 0 && bytes <= sizeof pixels;
		if (picture) memcpy(pixels, view->data, bytes);
		pixels[100] ^= 1;
		need(ts_trace_put(second, view->name, view->n_dims, view->shape, picture ? pixels : view->data, bytes));
	}
}

static void prepare(int needs)
{
	static const char *const small[][2] = {
		{"width", "16"}, {"height", "16"}, {"reflectors.count", "1"}, {"cube.max_px", "16"}};
	const ts_context_options one = {.bytes = sizeof one, .threads = 1};
	FILE *picture = fopen(file("mvr.png"), "rb");
	if (picture != NULL) png_bytes = fread(png, 1, sizeof png, picture);
	if (picture != NULL) fclose(picture);
	if (needs < 1) return;
	need(ts_context_open(&context, &one));
	need(ts_params_make(&params));
	for (size_t i = 0; i < sizeof small / sizeof *small; i++) need(ts_params_set(params, small[i][0], small[i][1]));
	if (needs < 2) return;
	need(ts_scene_open(context, &scene, file("triangle.gltf"), params, NULL));
	if (needs < 3) return;
	need(ts_trace_run(context, &first, scene, params, "reflections", "epr", NULL));
	port();
	need(ts_probe_pixel(context, &tree, first, 8, 8, NULL));
}

/* Tells the library of tests/faults, if it is there. */
static void tell(const char *name)
{
	void *symbol = dlsym(RTLD_DEFAULT, name);
	void (*function)(void);
	memcpy(&function, &symbol, sizeof function);
	if (symbol != NULL) function();
}

/* Sums up what came out. */
static int finish(int code)
{
	FILE *out = fopen("sum", "w");
	if (out == NULL || fprintf(out, "%016llx\n", (unsigned long long)sum) < 0 || fclose(out) != 0) return 3;
	return code;
}

int main(int n_words, char **word)
{
	const call *c = calls;
	while (n_words == 3 && c < calls + N_CALLS && strcmp(c->name, word[1]) != 0) c++;
	if (n_words != 3 || c == calls + N_CALLS) return fputs("api: CALL IN would be right\n", stderr), 3;
	snprintf(in, sizeof in, "%s", word[2]);
	prepare(c->needs);
	tell("ts_fault_begin");
	ts_status status = c->make();
	tell("ts_fault_end");
	if (status == TS_OK) return finish(0);
	fprintf(stderr, "touchstone: %s\n", ts_error_message());
	sum = 0;
	status = c->make();
	if (status != TS_OK) fprintf(stderr, "api: again: %s\n", ts_error_message());
	return status == TS_OK ? finish(2) : 3;
}
