/* A render reports planted figures: each row has the names of its pictures and their figures. */
#include <math.h>
#include "cli/render.h"
#include "tests/model/test.h"

enum { WIDTH = 16, HEIGHT = 16 };

static ts_render render;
static ts_job job;
static ts_scene scene;
static ts_report report;
static u8 srgb[WIDTH * HEIGHT * 3];

/* A render by these methods, each of which left a picture. */
static void begin(const char *effect, const char *methods)
{
	memset(&render, 0, sizeof render);
	memset(&job, 0, sizeof job);
	memset(&scene, 0, sizeof scene);
	ts_params_default(&job.params);
	TS_PARAM_SET(&job.params, width, WIDTH);
	TS_PARAM_SET(&job.params, height, HEIGHT);
	render.job = &job;
	render.scene = &scene;
	render.effect = effect;
	assert_int_equal(ts_methods_find(render.methods, &render.n_methods, effect, methods), TS_OK);
	for (u32 i = 0; i < render.n_methods; i++) {
		render.measures[i].method = render.methods[i];
		render.pictures[i].srgb = srgb;
		snprintf(render.pictures[i].name, sizeof render.pictures[i].name, "%s", render.methods[i]->name);
	}
}

/* The truth of that name, made. */
static ts_picture *add_truth(const char *name)
{
	u32 t = 0;
	while (strcmp(ts_truths()[t]->name, name) != 0) t++;
	render.truths[t].srgb = srgb;
	ts_picture_truth_name(render.truths[t].name, sizeof render.truths[t].name, ts_truths()[t]);
	return &render.truths[t];
}

static ts_pair *add_pair(const ts_picture *reference, const ts_picture *image)
{
	ts_pair *pair = &render.pairs[render.n_pairs++];
	*pair = (ts_pair){.reference = reference, .image = image, .share = "method"};
	return pair;
}

static json_t *reported(void)
{
	ts_report_begin(&report, true);
	ts_render_report_body(&render, &report);
	assert_int_equal(ts_report_check(&report), TS_OK);
	return report.root;
}

/* The text of a row of a table, or of a figure. */
static const char *text_at(const json_t *root, const char *table, size_t row, const char *key)
{
	return json_string_value(json_object_get(json_array_get(json_object_get(root, table), row), key));
}

static double number_at(const json_t *root, const char *table, size_t row, const char *key)
{
	return json_number_value(json_object_get(json_array_get(json_object_get(root, table), row), key));
}

static void errors_of_light_are_reported_by_part(void **state)
{
	(void)state;
	begin("indirect", "hulls");
	ts_pair *pair = add_pair(add_truth("lights"), &render.pictures[0]);
	pair->parted = true;
	pair->light = (ts_light_metrics){.squares = 8, .pixels = 200, .median = 0.25, .beyond = 0.5};
	pair->near = (ts_light_metrics){.squares = 2, .pixels = 50, .relative = 0.75};
	pair->elsewhere = (ts_light_metrics){.squares = 6, .pixels = 150, .relative = 0.125};
	add_pair(add_truth("lights"), &render.pictures[0]); /* of a scene without triangles of light */
	const json_t *root = reported();
	assert_int_equal(json_array_size(json_object_get(root, "light_errors")), 1);
	assert_string_equal(text_at(root, "light_errors", 0, "image"), "hulls");
	assert_string_equal(text_at(root, "light_errors", 0, "reference"), "truth-lights");
	static const struct {
		const char *key;
		double value;
	} right[] = {{"relative_rmse_near", 0.75}, {"relative_rmse_elsewhere", 0.125},
	             {"near_percent", 25},         {"near_error_percent", 25},
	             {"median_error", 0.25},       {"beyond_percent", 50}};
	for (u32 i = 0; i < sizeof right / sizeof *right; i++) {
		assert_true(number_at(root, "light_errors", 0, right[i].key) == right[i].value);
	}
	assert_string_equal(text_at(root, "metrics", 1, "image"), "hulls");
	assert_string_equal(text_at(root, "metrics", 1, "reference"), "truth-lights");
	assert_string_equal(text_at(root, "metrics", 1, "share"), "method");
	ts_report_discard(&report);
}

