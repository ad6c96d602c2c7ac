/* Teacher forcing: a stage answers for what it makes of its own inputs, not for theirs. */
#include "replay/judge.h"
#include "replay/replay.h"
#include "tests/replay/loaded.h"

static const ts_relaxations exactly = {.ulp = 0};
static ts_comparison c;

/* One reflector is one batch: what the run leaves is all that it made. */
static int begin(void **state)
{
	(void)state;
	ts_params params = small_params(64, 48);
	params.reflectors_count = 1;
	params.reflectors_px = 24;
	loaded_run(ts_pipeline_find("reflections", "epr"), &params);
	return 0;
}

static ts_status judge(const ts_relaxations *relaxations)
{
	return ts_compare_forced(&c, &trace, &candidate, relaxations, 2);
}

/* A run compared with itself: each stage is right, given the inputs of that run. */
static void a_run_is_right_by_itself(void **state)
{
	(void)state;
	assert_int_equal(ts_compare_forced(&c, &trace, &trace, &exactly, 2), TS_OK);
	assert_true(c.forced && c.n_judged > 20 && c.n_unlike == 0 && c.n_missing == 0 && c.n_unable == 0);
	assert_true(c.first == TS_N_BUFFERS && c.refusal[0] == 0);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_judgement found = c.verdict[id].judgement;
		bool made = ts_pipeline_maker(trace.pipeline, (ts_buffer_id)id) != NULL && trace.item[id].path != NULL;
		assert_int_equal(found, made ? TS_SAME : TS_NOT_JUDGED);
		assert_true(!made || c.verdict[id].n_ref == trace.item[id].npy.n);
	}
}

/* Half the densities: split made something else; align is right, given that, though not what the reference has. */
static void a_stage_answers_for_its_own_inputs(void **state)
{
	(void)state;
	ts_load *load;
	candidate_begin(false);
	f32 *scales = candidate_copy(TS_B_split_density);
	for (u64 i = 0; i < trace.item[TS_B_split_density].npy.n; i++) scales[i] *= 0.5f;
	assert_int_equal(ts_replay_run(&load, ts_stage_find("align"), &trace, &candidate, 2), TS_OK);
	void *frames = candidate_copy(TS_B_align_frame);
	memcpy(frames, ts_frame_data(&load->run.frame, TS_B_align_frame), load->run.frame.buffer[TS_B_align_frame].bytes);
	ts_load_end(load);
	assert_int_equal(ts_compare_traces(&c, &trace, &candidate, &exactly), TS_DIFFERENT);
	assert_true(c.n_unlike == 2 && !c.forced);
	assert_int_equal(judge(&exactly), TS_DIFFERENT);
	assert_true(c.n_unlike == 1 && c.forced && c.first == TS_B_split_density);
	assert_int_equal(c.verdict[TS_B_align_frame].judgement, TS_SAME);
}

/* A wrong pixel of the last stage is the last stage's; what is ignored is not judged, and all else is missing. */
static void a_wrong_pixel_blames_the_last_stage(void **state)
{
	(void)state;
	candidate_begin(false);
	u8 *bytes = candidate_copy(TS_B_image_srgb);
	bytes[77] ^= 1;
	assert_int_equal(judge(&exactly), TS_DIFFERENT);
	assert_true(c.first == TS_B_image_srgb && c.verdict[c.first].first.element == 77 && c.n_judged == 1);
	assert_string_equal(c.verdict[TS_B_image_srgb].why, "");
	assert_int_equal(c.verdict[TS_B_image_radiance].judgement, TS_MISSING);
	const ts_relaxations ignoring = {.ignore = "image.srgb"};
	assert_int_equal(judge(&ignoring), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "nothing to judge"));
	assert_int_equal(c.verdict[TS_B_image_srgb].judgement, TS_IGNORED);
	candidate_copy(TS_B_image_radiance);
	assert_int_equal(judge(&ignoring), TS_OK);
	assert_true(c.n_judged == 1 && c.verdict[TS_B_image_srgb].judgement == TS_IGNORED);
}

