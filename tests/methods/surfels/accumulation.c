/* Sums of surfels in the formats of frame buffers: the lists of fragments against all surfels tried at every pixel,
 * the sums over them against models of their own, how far apart the formats are, and what the lists are expected to
 * take. */
#include <touchstone/image.h>
#include "kernels/surfels/surfel_blend_order.h"
#include "methods/stages.h"
#include "methods/surfels/surfel.h"
#include "tests/methods/surfels/surfels.h"
#include "trace/emitted/sums.h"

enum { N_FORMATS = 4, N_TERMS = 7, WEIGHT = 6, NORMAL = 3 };
#define UNIT 1073741824.0

static const char *const names[N_FORMATS] = {"fixed", "float32", "half", "8bit"};

static ts_params tiny_params(u32 accumulation)
{
	ts_params params = small_params(96, 64);
	params.reflectors_count = 0;
	params.surfel_blend_accumulation = accumulation;
	return params;
}

/* Sums of every format at once. */
typedef struct {
	double exact[N_TERMS], size[N_TERMS]; /* of the terms, and of their absolute values */
	f32 single[N_TERMS];
	double half[N_TERMS];
	i32 level[N_TERMS];
	u32 n;
} model;

static double half_of(double x)
{
	if (x == 0) return 0;
	int e = ilogb(x) < -14 ? -14 : ilogb(x);
	return ldexp(nearbyint(ldexp(x, 10 - e)), e - 10);
}

static void add_term(model *m, u32 k, f32 weight, f32 value)
{
	volatile f32 term = weight * value, sum = m->single[k] + term;
	bool normal = k >= NORMAL && k < WEIGHT;
	volatile f32 moved = 0.5f * value;
	moved = moved + 0.5f;
	volatile f32 stored = weight * (normal ? moved : value), level = 255 * stored;
	m->exact[k] += (double)term;
	m->size[k] += fabs((double)term);
	m->single[k] = sum;
	m->half[k] = half_of(m->half[k] + half_of((double)term));
	m->level[k] += (i32)nearbyint((double)level);
	m->level[k] = m->level[k] > 255 ? 255 : m->level[k];
}

/* Over all surfels in order; those that are fragments must be next in the list. */
static model model_of(const ts_run *run, const ts_filter *filter, u32 p)
{
	model m = {.n = 0};
	const ts_view *view = ts_frame_data(&run->frame, TS_B_eye_view);
	const ts_disc *discs = ts_frame_data(&run->frame, TS_B_surfel_setup_disc);
	const u64 *keys = ts_frame_data(&run->frame, TS_B_surfel_depth_surfel);
	const u32 *offset = ts_frame_data(&run->frame, TS_B_fragment_list_offset);
	const u32 *list = ts_frame_data(&run->frame, TS_B_fragment_list_surfel);
	i32 x = (i32)(p % view->width), y = (i32)(p / view->width);
	for (u32 i = 0; i < run->scene->n_surfels; i++) {
		if (discs[i].high[0] < discs[i].low[0]) continue;
		ts_surfel_fragment f = ts_k_surfel_fragment(&discs[i], filter, view->near, x, y);
		if (!f.covers || !ts_k_is_visible(filter, keys[p], f.z)) continue;
		assert_true(offset[p] + m.n < offset[p + 1]);
		assert_int_equal(list[offset[p] + m.n], i);
		f32 weight = ts_k_fragment_weight(&f);
		for (u32 k = 0; k < 3; k++) {
			add_term(&m, k, weight, ts_clamp(run->scene->surfels[i].colour[k], 0, 1));
			add_term(&m, k + NORMAL, weight, discs[i].normal[k]);
		}
		add_term(&m, WEIGHT, weight, 1);
		m.n++;
	}
	assert_int_equal(offset[p] + m.n, offset[p + 1]);
	return m;
}

static f32 number_of(const model *m, u32 accumulation, u32 k)
{
	bool normal = k >= NORMAL && k < WEIGHT;
	if (accumulation == TS_ACCUMULATION_FLOAT32) return m->single[k];
	if (accumulation == TS_ACCUMULATION_HALF) return (f32)m->half[k];
	return (f32)(normal ? 2 * m->level[k] - m->level[WEIGHT] : m->level[k]) / 255;
}