static void missed_look_ups_are_reported(void **state)
{
	(void)state;
	begin("reflections", "epr");
	ts_picture *truth = add_truth("B");
	add_pair(truth, &render.pictures[0]);
	truth->n_hits = 4000;
	truth->n_missed = 3;
	const json_t *root = reported();
	assert_int_equal(json_integer_value(json_object_get(root, "hit_lookups")), 4000);
	assert_int_equal(json_integer_value(json_object_get(root, "missed_lookups")), 3);
	ts_report_discard(&report);
	truth->n_hits = 0;
	assert_null(json_object_get(reported(), "hit_lookups"));
	ts_report_discard(&report);
}

/* The value of a row of the table of shading; -1: there is none. */
static double shading(const json_t *root, const char *figure)
{
	const json_t *rows = json_object_get(root, "shading");
	for (size_t i = 0; i < json_array_size(rows); i++) {
		if (strcmp(text_at(root, "shading", i, "figure"), figure) == 0) return number_at(root, "shading", i, "value");
	}
	return -1;
}

static void count(ts_measure *measure, const char *name, i64 value)
{
	measure->counters[measure->n_counters++] = (ts_counter){.name = name, .value = value};
}

static void shading_is_reported_by_its_ratios(void **state)
{
	(void)state;
	begin("reflections", "epr,mvr");
	render.pictures[0].n_reflective = 27;
	render.mirrors = &render.pictures[0];
	scene.info.n_reflectors = 3;
	count(&render.measures[0], "shading operations", 200);
	count(&render.measures[1], "shading operations", 500);
	render.measures[0].n_in_sight = 2;
	render.measures[0].mean_diameter = 12.5;
	const json_t *root = reported();
	assert_true(shading(root, "reflective pixels in sight") == 27);
	assert_true(shading(root, "mirrors in sight") == 2);
	assert_true(shading(root, "texels a side of their cubes, mean") == 12.5);
	assert_true(shading(root, "shading operations, MVR / EPR") == 2.5);
	/* 6 * 512^2 * 3 / (25 * 27) */
	assert_true(fabs(shading(root, "6 * 512^2 * mirrors / (25 * reflective pixels * eye.samples)") - 6990.5) < 0.1);
	ts_report_discard(&report);
	begin("reflections", "mvr");
	count(&render.measures[0], "shading operations", 500);
	assert_true(shading(reported(), "shading operations, MVR / EPR") == -1);
	ts_report_discard(&report);
}

/* A row of each picture that is written, in the order of methods, stages and truths. */
static void each_written_picture_has_a_row(void **state)
{
	(void)state;
	begin("reflections", "epr,mvr");
	render.stages[0].n = 2;
	snprintf(render.stages[0].picture[0].name, 16, "points");
	snprintf(render.stages[0].picture[0].caption, 128, "colours");
	snprintf(render.stages[0].picture[1].name, 16, "cubes");
	add_pair(add_truth("B"), &render.pictures[0]);
	static const char *const names[] = {"epr.png .exr", "epr-points.png",   "epr-cubes.png",
	                                    "mvr.png .exr", "truth-b.png .exr", "difference-*.png .exr"};
	const json_t *root = reported();
	assert_int_equal(json_array_size(json_object_get(root, "pictures")), 6);
	for (size_t i = 0; i < 6; i++) assert_string_equal(text_at(root, "pictures", i, "name"), names[i]);
	assert_string_equal(text_at(root, "pictures", 0, "shows"), render.methods[0]->doc);
	assert_string_equal(text_at(root, "pictures", 1, "shows"), "colours");
	assert_string_equal(text_at(root, "pictures", 3, "shows"), render.methods[1]->doc);
	assert_non_null(strstr(text_at(root, "pictures", 5, "shows"), "times 8"));
	ts_report_discard(&report);
	job.output.no_images = true;
	assert_null(json_object_get(reported(), "pictures"));
	ts_report_discard(&report);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(errors_of_light_are_reported_by_part),
		cmocka_unit_test(missed_look_ups_are_reported),
		cmocka_unit_test(shading_is_reported_by_its_ratios),
		cmocka_unit_test(each_written_picture_has_a_row),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
