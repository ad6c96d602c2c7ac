/* The floating-point environment of a host: no function that takes a context or a page changes it, and none does
 * anything where it rounds otherwise. Traps of a host do not end it. */
#define _GNU_SOURCE
#include <fenv.h>
#include <math.h>
#include "tests/api/run.h"

enum { RAISED = FE_INVALID | FE_DIVBYZERO };

static void host_raises(void)
{
	assert_int_equal(feclearexcept(FE_ALL_EXCEPT), 0);
	assert_int_equal(feraiseexcept(RAISED), 0);
}

static void kept(ts_status status, const char *call)
{
	if (status == TS_ERROR) fail_msg("%s: %s", call, ts_error_message());
	if (fetestexcept(FE_ALL_EXCEPT) != RAISED) fail_msg("%s: other exceptions than the host's", call);
}

/* The call was refused in another mode of rounding, which stays. */
static void left(ts_status status, const char *call)
{
	const int mode = fegetround();
	assert_int_equal(fesetround(FE_TONEAREST), 0);
	if (mode != FE_UPWARD) fail_msg("%s: another mode of rounding than the host's", call);
	refused(status, "rounding (not to nearest even)");
}

/* Calls twice; what the first call makes is released. */
#define KEEPS(call, release) \
	do { \
		host_raises(); \
		kept(call, #call); \
		release; \
		assert_int_equal(fesetround(FE_UPWARD), 0); \
		left(call, #call); \
	} while (0)

static void runs_keep_the_rounding_of_the_host(void **state)
{
	(void)state;
	char folder[FOLDER], path[PATH];
	ts_context *opened;
	ts_scene *made;
	ts_trace *trace;
	static const ts_vertex corners[3] = {{.position = {0, 0, 0}}, {.position = {1, 0, 0}}, {.position = {0, 0, 1}}};
	static const char room[] = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
							   "property float z\nproperty float radius\nproperty float nx\nproperty float ny\n"
							   "property float nz\nend_header\n0 0 0 1 0 1 0\n";
	static const ts_triangle one = {.vertex = {0, 1, 2}, .material = UINT32_MAX};
	const ts_scene_arrays arrays = {
		.bytes = sizeof arrays, .vertices = corners, .n_vertices = 3, .triangles = &one, .n_triangles = 1};
	make_folder(folder);
	KEEPS(ts_context_open(&opened, NULL), ts_context_close(opened));
	KEEPS(ts_scene_open(context, &made, SMALL, params, NULL), ts_scene_free(made));
	KEEPS(ts_scene_open_bytes(context, &made, room, sizeof room - 1, "room", params, NULL), ts_scene_free(made));
	KEEPS(ts_scene_make(context, &made, &arrays, params, NULL), ts_scene_free(made));
	KEEPS(ts_trace_run(context, &trace, scene, params, "reflections", "mvr", NULL), ts_trace_close(trace));
	snprintf(path, sizeof path, "%s/saved", folder);
	KEEPS(ts_trace_save(context, reference, path, NULL), (void)0);
	KEEPS(ts_trace_open(context, &trace, path), ts_trace_close(trace));
	KEEPS(ts_trace_open_list(context, &trace, path, "eye.view=01-eye.view.npy", 0, reference), ts_trace_close(trace));
	snprintf(path, sizeof path, "%s/saved/01-eye.view.npy", folder);
	KEEPS(ts_trace_open_npy(context, &trace, path), ts_trace_close(trace));
	snprintf(path, sizeof path, "%s/written", folder);
	KEEPS(ts_trace_write(context, path, scene, params, "reflections", "mvr", NULL), (void)0);
	remove_folder(folder);
}

static void no_digest(void *user, const char *buffer, const char *hex)
{
	(void)user;
	(void)buffer;
	(void)hex;
}

static void answers_keep_the_rounding_of_the_host(void **state)
{
	(void)state;
	ts_trace *candidate = candidate_of(reference, 0), *trace;
	ts_verdicts *verdicts;
	ts_tree *answer;
	ts_rendering *rendering;
	ts_truth_image *image;
	static uint8_t marks[64 * 36 * 3];
	ts_golden_judged judged = {.bytes = sizeof judged};
	const ts_explain_options options = {.bytes = sizeof options, .stage = "eye"};
	KEEPS(ts_run_digests(context, scene, params, "reflections", "mvr", no_digest, NULL), (void)0);
	KEEPS(ts_compare(context, &verdicts, reference, candidate, NULL), ts_verdicts_free(verdicts));
	KEEPS(ts_compare_marks(context, marks, sizeof marks, "image.srgb", reference, candidate, NULL), (void)0);
	KEEPS(ts_replay(context, &verdicts, "eye", reference, NULL, NULL), ts_verdicts_free(verdicts));
	KEEPS(ts_trace_replay(context, &trace, "eye", reference, NULL), ts_trace_close(trace));
	KEEPS(ts_explain_item(context, &answer, &options, reference, NULL, NULL), ts_tree_free(answer));
	KEEPS(ts_probe_pixel(context, &answer, reference, 20, 10, NULL), ts_tree_free(answer));
	KEEPS(ts_probe_triangle(context, &answer, reference, 5), ts_tree_free(answer));
	KEEPS(ts_truth_render(context, &image, scene, params, "reflections", "A"), ts_truth_image_free(image));
	KEEPS(ts_rendering_make(context, &rendering, scene, params, "reflections", NULL), ts_rendering_free(rendering));
	KEEPS(ts_vector_words(context, NULL, NULL, ts_vector_at(0)->name), (void)0);
	KEEPS(ts_golden_check(context, &judged, "reference/goldens/small-epr"), (void)0);
	ts_trace_close(candidate);
}

static void pages_keep_the_rounding_of_the_host(void **state)
{
	(void)state;
	char folder[FOLDER], path[PATH];
	ts_html *page;
	ts_verdicts *verdicts;
	ts_trace *candidate = candidate_of(reference, 0);
	static const uint8_t rgb[3] = {1, 2, 3};
	make_folder(folder);
	snprintf(path, sizeof path, "%s/page.html", folder);
	done(ts_html_open(context, &page, NULL));
	done(ts_compare(context, &verdicts, reference, candidate, NULL));
	KEEPS(ts_html_add_picture(page, "one", "a.png", rgb, 1, 1), (void)0);
	done(ts_html_add_picture(page, "other", "b.png", rgb, 1, 1));
	KEEPS(ts_html_add_pair(page, "{\"verdict\": \"same\"}"), (void)0);
	KEEPS(ts_html_add_trace(page, reference), (void)0);
	done(ts_html_add_trace(page, candidate));
	KEEPS(ts_html_add_verdicts(page, verdicts, reference, candidate, NULL, NULL), (void)0);
	KEEPS(ts_html_write(page, path), (void)0);
	ts_html_close(page);
	ts_verdicts_free(verdicts);
	ts_trace_close(candidate);
	remove_folder(folder);
}

static void without_context(void)
{
	char text[TS_FLOAT_TEXT];
	float value;
	const uint32_t signalling = 0x7fa00000;
	const float dark[3] = {0, 0, 0}, endless[3] = {INFINITY, 1, 1};
	const uint8_t rgb[3] = {1, 2, 3};
	void *file;
	size_t bytes;
	memcpy(&value, &signalling, sizeof value);
	ts_float_text(text, value);
	assert_int_equal(ts_float_passes(&(ts_compare_options){.bytes = sizeof(ts_compare_options), .rel = 1}, 0, value),
	                 0);
	refused(ts_params_set(params, "light.irradiance", "1e999"), "light.irradiance");
	assert_true(ts_metrics_light(dark, endless, NULL, 1, 1).pixels == 1);
	assert_true(isinf(ts_metrics_compare(rgb, rgb, NULL, 1, 1).psnr));
	ts_metrics_crumbs(NULL, dark, endless, 1, 1);
	done(ts_image_encode_exr(&file, &bytes, endless, 1, 1, 3, NULL, "endless"));
	free(file);
	FILE *out = fopen("/dev/null", "w");
	assert_non_null(out);
	done(ts_scene_print(scene, out, 0));
	fclose(out);
}

/* Of a host that traps, also on the threads of its own loops, all is as before. */
static void traps_do_not_end_the_host(void **state)
{
	(void)state;
	enum { THREADS = 4, TRAPS = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW };
	ts_context *own;
	ts_trace *trace;
	ts_truth_image *image;
	int n = 0;
	feclearexcept(FE_ALL_EXCEPT);
	assert_int_not_equal(feenableexcept(TRAPS), -1);
#pragma omp parallel num_threads(THREADS)
	if (fegetexcept() != TRAPS) feenableexcept(TRAPS);
	done(ts_context_open(&own, &(ts_context_options){.bytes = sizeof(ts_context_options), .threads = THREADS}));
	done(ts_trace_run(own, &trace, scene, params, "reflections", "epr", NULL));
	ts_trace_close(trace);
	done(ts_truth_render(own, &image, scene, params, "reflections", "A"));
	ts_truth_image_free(image);
	ts_context_close(own);
	without_context();
	assert_int_equal(fetestexcept(FE_ALL_EXCEPT), 0);
#pragma omp parallel num_threads(THREADS) reduction(+ : n)
	n += fegetexcept() == TRAPS;
	assert_int_equal(n, THREADS);
#pragma omp parallel num_threads(THREADS)
	fedisableexcept(TRAPS);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(runs_keep_the_rounding_of_the_host),
		cmocka_unit_test(answers_keep_the_rounding_of_the_host),
		cmocka_unit_test(pages_keep_the_rounding_of_the_host),
		cmocka_unit_test(traps_do_not_end_the_host),
	};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}
