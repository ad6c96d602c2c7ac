/* Every function of the public headers, with NULL in the place of each argument that must point to something: refused
 * in one line that names the argument, or nothing done. tests/headers/functions.sh holds that none is forgotten. */
#include "tests/api/run.h"

#define REFUSED(call, name) refused(call, name " is NULL")

static void releasing_null_does_nothing(void **state)
{
	(void)state;
	ts_context_close(NULL);
	ts_params_free(NULL);
	ts_scene_free(NULL);
	ts_trace_close(NULL);
	ts_verdicts_free(NULL);
	ts_tree_free(NULL);
}

static void null_parameters_are_refused(void **state)
{
	(void)state;
	ts_params *copy;
	char text[64];
	REFUSED(ts_params_make(NULL), "params");
	REFUSED(ts_params_copy(NULL, params), "copy");
	REFUSED(ts_params_copy(&copy, NULL), "params");
	assert_null(copy);
	REFUSED(ts_params_set(NULL, "width", "64"), "params");
	REFUSED(ts_params_set(params, NULL, "64"), "name");
	REFUSED(ts_params_set(params, "width", NULL), "value");
	REFUSED(ts_params_get(NULL, "width", text, sizeof text), "params");
	REFUSED(ts_params_get(params, NULL, text, sizeof text), "name");
	REFUSED(ts_params_get(params, "width", NULL, sizeof text), "text");
}

static void null_scenes_are_refused(void **state)
{
	(void)state;
	ts_scene *made;
	const ts_scene_arrays arrays = {.bytes = sizeof arrays}, none = {.bytes = 0};
	REFUSED(ts_context_open(NULL, NULL), "context");
	REFUSED(ts_scene_open(NULL, &made, SMALL, params, NULL), "context");
	REFUSED(ts_scene_open(context, NULL, SMALL, params, NULL), "scene");
	REFUSED(ts_scene_open(context, &made, NULL, params, NULL), "spec");
	REFUSED(ts_scene_open(context, &made, SMALL, NULL, NULL), "params");
	REFUSED(ts_scene_open_bytes(NULL, &made, "{}", 2, "it", params, NULL), "context");
	REFUSED(ts_scene_open_bytes(context, NULL, "{}", 2, "it", params, NULL), "scene");
	REFUSED(ts_scene_open_bytes(context, &made, NULL, 2, "it", params, NULL), "file");
	REFUSED(ts_scene_open_bytes(context, &made, "{}", 2, NULL, params, NULL), "name");
	REFUSED(ts_scene_open_bytes(context, &made, "{}", 2, "it", NULL, NULL), "params");
	REFUSED(ts_scene_make(NULL, &made, &arrays, params, NULL), "context");
	REFUSED(ts_scene_make(context, NULL, &arrays, params, NULL), "scene");
	REFUSED(ts_scene_make(context, &made, NULL, params, NULL), "arrays");
	REFUSED(ts_scene_make(context, &made, &arrays, NULL, NULL), "params");
	assert_null(made);
	refused(ts_scene_make(context, &made, &none, params, NULL), "bytes");
	refused(ts_scene_open(context, &made, SMALL, params, &(ts_scene_options){.bytes = 0}), "bytes");
	REFUSED(ts_scene_print(NULL, stdout, 0), "scene");
	REFUSED(ts_scene_print(scene, NULL, 0), "out");
}

static void ignore(void *user, const char *buffer, const char *hex)
{
	(void)user;
	(void)buffer;
	(void)hex;
}