static void another_shape_is_told_with_both(void **state)
{
	(void)state;
	candidate_begin(false);
	candidate_copy(TS_B_image_srgb);
	ts_npy *npy = &candidate.item[TS_B_image_srgb].npy;
	npy->n = --npy->shape[0] * npy->shape[1] * npy->shape[2];
	assert_int_equal(judge(&exactly), TS_DIFFERENT);
	assert_true(c.n_unlike == 1 && c.first == TS_B_image_srgb && c.verdict[c.first].n_cand == npy->n);
	assert_string_equal(c.verdict[c.first].why, "shape 48 x 64 x 3 is right, shape 47 x 64 x 3 was found");
}

static void three_faults_blame_three_stages(void **state)
{
	(void)state;
	candidate_begin(false);
	ts_pixel *pixels = candidate_copy(TS_B_mirror_pixel_record);
	ts_align *frames = candidate_copy(TS_B_align_frame);
	u8 *bytes = candidate_copy(TS_B_image_srgb);
	pixels[4].normal[1] += 1;
	pixels[6].position[0] += 1;
	frames[3].s += 1;
	bytes[77] ^= 1;
	assert_int_equal(judge(&exactly), TS_DIFFERENT);
	assert_true(c.n_judged == 3 && c.n_unlike == 3 && c.n_unable == 0 && c.first == TS_B_mirror_pixel_record);
	assert_int_equal(c.verdict[TS_B_mirror_pixel_record].n_different, 2);
	assert_int_equal(c.verdict[TS_B_align_frame].first.element, 3);
	assert_int_equal(c.verdict[TS_B_image_srgb].first.element, 77);
}

/* A wrong count is its stage's fault; the stages that are given the sums cannot be run, and the others are judged. */
static void a_wrong_count_blames_its_own_stage(void **state)
{
	(void)state;
	candidate_begin(false);
	u64 n = trace.item[TS_B_points_offset].npy.n;
	u32 *sums = candidate_copy(TS_B_points_offset);
	candidate_copy(TS_B_points_key);
	candidate_copy(TS_B_image_srgb);
	for (u64 i = n / 2; i < n; i++) sums[i]++;
	assert_int_equal(judge(&exactly), TS_DIFFERENT);
	assert_true(c.n_judged == 2 && c.n_unlike == 1 && c.n_unable == 1 && c.first == TS_B_points_offset);
	assert_int_equal(c.verdict[TS_B_points_offset].n_different, 1);
	assert_int_equal(c.verdict[TS_B_points_offset].first.element, n / 2);
	assert_int_equal(c.verdict[TS_B_points_key].judgement, TS_UNABLE);
	static const char begins[] = "points.offset: element ";
	assert_memory_equal(c.verdict[TS_B_points_key].why, begins, sizeof begins - 1);
	assert_int_equal(c.verdict[TS_B_image_srgb].judgement, TS_SAME);
	const ts_relaxations ignoring = {.ignore = "points.offset"};
	assert_int_equal(judge(&ignoring), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "stage points: "));
}

/* An input that cannot be read is no refusal, whatever else differs. */
static void an_unreadable_input_is_an_error(void **state)
{
	(void)state;
	const ts_relaxations ignoring = {.ignore = "align.frame"};
	candidate_begin(false);
	candidate_copy(TS_B_align_frame);
	candidate_copy(TS_B_points_offset);
	u8 *bytes = candidate_copy(TS_B_image_srgb);
	bytes[77] ^= 1;
	assert_int_equal(judge(&ignoring), TS_DIFFERENT);
	candidate.item[TS_B_align_frame].memory = NULL; /* in a file, which is not there */
	assert_int_equal(judge(&ignoring), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "align.frame: No such file"));
}

