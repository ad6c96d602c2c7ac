/* Truths: each that a small scene has is a picture that a method's resembles, whatever the threads. */
#include <math.h>
#include "tests/api/run.h"

static bool has_word(const char *text, const char *word)
{
	size_t n = strlen(word);
	for (const char *at = text; (at = strstr(at, word)) != NULL; at += n) {
		if ((at == text || at[-1] == ' ') && (at[n] == ' ' || at[n] == 0)) return true;
	}
	return false;
}

/* Both pictures of the same scene: farther apart than 10 dB they would show something else. */
static void resembles(const ts_truth_image *truth, const ts_trace *method)
{
	const ts_buffer_view *image = ts_trace_buffer((ts_trace *)(uintptr_t)method, "image.srgb");
	assert_int_equal(truth->width, 64);
	assert_int_equal(truth->height, 36);
	for (size_t i = 0; i < 64 * 36 * 3; i++) assert_true(isfinite(truth->radiance[i]) && truth->radiance[i] >= 0);
	ts_metrics m = ts_metrics_compare(truth->srgb, image->data, NULL, 64, 36);
	assert_true(m.pixels == 64 * 36 && m.psnr > 10);
}

static void each_truth_resembles_a_method(void **state)
{
	(void)state;
	ts_context *alone = open_context(1);
	const ts_truth_info *truth;
	size_t n = 0;
	for (size_t i = 0; (truth = ts_truth_at(i)) != NULL; i++) {
		ts_truth_image *image, *again;
		assert_true(truth->name[0] != 0 && truth->doc[0] != 0);
		if (!has_word(truth->effects, "reflections")) {
			refused(ts_truth_render(context, &image, scene, params, "reflections", truth->name), truth->name);
			continue;
		}
		done(ts_truth_render(context, &image, scene, params, "reflections", truth->name));
		done(ts_truth_render(alone, &again, scene, params, "reflections", truth->name));
		resembles(image, reference);
		assert_memory_equal(image->radiance, again->radiance, 64 * 36 * 3 * sizeof(float));
		ts_truth_image_free(again);
		ts_truth_image_free(image);
		n++;
	}
	assert_true(n >= 2);
	ts_context_close(alone);
}

static int asked;
static int cancelled(void *user)
{
	(void)user;
	return ++asked > 0;
}

static void unknown_truths_are_refused(void **state)
{
	(void)state;
	ts_context *ended;
	ts_truth_image *image;
	refused(ts_truth_render(context, &image, scene, params, "mirrors", "A"), "mirrors");
	refused(ts_truth_render(context, &image, scene, params, "reflections", "Z"), "Z");
	refused(ts_truth_render(context, &image, scene, params, "reflections", "A,B"), "it has A");
	refused(ts_truth_render(context, &image, scene, params, "reflections", "none"), "it has A");
	assert_null(image);
	done(ts_context_open(&ended, &(ts_context_options){.bytes = sizeof(ts_context_options), .cancelled = cancelled}));
	refused(ts_truth_render(ended, &image, scene, params, "reflections", "A"), "cancelled");
	refused(ts_truth_render(ended, &image, scene, params, "soft-shadows", "area"), "cancelled");
	ts_context_close(ended);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(each_truth_resembles_a_method),
	                                   cmocka_unit_test(unknown_truths_are_refused)};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}