static void null_traces_are_refused(void **state)
{
	(void)state;
	ts_trace *made;
	uint64_t shape[1] = {0};
	char hex[65];
	REFUSED(ts_trace_run(NULL, &made, scene, params, "reflections", "epr", NULL), "context");
	REFUSED(ts_trace_run(context, NULL, scene, params, "reflections", "epr", NULL), "trace");
	REFUSED(ts_trace_run(context, &made, NULL, params, "reflections", "epr", NULL), "scene");
	REFUSED(ts_trace_run(context, &made, scene, NULL, "reflections", "epr", NULL), "params");
	REFUSED(ts_trace_run(context, &made, scene, params, NULL, "epr", NULL), "effect");
	REFUSED(ts_trace_run(context, &made, scene, params, "reflections", NULL, NULL), "method");
	refused(ts_trace_run(context, &made, scene, params, "reflections", "epr", &(ts_run_options){.bytes = 0}), "bytes");
	REFUSED(ts_trace_open(NULL, &made, "."), "context");
	REFUSED(ts_trace_open(context, NULL, "."), "trace");
	REFUSED(ts_trace_open(context, &made, NULL), "folder");
	REFUSED(ts_trace_open_npy(NULL, &made, "a.npy"), "context");
	REFUSED(ts_trace_open_npy(context, NULL, "a.npy"), "trace");
	REFUSED(ts_trace_open_npy(context, &made, NULL), "path");
	REFUSED(ts_trace_open_list(NULL, &made, ".", "a=b", 0, reference), "context");
	REFUSED(ts_trace_open_list(context, NULL, ".", "a=b", 0, reference), "trace");
	REFUSED(ts_trace_open_list(context, &made, NULL, "a=b", 0, reference), "folder");
	REFUSED(ts_trace_open_list(context, &made, ".", NULL, 0, reference), "list");
	REFUSED(ts_trace_open_list(context, &made, ".", "a=b", 0, NULL), "reference");
	assert_null(ts_trace_about(NULL));
	assert_null(ts_trace_look(NULL, "eye.view"));
	assert_null(ts_trace_look(reference, NULL));
	REFUSED(ts_trace_candidate(NULL, &made, reference, 0), "context");
	REFUSED(ts_trace_candidate(context, NULL, reference, 0), "trace");
	REFUSED(ts_trace_candidate(context, &made, NULL, 0), "reference");
	assert_null(made);
	REFUSED(ts_trace_put(NULL, "points.key", 1, shape, hex, 0), "trace");
	REFUSED(ts_trace_put(reference, NULL, 1, shape, hex, 0), "buffer");
	REFUSED(ts_trace_put(reference, "points.key", 1, NULL, hex, 0), "shape");
	shape[0] = 1;
	REFUSED(ts_trace_put(reference, "points.key", 1, shape, NULL, 8), "data");
	assert_false(ts_trace_has(NULL, "points.key"));
	assert_false(ts_trace_has(reference, NULL));
	assert_null(ts_trace_buffer(NULL, "points.key"));
	assert_null(ts_trace_buffer(reference, NULL));
	REFUSED(ts_trace_digest(NULL, "points.key", hex), "trace");
	REFUSED(ts_trace_digest(reference, NULL, hex), "name");
	REFUSED(ts_trace_digest(reference, "points.key", NULL), "hex");
	REFUSED(ts_run_digests(NULL, scene, params, "reflections", "epr", ignore, NULL), "context");
	REFUSED(ts_run_digests(context, NULL, params, "reflections", "epr", ignore, NULL), "scene");
	REFUSED(ts_run_digests(context, scene, NULL, "reflections", "epr", ignore, NULL), "params");
	REFUSED(ts_run_digests(context, scene, params, NULL, "epr", ignore, NULL), "effect");
	REFUSED(ts_run_digests(context, scene, params, "reflections", NULL, ignore, NULL), "method");
	REFUSED(ts_run_digests(context, scene, params, "reflections", "epr", NULL, NULL), "each");
	assert_int_equal(ts_trace_counter(NULL, "points"), 0);
	assert_int_equal(ts_trace_counter(reference, NULL), 0);
}