/* Indices of points in order of arrival say nothing of the reference's points. */
static void mixed_orders_of_points_are_not_judged(void **state)
{
	(void)state;
	candidate_begin(true);
	candidate_copy(TS_B_lookup_point);
	candidate_copy(TS_B_image_srgb);
	assert_int_equal(judge(&exactly), TS_OK);
	assert_true(c.n_judged == 1 && c.n_unable == 1 && c.verdict[TS_B_lookup_point].judgement == TS_UNABLE);
	assert_non_null(strstr(c.verdict[TS_B_lookup_point].why, "the candidate has no splat.depth_index"));
}

/* Which buffer is mixed: one that the reference has and the candidate lacks, where it has another of the points. */
static void the_mixed_buffer_is_the_one_lacking(void **state)
{
	(void)state;
	const ts_stage *lookup = ts_stage_find("lookup"), *image = ts_stage_find("image");
	static ts_trace reference;
	reference = trace;
	candidate_begin(false);
	candidate_copy(TS_B_lookup_point);
	assert_int_equal(ts_forced_mixed(lookup, &reference, &candidate), TS_N_BUFFERS);
	candidate.arrival = true;
	assert_int_equal(ts_forced_mixed(lookup, &reference, &candidate), TS_B_splat_depth_index);
	assert_int_equal(ts_forced_mixed(image, &reference, &candidate), TS_N_BUFFERS);
	reference.item[TS_B_splat_depth_index].path = NULL;
	assert_int_equal(ts_forced_mixed(lookup, &reference, &candidate), TS_N_BUFFERS);
	candidate_copy(TS_B_splat_depth_index);
	assert_int_equal(ts_forced_mixed(lookup, &trace, &candidate), TS_N_BUFFERS);
	candidate_begin(true);
	candidate_copy(TS_B_image_srgb);
	assert_int_equal(ts_forced_mixed(lookup, &trace, &candidate), TS_N_BUFFERS);
}

/* Places are named by the records that the stage was given, not by the reference's. */
static void places_are_named_by_the_given_records(void **state)
{
	(void)state;
	ts_comparison *named = ts_comparison_make(1);
	candidate_begin(false);
	ts_pixel *pixels = candidate_copy(TS_B_mirror_pixel_record);
	f32 *lights = candidate_copy(TS_B_shade_radiance);
	u64 last = trace.item[TS_B_mirror_pixel_record].npy.n - 1;
	char right[TS_WHERE_TEXT];
	assert_non_null(named);
	assert_true(last > 0);
	ts_pixel moved = pixels[0];
	pixels[0] = pixels[last];
	pixels[last] = moved;
	lights[0] += 7;
	assert_int_equal(ts_compare_forced(named, &trace, &candidate, &exactly, 2), TS_DIFFERENT);
	const ts_named *first = &named->verdict[TS_B_shade_radiance].list.items[0];
	assert_true(named->verdict[TS_B_shade_radiance].judgement == TS_UNLIKE && first->difference.element == 0);
	snprintf(right, sizeof right, "pixel (%u, %u) [0]", (unsigned)(pixels[0].index % 64),
	         (unsigned)(pixels[0].index / 64));
	assert_string_equal(first->where, right);
	ts_comparison_free(named);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_run_is_right_by_itself),
		cmocka_unit_test(a_stage_answers_for_its_own_inputs),
		cmocka_unit_test(a_wrong_pixel_blames_the_last_stage),
		cmocka_unit_test(another_shape_is_told_with_both),
		cmocka_unit_test(three_faults_blame_three_stages),
		cmocka_unit_test(a_wrong_count_blames_its_own_stage),
		cmocka_unit_test(an_unreadable_input_is_an_error),
		cmocka_unit_test(mixed_orders_of_points_are_not_judged),
		cmocka_unit_test(what_is_loaded_is_right),
		cmocka_unit_test(the_mixed_buffer_is_the_one_lacking),
		cmocka_unit_test(places_are_named_by_the_given_records),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
