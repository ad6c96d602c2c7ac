/* Pictures that a sweep keeps: they come back where nothing that they depend on has changed, and their bytes are
 * counted. */
#include "cli/series.h"
#include "tests/model/test.h"

enum { WIDTH = 8, HEIGHT = 4 };

static ts_render render;
static ts_job job;
static ts_series series;

/* A render by these methods. */
static void begin(const char *methods)
{
	memset(&render, 0, sizeof render);
	memset(&job, 0, sizeof job);
	memset(&series, 0, sizeof series);
	ts_params_default(&job.params);
	TS_PARAM_SET(&job.params, width, WIDTH);
	TS_PARAM_SET(&job.params, height, HEIGHT);
	job.scenes = "atrium";
	job.effect = render.effect = "reflections";
	render.job = series.job = &job;
	series.render = &render;
	assert_int_equal(ts_methods_find(render.methods, &render.n_methods, "reflections", methods), TS_OK);
}

/* A picture, and one of a stage of n x n pixels, unless n is 0. */
static void paint(u32 method, u32 n)
{
	render.pictures[method].srgb = calloc(3, WIDTH * HEIGHT);
	if (n == 0) return;
	render.stages[method].n = 1;
	render.stages[method].picture[0] = (ts_stage_picture){.rgb = calloc(3, n * n), .width = n, .height = n};
}

/* Four bytes a pixel of a stage's picture: three of its colour, one of its mask. */
static void kept_pictures_count_their_bytes(void **state)
{
	(void)state;
	u64 bytes[3];
	for (u32 i = 0; i < 3; i++) {
		begin("epr");
		paint(0, 10 * i);
		assert_int_equal(ts_keep_take(&series), TS_OK);
		bytes[i] = series.keep.bytes;
		ts_keep_free(&series.keep);
	}
	assert_true(bytes[0] >= WIDTH * HEIGHT * 20);
	assert_int_equal(bytes[1] - bytes[0], 4 * 100);
	assert_int_equal(bytes[2] - bytes[0], 4 * 400);
}

/* A truth in part holds its pixels twice: by some samples, and by all. */
static void a_truth_in_part_counts_twice(void **state)
{
	(void)state;
	u64 bytes[2];
	for (u32 part = 0; part < 2; part++) {
		begin("epr");
		paint(0, 0);
		if (part == 1) render.pictures[0].chosen = calloc(1, WIDTH * HEIGHT);
		assert_int_equal(ts_keep_take(&series), TS_OK);
		bytes[part] = series.keep.bytes;
		ts_keep_free(&series.keep);
	}
	assert_int_equal(bytes[1] - bytes[0], WIDTH * HEIGHT * 20);
}

static void pictures_come_back_where_nothing_changed(void **state)
{
	(void)state;
	begin("epr,mvr");
	job.sweep = (ts_sweep){{{"density.scale", "1,2", 2}, {"seed", "1,2", 2}}, 2};
	paint(0, 0);
	paint(1, 3);
	const u8 *epr = render.pictures[0].srgb, *mvr = render.pictures[1].srgb;
	assert_int_equal(ts_keep_take(&series), TS_OK);
	assert_null(render.pictures[0].srgb);
	assert_null(render.pictures[1].srgb);
	assert_int_equal(render.stages[1].n, 0);
	series.combination = 2; /* another density.scale, which MVR does not read */
	ts_keep_give(&series);
	assert_null(render.pictures[0].srgb);
	assert_ptr_equal(render.pictures[1].srgb, mvr);
	assert_int_equal(render.stages[1].n, 1);
	assert_int_equal(ts_keep_take(&series), TS_OK);
	series.combination = 0;
	ts_keep_give(&series);
	assert_ptr_equal(render.pictures[0].srgb, epr);
	assert_ptr_equal(render.pictures[1].srgb, mvr);
	assert_int_equal(ts_keep_take(&series), TS_OK);
	ts_keep_free(&series.keep);
}

static void a_truth_comes_back_unless_it_reads_what_changed(void **state)
{
	(void)state;
	u32 truth = 0;
	begin("epr");
	job.effect = render.effect = "soft-shadows";
	assert_int_equal(ts_methods_find(render.methods, &render.n_methods, "soft-shadows", "ivir"), TS_OK);
	assert_int_equal(ts_truths_find(&job.truths, "soft-shadows", "area"), TS_OK);
	while (job.truths >> truth != 1) truth++;
	job.sweep = (ts_sweep){{{"truth.area_samples", "1,2", 2}, {"density.scale", "1,2", 2}}, 2};
	u8 *area = render.truths[truth].srgb = calloc(3, WIDTH * HEIGHT);
	for (series.combination = 0; series.combination < 4; series.combination++) {
		ts_keep_give(&series);
		bool first = series.combination < 2; /* value of truth.area_samples; the truth does not read the other */
		assert_true((render.truths[truth].srgb == area) == first);
		if (!first && render.truths[truth].srgb == NULL) render.truths[truth].srgb = calloc(3, WIDTH * HEIGHT);
		assert_int_equal(ts_keep_take(&series), TS_OK);
	}
	ts_keep_free(&series.keep);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(kept_pictures_count_their_bytes),
	                                   cmocka_unit_test(a_truth_in_part_counts_twice),
	                                   cmocka_unit_test(pictures_come_back_where_nothing_changed),
	                                   cmocka_unit_test(a_truth_comes_back_unless_it_reads_what_changed)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