static void null_verdicts_are_refused(void **state)
{
	(void)state;
	ts_verdicts *verdicts;
	ts_trace *made;
	REFUSED(ts_compare(NULL, &verdicts, reference, reference, NULL), "context");
	REFUSED(ts_compare(context, NULL, reference, reference, NULL), "verdicts");
	REFUSED(ts_compare(context, &verdicts, NULL, reference, NULL), "reference");
	REFUSED(ts_compare(context, &verdicts, reference, NULL, NULL), "candidate");
	refused(ts_compare(context, &verdicts, reference, reference, &(ts_compare_options){.bytes = 0}), "bytes");
	REFUSED(ts_replay(NULL, &verdicts, "eye", reference, NULL, NULL), "context");
	REFUSED(ts_replay(context, NULL, "eye", reference, NULL, NULL), "verdicts");
	REFUSED(ts_replay(context, &verdicts, NULL, reference, NULL, NULL), "stage");
	REFUSED(ts_replay(context, &verdicts, "eye", NULL, NULL, NULL), "reference");
	assert_null(verdicts);
	REFUSED(ts_trace_replay(NULL, &made, "eye", reference, NULL), "context");
	REFUSED(ts_trace_replay(context, NULL, "eye", reference, NULL), "trace");
	REFUSED(ts_trace_replay(context, &made, NULL, reference, NULL), "stage");
	REFUSED(ts_trace_replay(context, &made, "eye", NULL, NULL), "reference");
	assert_null(made);
	assert_null(ts_verdicts_at(NULL, 0));
	assert_null(ts_verdicts_first(NULL));
	assert_null(ts_verdicts_difference(NULL, 0, 0));
	assert_null(ts_verdicts_field(NULL, 0, 0));
	assert_null(ts_verdicts_tree(NULL));
	uint8_t marks[4];
	REFUSED(ts_compare_marks(NULL, marks, 4, "eye.view", reference, reference, NULL), "context");
	REFUSED(ts_compare_marks(context, NULL, 4, "eye.view", reference, reference, NULL), "marks");
	REFUSED(ts_compare_marks(context, marks, 4, NULL, reference, reference, NULL), "buffer");
	REFUSED(ts_compare_marks(context, marks, 4, "eye.view", NULL, reference, NULL), "reference");
	REFUSED(ts_compare_marks(context, marks, 4, "eye.view", reference, NULL, NULL), "candidate");
}

static void null_pages_are_refused(void **state)
{
	(void)state;
	ts_html *page;
	ts_verdicts *verdicts;
	const uint8_t rgb[3] = {0};
	REFUSED(ts_html_open(NULL, &page, NULL), "context");
	REFUSED(ts_html_open(context, NULL, NULL), "page");
	done(ts_html_open(context, &page, NULL));
	done(ts_compare(context, &verdicts, reference, reference, NULL));
	REFUSED(ts_html_add_picture(NULL, "a", "a", rgb, 1, 1), "page");
	REFUSED(ts_html_add_picture(page, NULL, "a", rgb, 1, 1), "name");
	REFUSED(ts_html_add_picture(page, "a", NULL, rgb, 1, 1), "from");
	REFUSED(ts_html_add_picture(page, "a", "a", NULL, 1, 1), "rgb");
	REFUSED(ts_html_add_folder(NULL, "a"), "page");
	REFUSED(ts_html_add_folder(page, NULL), "folder");
	REFUSED(ts_html_add_trace(NULL, reference), "page");
	REFUSED(ts_html_add_trace(page, NULL), "trace");
	REFUSED(ts_html_add_verdicts(NULL, verdicts, reference, reference, NULL, NULL), "page");
	REFUSED(ts_html_add_verdicts(page, NULL, reference, reference, NULL, NULL), "verdicts");
	REFUSED(ts_html_add_verdicts(page, verdicts, NULL, reference, NULL, NULL), "reference");
	REFUSED(ts_html_add_verdicts(page, verdicts, reference, NULL, NULL, NULL), "candidate");
	REFUSED(ts_html_add_pair(NULL, "{}"), "page");
	REFUSED(ts_html_add_pair(page, NULL), "json");
	REFUSED(ts_html_write(NULL, "/tmp/page.html"), "page");
	REFUSED(ts_html_write(page, NULL), "path");
	ts_verdicts_free(verdicts);
	ts_html_close(page);
	ts_html_close(NULL);
}

