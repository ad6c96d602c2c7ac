/* Teacher forcing: a stage answers for what it makes of its own inputs, not for theirs. */
#include "../../src/replay/forced.h"
#include "traces.h"

static const ts_relaxations exactly = {.ulp = 0};

static void test_same(void **state)
{
	(void)state;
	static ts_comparison c;
	for (u32 m = 0; m < N_TRACES; m++) {
		assert_int_equal(ts_compare_forced(&c, traces[m], traces[m], &exactly, 2), TS_OK);
		assert_true(c.n_judged > 6 && c.n_unlike == 0 && c.n_missing == 0 && c.first == TS_N_BUFFERS);
	}
}

/* Half the densities: split made something else; align is right, given that, though not what the reference has. */
static void test_own_inputs(void **state)
{
	(void)state;
	ts_buffer scale, frames;
	ts_load *load;
	static ts_comparison c;
	f32 *scales = traces_read(&scale, traces[0], TS_B_split_density);
	for (u64 i = 0; i < scale.n; i++) scales[i] *= 0.5f;
	ts_trace *halved = traces_plant(0, &(planted){TS_B_split_density, &scale}, 1, "canonical", "");
	assert_int_equal(ts_replay(&load, ts_stage_find("align"), traces[0], halved, 2), TS_OK);
	frames = load->run.frame.buffer[TS_B_align_frame];
	const planted own[] = {{TS_B_split_density, &scale}, {TS_B_align_frame, &frames}};
	ts_trace *candidate = traces_plant(0, own, 2, "canonical", "");
	assert_int_equal(ts_compare(&c, traces[0], candidate, &exactly), TS_DIFFERENT);
	assert_int_equal(c.n_unlike, 2);
	assert_int_equal(ts_compare_forced(&c, traces[0], candidate, &exactly, 2), TS_DIFFERENT);
	assert_int_equal(c.n_unlike, 1);
	assert_int_equal(c.first, TS_B_split_density);
	assert_int_equal(c.verdict[TS_B_align_frame].judgement, TS_SAME);
	ts_load_end(load);
	traces_drop(candidate);
	traces_drop(halved);
	free(scales);
}

/* A wrong pixel of the last stage is the last stage's. */
static void test_planted(void **state)
{
	(void)state;
	ts_buffer picture;
	static ts_comparison c;
	u8 *bytes = traces_read(&picture, traces[1], TS_B_image_srgb);
	bytes[77] ^= 1;
	ts_trace *candidate = traces_plant(1, &(planted){TS_B_image_srgb, &picture}, 1, "canonical", "");
	assert_int_equal(ts_compare_forced(&c, traces[1], candidate, &exactly, 2), TS_DIFFERENT);
	assert_true(c.first == TS_B_image_srgb && c.verdict[c.first].first.element == 77 && c.n_judged == 1);
	const ts_relaxations ignoring = {.ignore = "image.srgb"};
	assert_int_equal(ts_compare_forced(&c, traces[1], candidate, &ignoring, 2), TS_ERROR);
	traces_drop(candidate);
	free(bytes);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_same),
		cmocka_unit_test(test_own_inputs),
		cmocka_unit_test(test_planted),
	};
	return cmocka_run_group_tests(tests, traces_begin, traces_end);
}
