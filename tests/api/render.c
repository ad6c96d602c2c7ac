/* Renderings: pictures are those of a method's own trace and of the truth alone, figures are by names and follow from
 * the pictures, frames go on from those before, and progress ends where it should. */
#include <math.h>
#include <stdlib.h>
#include "tests/api/run.h"

static ts_rendering *make(ts_context *with, const ts_params *of, const char *effect, const char *methods,
                          const char *truths, const ts_rendering *before)
{
	ts_rendering *rendering;
	const ts_rendering_options options = {
		.bytes = sizeof options, .methods = methods, .truths = truths, .stages = 1, .before = before};
	done(ts_rendering_make(with, &rendering, scene, of, effect, &options));
	return rendering;
}

static const ts_rendering_picture *picture(ts_rendering *rendering, const char *name)
{
	const ts_rendering_picture *p;
	done(ts_rendering_picture_named(context, &p, rendering, name));
	assert_string_equal(p->name, name);
	return p;
}

static double figure(const ts_rendering *rendering, const char *name)
{
	double value;
	done(ts_rendering_figure_named(&value, rendering, name));
	return value;
}

static void pictures_are_those_of_a_method_alone(void **state)
{
	(void)state;
	ts_truth_image *truth;
	ts_rendering *rendering = make(context, params, "reflections", "mvr,epr", "B", NULL);
	done(ts_truth_render(context, &truth, scene, params, "reflections", "B"));
	const ts_rendering_picture *epr = picture(rendering, "epr"), *rays = picture(rendering, "truth-b");
	const ts_buffer_view *image = ts_trace_buffer(reference, "image.radiance");
	assert_true(epr->width == 64 && epr->height == 36 && !rays->estimated);
	assert_memory_equal(epr->radiance, image->data, 64 * 36 * 3 * sizeof(float));
	assert_memory_equal(rays->radiance, truth->radiance, 64 * 36 * 3 * sizeof(float));
	assert_string_equal(ts_rendering_picture_at(rendering, 0)->name, "mvr");
	assert_null(picture(rendering, "epr-points")->radiance);
	ts_metrics m = ts_metrics_compare(rays->srgb, epr->srgb, NULL, 64, 36);
	assert_true(figure(rendering, "epr.rmse.B") == m.rmse && figure(rendering, "epr.psnr.B") == m.psnr);
	assert_true(figure(rendering, "epr.ssim.B") == m.ssim && figure(rendering, "epr.rmse.mvr") > 0);
	assert_true(figure(rendering, "param.lamp.views") == 7 && figure(rendering, "image.width") == 64);
	assert_true(figure(rendering, "epr.bytes.points.record") == 32 * figure(rendering, "epr.count.points"));
	ts_truth_image_free(truth);
	ts_rendering_free(rendering);
}

/* Asked twice, it is made once; the pictures that are listed stay as many. */
static void differences_are_made_when_asked(void **state)
{
	(void)state;
	const ts_rendering_picture *none;
	ts_rendering *rendering = make(context, params, "reflections", "epr,mvr", "B", NULL);
	const ts_rendering_picture *d = picture(rendering, "difference-epr-truth-b"), *a = picture(rendering, "epr"),
							   *b = picture(rendering, "truth-b");
	int factor = 0;
	for (size_t i = 0; i < 64 * 36 * 3 && factor == 0; i++)
		if (abs(a->srgb[i] - b->srgb[i]) == 1) factor = d->srgb[i];
	assert_true(factor > 1);
	for (size_t i = 0; i < 64 * 36 * 3; i++) {
		int apart = abs(a->srgb[i] - b->srgb[i]) * factor;
		assert_int_equal(d->srgb[i], apart < 255 ? apart : 255);
		assert_true(d->radiance[i] == a->radiance[i] - b->radiance[i]);
	}
	assert_ptr_equal(picture(rendering, "difference-epr-truth-b"), d);
	assert_ptr_not_equal(picture(rendering, "difference-truth-b-epr"), d);
	for (size_t i = 0; (a = ts_rendering_picture_at(rendering, i)) != NULL; i++)
		assert_null(strstr(a->name, "difference"));
	refused(ts_rendering_picture_named(context, &none, rendering, "difference-epr-epr"), "no such picture");
	assert_null(none);
	ts_rendering_free(rendering);
}

/* All that is listed can be asked by its name; times of stages are parts of the frame's. */
static void listed_figures_have_their_names(void **state)
{
	(void)state;
	ts_rendering *rendering = make(context, params, "reflections", "epr,mvr", "A", NULL);
	ts_rendering_figure f = {.bytes = sizeof f};
	double stages = 0;
	size_t n = 0, n_timed = 0;
	for (; ts_rendering_figure_at(&f, rendering, n) == TS_OK; n++) {
		double value;
		ts_status status = ts_rendering_figure_named(&value, rendering, f.name);
		assert_int_equal(status, isnan(f.value) ? TS_ERROR : TS_OK);
		assert_memory_equal(&value, &f.value, isnan(value) ? 0 : sizeof value);
		assert_true(f.error == 0 && f.unit != NULL);
		n_timed += f.timed != 0;
		if (strncmp(f.name, "epr.ms.", 7) == 0 && strcmp(f.name, "epr.ms.frame") != 0) stages += f.value;
	}
	assert_true(n > 100 && n_timed > 10 && stages > 0 && stages <= figure(rendering, "epr.ms.frame"));
	ts_rendering_free(rendering);
}