static void null_explanations_are_refused(void **state)
{
	(void)state;
	ts_tree *answer;
	ts_golden_judged judged = {.bytes = sizeof judged};
	const ts_explain_options o = {.bytes = sizeof o, .stage = "eye"};
	REFUSED(ts_explain_item(NULL, &answer, &o, reference, NULL, NULL), "context");
	REFUSED(ts_explain_item(context, NULL, &o, reference, NULL, NULL), "answer");
	REFUSED(ts_explain_item(context, &answer, NULL, reference, NULL, NULL), "options");
	REFUSED(ts_explain_item(context, &answer, &o, NULL, NULL, NULL), "trace");
	REFUSED(ts_explain_item(context, &answer, &(ts_explain_options){.bytes = sizeof o}, reference, NULL, NULL),
	        "stage");
	assert_null(answer);
	REFUSED(ts_golden_check(NULL, &judged, "."), "context");
	REFUSED(ts_golden_check(context, NULL, "."), "judged");
	REFUSED(ts_golden_check(context, &judged, NULL), "folder");
	REFUSED(ts_trace_save(NULL, reference, "/tmp/none", NULL), "context");
	REFUSED(ts_trace_save(context, NULL, "/tmp/none", NULL), "trace");
	REFUSED(ts_trace_save(context, reference, NULL, NULL), "folder");
	REFUSED(ts_trace_match(NULL, reference), "reference");
	done(ts_trace_match(reference, NULL));
	assert_int_equal(ts_trace_takes(NULL, "eye") + ts_trace_takes(reference, NULL), 0);
	char text[TS_FLOAT_TEXT];
	ts_float_text(NULL, 1);
	ts_float_text(text, 1);
	assert_string_equal(text, "1 = 0x1p+0 (3f800000)");
	assert_int_equal(ts_float_passes(NULL, 1, 1) + 2 * ts_float_passes(NULL, 1, 1.0000001f), 1);
	REFUSED(ts_trace_write(NULL, "/tmp/none", scene, params, "reflections", "epr", NULL), "context");
	REFUSED(ts_trace_write(context, NULL, scene, params, "reflections", "epr", NULL), "folder");
	REFUSED(ts_trace_write(context, "/tmp/none", NULL, params, "reflections", "epr", NULL), "scene");
	REFUSED(ts_trace_write(context, "/tmp/none", scene, NULL, "reflections", "epr", NULL), "params");
	REFUSED(ts_trace_write(context, "/tmp/none", scene, params, NULL, "epr", NULL), "effect");
	REFUSED(ts_trace_write(context, "/tmp/none", scene, params, "reflections", NULL, NULL), "method");
}

static void null_truths_are_refused(void **state)
{
	(void)state;
	ts_truth_image *image;
	REFUSED(ts_truth_render(NULL, &image, scene, params, "reflections", "A"), "context");
	REFUSED(ts_truth_render(context, NULL, scene, params, "reflections", "A"), "image");
	REFUSED(ts_truth_render(context, &image, NULL, params, "reflections", "A"), "scene");
	REFUSED(ts_truth_render(context, &image, scene, NULL, "reflections", "A"), "params");
	REFUSED(ts_truth_render(context, &image, scene, params, NULL, "A"), "effect");
	REFUSED(ts_truth_render(context, &image, scene, params, "reflections", NULL), "truth");
	assert_null(image);
	ts_truth_image_free(NULL);
}

