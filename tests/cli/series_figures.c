/* Figures of a picture in a series: which there are, in what order, and what they are where a picture has none. */
#include <math.h>
#include "cli/series.h"
#include "tests/model/test.h"

static ts_render render;
static ts_job job;
static ts_series_figure_list figures;
static u8 srgb[3 * 16];

/* EPR and truth B, compared. */
static void begin(void)
{
	memset(&render, 0, sizeof render);
	memset(&job, 0, sizeof job);
	ts_params_default(&job.params);
	TS_PARAM_SET(&job.params, width, 4);
	TS_PARAM_SET(&job.params, height, 4);
	TS_PARAM_SET(&job.params, truth_rays, 0);
	render.job = &job;
	render.effect = "reflections";
	assert_int_equal(ts_methods_find(render.methods, &render.n_methods, "reflections", "epr"), TS_OK);
	assert_int_equal(ts_truths_find(&job.truths, "reflections", "B"), TS_OK);
	u32 truth = 0;
	while (job.truths >> truth != 1) truth++;
	render.pictures[0].srgb = render.truths[truth].srgb = srgb;
	render.n_pairs = 1;
	render.pairs[0] = (ts_pair){.reference = &render.truths[truth], .image = &render.pictures[0]};
	render.pairs[0].all = (ts_metrics){.rmse = 3, .rmse_error = 0.5, .ssim = 0.75};
	render.pairs[0].reflective = (ts_metrics){.rmse = 4, .rmse_error = 0.25, .ssim = 0.5};
	render.pairs[0].flicker = 7;
	render.pairs[0].reflective_flicker = 8;
}

/* The figure of that name; NULL: there is none. */
static const ts_series_figure *named(const char *name)
{
	const ts_series_figure *found = NULL;
	for (u32 i = 0; i < figures.n; i++) {
		if (strcmp(figures.figure[i].name, name) == 0) found = &figures.figure[i];
	}
	return found;
}

static void assert_figure(const char *name, double value)
{
	assert_non_null(named(name));
	assert_true(named(name)->value == value);
}

static void a_whole_truth_has_its_figures(void **state)
{
	(void)state;
	begin();
	ts_series_figures(&figures, &render, 0);
	assert_figure("rmse_truth-b", 3);
	assert_figure("ssim_truth-b", 0.75);
	static const char *const absent[] = {"rmse_error_truth-b", "reflective_rmse_truth-b", "flicker_truth-b", "change",
	                                     "reflective_pixels"};
	for (u32 i = 0; i < sizeof absent / sizeof *absent; i++) assert_null(named(absent[i]));
}

/* Errors of estimates are told where a truth may be made in part: by the parameter, or by a value of a sweep. */
static void a_truth_in_part_tells_its_error(void **state)
{
	(void)state;
	begin();
	TS_PARAM_SET(&job.params, truth_rays, 1);
	ts_series_figures(&figures, &render, 0);
	assert_figure("rmse_error_truth-b", 0.5);
	assert_null(named("reflective_rmse_error_truth-b"));
	TS_PARAM_SET(&job.params, truth_rays, 0);
	job.sweep.n = 2;
	strcpy(job.sweep.swept[0].name, "seed");
	strcpy(job.sweep.swept[1].name, "truth.rays");
	ts_series_figures(&figures, &render, 0);
	assert_figure("rmse_error_truth-b", 0.5);
	job.sweep.n = 1;
	ts_series_figures(&figures, &render, 0);
	assert_null(named("rmse_error_truth-b"));
}

static void mirrors_have_figures_of_their_own(void **state)
{
	(void)state;
	begin();
	render.pictures[0].n_reflective = 5;
	render.mirrors = &render.pictures[0];
	TS_PARAM_SET(&job.params, truth_rays, 1);
	job.frames = (ts_frames){0, 1, 1};
	ts_series_figures(&figures, &render, 0);
	assert_string_equal(figures.figure[0].name, "reflective_pixels");
	assert_figure("reflective_pixels", 5);
	assert_figure("reflective_rmse_truth-b", 4);
	assert_figure("reflective_rmse_error_truth-b", 0.25);
	assert_figure("reflective_ssim_truth-b", 0.5);
	assert_figure("flicker_truth-b", 7);
	assert_figure("reflective_flicker_truth-b", 8);
	assert_true(isnan(named("change")->value) && isnan(named("reflective_change")->value));
}

/* A method that counts something has 0 of all else; a truth has none, nor errors against itself. */
static void what_others_count_is_zero(void **state)
{
	(void)state;
	begin();
	render.measures[0].counters[render.measures[0].n_counters++] = (ts_counter){.name = "look-ups", .value = 11};
	ts_series_figures(&figures, &render, 0);
	assert_figure("look-ups", 11);
	assert_figure("shading_operations", 0);
	u32 n = figures.n, truth = TS_MAX_METHODS;
	while (ts_render_shown(&render, truth) == NULL) truth++;
	ts_series_figures(&figures, &render, truth);
	assert_int_equal(figures.n, n);
	assert_true(isnan(named("look-ups")->value) && isnan(named("rmse_truth-b")->value));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_whole_truth_has_its_figures),
		cmocka_unit_test(a_truth_in_part_tells_its_error),
		cmocka_unit_test(mirrors_have_figures_of_their_own),
		cmocka_unit_test(what_others_count_is_zero),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