static void sums_of_formats_match_their_models(void **state)
{
	(void)state;
	ts_params params = tiny_params(TS_ACCUMULATION_FIXED);
	ts_scene *scene = surfels_balls(&params, 1200);
	for (u32 a = TS_ACCUMULATION_FLOAT32; a <= TS_ACCUMULATION_8BIT; a++) {
		ts_run run;
		double worst = 0;
		u32 n_full = 0, most = 0;
		params = tiny_params(a);
		surfels_run(&run, scene, &params, "deferred", 2);
		ts_filter filter = ts_surfel_filter(&run);
		const i64 *sums = ts_frame_data(&run.frame, TS_B_surfel_blend_sum);
		for (u32 p = 0; p < params.width * params.height; p++) {
			model m = model_of(&run, &filter, p);
			for (u32 k = 0; k < N_TERMS; k++) {
				i64 found = sums[TS_BLEND_SUMS * p + k];
				assert_int_equal(found, (i64)rint((double)number_of(&m, a, k) * UNIT));
				double bound = m.n * 0x1p-24 * m.size[k] + 0x1p-31, off = fabs((double)found / UNIT - m.exact[k]);
				if (a == TS_ACCUMULATION_FLOAT32) assert_true(off <= bound);
				worst = fmax(worst, off);
			}
			assert_int_equal(sums[TS_BLEND_SUMS * p + TS_BLEND_FRAGMENTS], m.n);
			n_full += m.level[WEIGHT] == 255;
			most = m.n > most ? m.n : most;
		}
		print_message("# %s: sums of up to %u terms are at most %.2g off\n", names[a], most, worst);
		assert_true(most >= 10 && n_full > 1000 && worst > 0);
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

/* What one unit in the last place of a format does to the picture, beside sums that have no order. */
static void coarser_formats_are_further_apart(void **state)
{
	(void)state;
	ts_run run[N_FORMATS];
	ts_metrics apart[N_FORMATS];
	ts_params params = tiny_params(TS_ACCUMULATION_FIXED);
	ts_scene *scene = surfels_balls(&params, 3000);
	for (u32 a = 0; a < N_FORMATS; a++) {
		params = tiny_params(a);
		surfels_run(&run[a], scene, &params, "deferred", 2);
		const ts_frame *fixed = &run[0].frame, *other = &run[a].frame;
		apart[a] = ts_metrics_compare(ts_frame_data(fixed, TS_B_image_srgb), ts_frame_data(other, TS_B_image_srgb),
		                              NULL, params.width, params.height);
		print_message("# %s: %.4f grey levels from fixed\n", names[a], apart[a].rmse);
		const u64 *heaviest = ts_frame_data(fixed, TS_B_surfel_blend_heaviest);
		u64 n = ts_frame_n(fixed, TS_B_surfel_blend_heaviest) * sizeof *heaviest;
		assert_memory_equal(heaviest, ts_frame_data(other, TS_B_surfel_blend_heaviest), n);
		assert_int_equal(ts_run_counter(&run[a], "fragments"), ts_run_counter(&run[0], "fragments"));
	}
	assert_true(apart[1].rmse < 0.05 && apart[2].rmse > apart[1].rmse);
	assert_true(apart[2].rmse < 0.5 && apart[3].rmse > 10);
	for (u32 a = 0; a < N_FORMATS; a++) ts_run_end(&run[a]);
	ts_scene_free(scene);
}

static void threads_change_no_sum(void **state)
{
	(void)state;
	static ts_sums one, seven;
	const ts_how alone = {.threads = 1}, many = {.threads = 7};
	ts_params params = tiny_params(TS_ACCUMULATION_HALF);
	ts_scene *scene = surfels_balls(&params, 2000);
	const ts_pipeline *pipeline = ts_pipeline_find("surfels", "ewa");
	assert_int_equal(ts_sums_of(&one, pipeline, scene, &params, &alone), TS_OK);
	assert_int_equal(ts_sums_of(&seven, pipeline, scene, &params, &many), TS_OK);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) assert_string_equal(one.hex[id], seven.hex[id]);
	assert_int_equal(strlen(one.hex[TS_B_fragment_list_surfel]), 64);
	ts_scene_free(scene);
}

static void stages_read_only_what_they_claim(void **state)
{
	(void)state;
	ts_params params = tiny_params(TS_ACCUMULATION_8BIT);
	surfels_assert_claims(&params, "deferred");
}

/* 30 fragments a pixel, and an offset; without lists nothing. */
static void lists_are_expected_by_the_pixel(void **state)
{
	(void)state;
	ts_params params = tiny_params(TS_ACCUMULATION_FIXED);
	ts_scene *scene = surfels_balls(&params, 800);
	const ts_pipeline *pipeline = ts_pipeline_find("surfels", "deferred");
	u64 without = ts_pipeline_estimate(pipeline, scene, &params, true);
	params.surfel_blend_accumulation = TS_ACCUMULATION_HALF;
	u64 with = ts_pipeline_estimate(pipeline, scene, &params, true), n = (u64)params.width * params.height;
	assert_true(with > without + 30 * 4 * n - 80 * n && with < without + 40 * 4 * n);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(sums_of_formats_match_their_models),
		cmocka_unit_test(coarser_formats_are_further_apart),
		cmocka_unit_test(threads_change_no_sum),
		cmocka_unit_test(stages_read_only_what_they_claim),
		cmocka_unit_test(lists_are_expected_by_the_pixel),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