static void null_renderings_are_refused(void **state)
{
	(void)state;
	double value;
	ts_rendering *rendering;
	REFUSED(ts_rendering_make(NULL, &rendering, scene, params, "reflections", NULL), "context");
	REFUSED(ts_rendering_make(context, NULL, scene, params, "reflections", NULL), "rendering");
	REFUSED(ts_rendering_make(context, &rendering, NULL, params, "reflections", NULL), "scene");
	REFUSED(ts_rendering_make(context, &rendering, scene, NULL, "reflections", NULL), "params");
	REFUSED(ts_rendering_make(context, &rendering, scene, params, NULL, NULL), "effect");
	assert_null(rendering);
	done(ts_rendering_make(context, &rendering, scene, params, "reflections", NULL));
	REFUSED(ts_rendering_figure_named(NULL, rendering, "epr.ms.frame"), "value");
	REFUSED(ts_rendering_figure_named(&value, NULL, "epr.ms.frame"), "rendering");
	REFUSED(ts_rendering_figure_named(&value, rendering, NULL), "name");
	ts_rendering_figure figure = {.bytes = sizeof figure};
	REFUSED(ts_rendering_figure_at(NULL, rendering, 0), "figure");
	REFUSED(ts_rendering_figure_at(&figure, NULL, 0), "rendering");
	assert_int_equal(ts_rendering_figure_at(&figure, rendering, 1000000), TS_SKIPPED);
	figure.bytes = 3;
	refused(ts_rendering_figure_at(&figure, rendering, 0), "bytes");
	assert_null(ts_rendering_picture_at(NULL, 0));
	const ts_rendering_picture *picture;
	REFUSED(ts_rendering_picture_named(NULL, &picture, rendering, "epr"), "context");
	REFUSED(ts_rendering_picture_named(context, NULL, rendering, "epr"), "picture");
	REFUSED(ts_rendering_picture_named(context, &picture, NULL, "epr"), "rendering");
	REFUSED(ts_rendering_picture_named(context, &picture, rendering, NULL), "name");
	assert_null(picture);
	ts_rendering_free(rendering);
	ts_rendering_free(NULL);
	ts_tree *figures;
	REFUSED(ts_bench_table(NULL, &figures, "epr-3", params, NULL), "context");
	REFUSED(ts_bench_table(context, NULL, "epr-3", params, NULL), "figures");
	REFUSED(ts_bench_table(context, &figures, NULL, params, NULL), "table");
	REFUSED(ts_bench_table(context, &figures, "epr-3", NULL, NULL), "params");
	assert_null(figures);
}

static void null_answers_are_refused(void **state)
{
	(void)state;
	ts_tree *answer;
	REFUSED(ts_probe_pixel(NULL, &answer, reference, 0, 0, NULL), "context");
	REFUSED(ts_probe_pixel(context, NULL, reference, 0, 0, NULL), "answer");
	REFUSED(ts_probe_pixel(context, &answer, NULL, 0, 0, NULL), "trace");
	REFUSED(ts_probe_triangle(NULL, &answer, reference, 0), "context");
	REFUSED(ts_probe_triangle(context, NULL, reference, 0), "answer");
	REFUSED(ts_probe_triangle(context, &answer, NULL, 0), "trace");
	REFUSED(ts_probe_point(NULL, &answer, reference, 0), "context");
	REFUSED(ts_probe_point(context, NULL, reference, 0), "answer");
	REFUSED(ts_probe_point(context, &answer, NULL, 0), "trace");
	const int64_t key[3] = {0};
	REFUSED(ts_probe_point_key(NULL, &answer, reference, key), "context");
	REFUSED(ts_probe_point_key(context, NULL, reference, key), "answer");
	REFUSED(ts_probe_point_key(context, &answer, NULL, key), "trace");
	REFUSED(ts_probe_point_key(context, &answer, reference, NULL), "key");
	assert_null(answer);
	assert_int_equal(ts_tree_kind_of(NULL), TS_TREE_NULL);
	assert_int_equal(ts_tree_n(NULL), 0);
	assert_null(ts_tree_at(NULL, 0));
	assert_null(ts_tree_name(NULL, 0));
	assert_null(ts_tree_get(NULL, "x"));
	assert_int_equal(ts_tree_integer(NULL), 0);
	assert_true(ts_tree_real(NULL) == 0);
	assert_null(ts_tree_text(NULL));
	assert_null(ts_tree_json(NULL));
}