/* Of a truth by a part of the rays. */
static void estimates_have_an_error(void **state)
{
	(void)state;
	ts_rendering_figure f = {.bytes = sizeof f};
	ts_params *part;
	done(ts_params_copy(&part, params));
	done(ts_params_set(part, "truth.rays", "5000"));
	ts_rendering *rendering = make(context, part, "reflections", "epr", "B", NULL);
	assert_int_equal(picture(rendering, "truth-b")->estimated, 1);
	size_t i = 0;
	while (ts_rendering_figure_at(&f, rendering, i) == TS_OK && strcmp(f.name, "epr.rmse.B") != 0) i++;
	assert_true(strcmp(f.name, "epr.rmse.B") == 0 && f.error > 0 && f.value > f.error);
	refused(ts_rendering_figure_named(&f.value, rendering, "epr.relative.B"), "was not measured");
	assert_true(figure(rendering, "epr.median.B") >= 0);
	ts_rendering_free(rendering);
	ts_params_free(part);
}

static void a_frame_goes_on_from_the_frame_before(void **state)
{
	(void)state;
	double value;
	ts_params *second;
	done(ts_params_copy(&second, params));
	done(ts_params_set(second, "frame", "1"));
	ts_rendering *first = make(context, params, "reflections", "epr", "B", NULL);
	refused(ts_rendering_figure_named(&value, first, "epr.flicker.B"), "epr.flicker.B: was not measured");
	ts_rendering *next = make(context, second, "reflections", "epr", "B", first);
	const ts_rendering_picture *e = picture(next, "epr"), *b = picture(next, "truth-b");
	double right = ts_metrics_flicker(picture(first, "truth-b")->srgb, b->srgb, picture(first, "epr")->srgb, e->srgb,
	                                  NULL, 64, 36);
	ts_rendering_free(first); /* the next needs it no more */
	assert_true(figure(next, "epr.flicker.B") == right && figure(next, "epr.change") > 0);
	ts_rendering *other;
	const ts_rendering_options options = {.bytes = sizeof options, .methods = "mvr", .before = next};
	refused(ts_rendering_make(context, &other, scene, second, "reflections", &options), "before");
	assert_null(other);
	ts_rendering_free(next);
	ts_params_free(second);
}

typedef struct {
	size_t calls, ended;
	uint64_t done, total;
} heard;

static void hear(void *user, const char *label, uint64_t n, uint64_t total)
{
	heard *h = user;
	assert_true(label[0] != 0 && n <= total && total > 0);
	h->calls++;
	h->ended += n == total;
	h->done = n;
	h->total = total;
}

static void progress_ends_with_all_done(void **state)
{
	(void)state;
	const ts_method_info *method;
	for (size_t i = 0; (method = ts_method_at(i)) != NULL; i++) {
		heard h = {0};
		ts_context *listening;
		ts_trace *trace;
		const ts_context_options options = {.bytes = sizeof options, .user = &h, .progress = hear};
		done(ts_context_open(&listening, &options));
		if (strcmp(method->effect, "surfels") == 0) {
			ts_context_close(listening);
			continue;
		}
		done(ts_trace_run(listening, &trace, scene, params, method->effect, method->name, NULL));
		if (h.calls == 0 || h.done != h.total)
			fail_msg("%s of %s: %zu calls, last %llu of %llu", method->name, method->effect, h.calls,
			         (unsigned long long)h.done, (unsigned long long)h.total);
		ts_trace_close(trace);
		h = (heard){0};
		ts_rendering_free(make(listening, params, method->effect, method->name, NULL, NULL));
		if (h.calls == 0 || h.done != h.total) fail_msg("%s of %s: renderings", method->name, method->effect);
		ts_context_close(listening);
	}
}

static int cancelled(void *user)
{
	(void)user;
	return 1;
}

static void what_is_not_there_is_refused(void **state)
{
	(void)state;
	double value;
	ts_context *ended;
	ts_rendering *rendering;
	ts_rendering_options options = {.bytes = sizeof options, .methods = "epr"};
	refused(ts_rendering_make(context, &rendering, scene, params, "mirrors", &options), "mirrors");
	options.methods = "eprr";
	refused(ts_rendering_make(context, &rendering, scene, params, "reflections", &options), "eprr");
	options.methods = "epr";
	options.truths = "Z";
	refused(ts_rendering_make(context, &rendering, scene, params, "reflections", &options), "Z");
	options.truths = NULL;
	options.bytes = 3;
	refused(ts_rendering_make(context, &rendering, scene, params, "reflections", &options), "bytes");
	options.bytes = sizeof options;
	assert_null(rendering);
	done(ts_context_open(&ended, &(ts_context_options){.bytes = sizeof(ts_context_options), .cancelled = cancelled}));
	refused(ts_rendering_make(ended, &rendering, scene, params, "reflections", &options), "cancelled");
	ts_context_close(ended);
	rendering = make(context, params, "reflections", "epr", NULL, NULL);
	refused(ts_rendering_figure_named(&value, rendering, "mvr.ms.frame"), "mvr.ms.frame");
	assert_true(isnan(value));
	refused(ts_rendering_figure_named(&value, rendering, "epr.rmse.B"), "was not measured");
	refused(ts_rendering_figure_named(&value, rendering, "epr.rmse.Z"), "Z is no variant, and no truth");
	ts_rendering_free(rendering);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(pictures_are_those_of_a_method_alone),  cmocka_unit_test(differences_are_made_when_asked),
		cmocka_unit_test(listed_figures_have_their_names),       cmocka_unit_test(estimates_have_an_error),
		cmocka_unit_test(a_frame_goes_on_from_the_frame_before), cmocka_unit_test(progress_ends_with_all_done),
		cmocka_unit_test(what_is_not_there_is_refused)};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}