static void null_vectors_are_refused(void **state)
{
	(void)state;
	static uint32_t found[1 << 20];
	ts_vector_judged judged = {.bytes = sizeof judged};
	REFUSED(ts_vector_words(NULL, NULL, NULL, "fma"), "context");
	REFUSED(ts_vector_words(context, NULL, NULL, NULL), "primitive");
	REFUSED(ts_vector_check(NULL, &judged, "fma", found), "context");
	REFUSED(ts_vector_check(context, NULL, "fma", found), "judged");
	REFUSED(ts_vector_check(context, &judged, NULL, found), "primitive");
	REFUSED(ts_vector_check(context, &judged, "fma", NULL), "found");
	judged.bytes = 0;
	refused(ts_vector_check(context, &judged, ts_vector_at(0)->name, found), "bytes");
	assert_null(ts_stage_input(NULL, 0));
	assert_null(ts_stage_output(NULL, 0));
	assert_null(ts_method_stage(NULL, "epr", 0));
	assert_null(ts_method_stage("reflections", NULL, 0));
	assert_int_equal(ts_method_stage_number(NULL, "epr", 0), 0);
	assert_int_equal(ts_method_stage_number("reflections", NULL, 0), 0);
	assert_int_equal(ts_buffer_is_image(NULL), 0);
	ts_device_info device = {.bytes = sizeof device};
	REFUSED(ts_device_at(NULL, "c", 0), "device");
	REFUSED(ts_device_at(&device, NULL, 0), "backend");
}

static void null_images_are_refused(void **state)
{
	(void)state;
	uint8_t *rgba, bytes[4] = {0};
	float *pixels;
	uint32_t width, height, channels;
	REFUSED(ts_image_decode(NULL, &width, &height, bytes, 4, 100, "it"), "rgba");
	REFUSED(ts_image_decode(&rgba, NULL, &height, bytes, 4, 100, "it"), "width");
	REFUSED(ts_image_decode(&rgba, &width, NULL, bytes, 4, 100, "it"), "height");
	REFUSED(ts_image_decode(&rgba, &width, &height, NULL, 4, 100, "it"), "file");
	REFUSED(ts_image_decode(&rgba, &width, &height, bytes, 4, 100, NULL), "what");
	REFUSED(ts_image_write_png(NULL, bytes, 1, 1, 4, NULL), "path");
	REFUSED(ts_image_write_png("x.png", NULL, 1, 1, 4, NULL), "pixels");
	REFUSED(ts_image_write_exr(NULL, (const float[1]){0}, 1, 1, 1, NULL), "path");
	REFUSED(ts_image_write_exr("x.exr", NULL, 1, 1, 1, NULL), "pixels");
	REFUSED(ts_image_read(NULL, &width, &height, &channels, "x.png"), "pixels");
	REFUSED(ts_image_read(&pixels, NULL, &height, &channels, "x.png"), "width");
	REFUSED(ts_image_read(&pixels, &width, NULL, &channels, "x.png"), "height");
	REFUSED(ts_image_read(&pixels, &width, &height, NULL, "x.png"), "channels");
	REFUSED(ts_image_read(&pixels, &width, &height, &channels, NULL), "path");
	REFUSED(ts_image_read_bytes(NULL, &width, &height, &channels, bytes, 4, "it"), "pixels");
	REFUSED(ts_image_read_bytes(&pixels, NULL, &height, &channels, bytes, 4, "it"), "width");
	REFUSED(ts_image_read_bytes(&pixels, &width, NULL, &channels, bytes, 4, "it"), "height");
	REFUSED(ts_image_read_bytes(&pixels, &width, &height, NULL, bytes, 4, "it"), "channels");
	REFUSED(ts_image_read_bytes(&pixels, &width, &height, &channels, NULL, 4, "it"), "file");
	REFUSED(ts_image_read_bytes(&pixels, &width, &height, &channels, bytes, 4, NULL), "what");
}

static void null_encoders_are_refused(void **state)
{
	(void)state;
	static const uint8_t codes[4] = {0};
	static const float light[4] = {0};
	void *file;
	size_t n;
	REFUSED(ts_image_encode_png(NULL, &n, codes, 1, 1, 4, NULL, "it"), "file");
	REFUSED(ts_image_encode_png(&file, NULL, codes, 1, 1, 4, NULL, "it"), "file_bytes");
	REFUSED(ts_image_encode_png(&file, &n, NULL, 1, 1, 4, NULL, "it"), "pixels");
	REFUSED(ts_image_encode_png(&file, &n, codes, 1, 1, 4, NULL, NULL), "what");
	REFUSED(ts_image_encode_exr(NULL, &n, light, 1, 1, 4, NULL, "it"), "file");
	REFUSED(ts_image_encode_exr(&file, NULL, light, 1, 1, 4, NULL, "it"), "file_bytes");
	REFUSED(ts_image_encode_exr(&file, &n, NULL, 1, 1, 4, NULL, "it"), "pixels");
	REFUSED(ts_image_encode_exr(&file, &n, light, 1, 1, 4, NULL, NULL), "what");
	assert_null(file);
}

static void null_metrics_give_nothing(void **state)
{
	(void)state;
	uint8_t grey[3] = {9, 9, 9}, marks[1] = {7};
	float light[3] = {1, 1, 1};
	assert_int_equal(ts_metrics_compare(NULL, grey, NULL, 1, 1).pixels, 0);
	assert_int_equal(ts_metrics_compare(grey, NULL, NULL, 1, 1).pixels, 0);
	assert_int_equal(ts_metrics_compare(grey, grey, NULL, 1, 1).pixels, 1);
	assert_int_equal(ts_metrics_estimate(NULL, NULL, 1, 1).pixels, 0);
	assert_int_equal(ts_metrics_estimate(&(ts_metrics_part){.reference = grey, .image = grey}, NULL, 1, 1).pixels, 0);
	assert_true(ts_metrics_flicker(NULL, grey, grey, grey, NULL, 1, 1) == 0);
	assert_true(ts_metrics_flicker(grey, NULL, grey, grey, NULL, 1, 1) == 0);
	assert_true(ts_metrics_flicker(grey, grey, NULL, grey, NULL, 1, 1) == 0);
	assert_true(ts_metrics_flicker(grey, grey, grey, NULL, NULL, 1, 1) == 0);
	assert_int_equal(ts_metrics_light(NULL, light, NULL, 1, 1).pixels, 0);
	assert_int_equal(ts_metrics_light(light, NULL, NULL, 1, 1).pixels, 0);
	assert_int_equal(ts_metrics_crumbs(marks, NULL, light, 1, 1), 0);
	assert_int_equal(ts_metrics_crumbs(marks, light, NULL, 1, 1), 0);
	assert_int_equal(marks[0], 7);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(releasing_null_does_nothing), cmocka_unit_test(null_parameters_are_refused),
		cmocka_unit_test(null_scenes_are_refused),     cmocka_unit_test(null_traces_are_refused),
		cmocka_unit_test(null_verdicts_are_refused),   cmocka_unit_test(null_answers_are_refused),
		cmocka_unit_test(null_truths_are_refused),     cmocka_unit_test(null_renderings_are_refused),
		cmocka_unit_test(null_vectors_are_refused),    cmocka_unit_test(null_images_are_refused),
		cmocka_unit_test(null_encoders_are_refused),   cmocka_unit_test(null_metrics_give_nothing),
		cmocka_unit_test(null_pages_are_refused),      cmocka_unit_test(null_explanations_are_refused),
	};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}
