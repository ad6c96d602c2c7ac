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
	assert_int_equal(ts_replay_run(&load, ts_stage_find("align"), traces[0], halved, 2), TS_OK);
	frames = load->run.frame.buffer[TS_B_align_frame];
	const planted own[] = {{TS_B_split_density, &scale}, {TS_B_align_frame, &frames}};
	ts_trace *candidate = traces_plant(0, own, 2, "canonical", "");
	assert_int_equal(ts_compare_traces(&c, traces[0], candidate, &exactly), TS_DIFFERENT);
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

/* Faults in three stages are three stages' faults. */
static void test_several(void **state)
{
	(void)state;
	static ts_comparison c;
	ts_buffer pixel, frame, picture;
	ts_pixel *pixels = traces_read(&pixel, traces[0], TS_B_mirror_pixel_record);
	ts_align *frames = traces_read(&frame, traces[0], TS_B_align_frame);
	u8 *bytes = traces_read(&picture, traces[0], TS_B_image_srgb);
	pixels[4].normal[1] += 1;
	pixels[6].position[0] += 1;
	frames[3].s += 1;
	bytes[77] ^= 1;
	const planted own[] = {{TS_B_image_srgb, &picture}, {TS_B_align_frame, &frame}, {TS_B_mirror_pixel_record, &pixel}};
	ts_trace *candidate = traces_plant(0, own, 3, "canonical", "");
	assert_int_equal(ts_compare_forced(&c, traces[0], candidate, &exactly, 2), TS_DIFFERENT);
	assert_true(c.n_judged == 3 && c.n_unlike == 3 && c.n_unable == 0 && c.first == TS_B_mirror_pixel_record);
	assert_int_equal(c.verdict[TS_B_mirror_pixel_record].n_different, 2);
	assert_int_equal(c.verdict[TS_B_align_frame].first.element, 3);
	assert_int_equal(c.verdict[TS_B_image_srgb].first.element, 77);
	traces_drop(candidate);
	free(bytes);
	free(frames);
	free(pixels);
}

/* A wrong count is its stage's fault; the stages that are given the sums cannot be run, and the others are judged. */
static void test_refused(void **state)
{
	(void)state;
	static ts_comparison c;
	ts_buffer offset, key, picture;
	u32 *sums = traces_read(&offset, traces[0], TS_B_points_offset);
	u64 *keys = traces_read(&key, traces[0], TS_B_points_key);
	u8 *bytes = traces_read(&picture, traces[0], TS_B_image_srgb);
	for (u64 i = offset.n / 2; i < offset.n; i++) sums[i]++;
	const planted own[] = {{TS_B_points_offset, &offset}, {TS_B_points_key, &key}, {TS_B_image_srgb, &picture}};
	ts_trace *candidate = traces_plant(0, own, 3, "canonical", "");
	assert_int_equal(ts_compare_forced(&c, traces[0], candidate, &exactly, 2), TS_DIFFERENT);
	assert_true(c.n_judged == 2 && c.n_unlike == 1 && c.n_unable == 1 && c.first == TS_B_points_offset);
	assert_int_equal(c.verdict[TS_B_points_offset].n_different, 1);
	assert_int_equal(c.verdict[TS_B_points_offset].first.element, offset.n / 2);
	assert_int_equal(c.verdict[TS_B_points_key].judgement, TS_UNABLE);
	assert_non_null(strstr(c.verdict[TS_B_points_key].why, "points.offset.npy: element "));
	assert_int_equal(c.verdict[TS_B_image_srgb].judgement, TS_SAME);
	const ts_relaxations ignoring = {.ignore = "points.offset"};
	assert_int_equal(ts_compare_forced(&c, traces[0], candidate, &ignoring, 2), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "stage points: "));
	traces_drop(candidate);
	free(bytes);
	free(keys);
	free(sums);
}

/* An input that cannot be read is no refusal, whatever else differs. */
static void test_unreadable(void **state)
{
	(void)state;
	static ts_comparison c;
	const ts_relaxations ignoring = {.ignore = "align.frame"};
	ts_buffer frame, offset, picture;
	void *frames = traces_read(&frame, traces[0], TS_B_align_frame);
	void *sums = traces_read(&offset, traces[0], TS_B_points_offset);
	u8 *bytes = traces_read(&picture, traces[0], TS_B_image_srgb);
	bytes[77] ^= 1;
	const planted own[] = {{TS_B_align_frame, &frame}, {TS_B_points_offset, &offset}, {TS_B_image_srgb, &picture}};
	ts_trace *candidate = traces_plant(0, own, 3, "canonical", "");
	assert_int_equal(ts_compare_forced(&c, traces[0], candidate, &ignoring, 2), TS_DIFFERENT);
	assert_int_equal(truncate(candidate->item[TS_B_align_frame].path, 200), 0);
	assert_int_equal(ts_compare_forced(&c, traces[0], candidate, &ignoring, 2), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "is shorter than it was"));
	traces_drop(candidate);
	free(bytes);
	free(sums);
	free(frames);
}

/* Indices of points in order of arrival say nothing of the reference's points. */
static void test_mixed(void **state)
{
	(void)state;
	static ts_comparison c;
	ts_buffer point, picture;
	void *points = traces_read(&point, traces[0], TS_B_lookup_point);
	void *bytes = traces_read(&picture, traces[0], TS_B_image_srgb);
	const planted own[] = {{TS_B_lookup_point, &point}, {TS_B_image_srgb, &picture}};
	ts_trace *candidate = traces_plant(0, own, 2, "arrival", "");
	assert_int_equal(ts_compare_forced(&c, traces[0], candidate, &exactly, 2), TS_OK);
	assert_true(c.n_judged == 1 && c.n_unable == 1 && c.verdict[TS_B_lookup_point].judgement == TS_UNABLE);
	assert_non_null(strstr(c.verdict[TS_B_lookup_point].why, "the candidate has no splat.depth_index"));
	traces_drop(candidate);
	free(bytes);
	free(points);
}

/* Places are named by the records that the stage was given, not by the reference's. */
static void test_names(void **state)
{
	(void)state;
	ts_buffer pixel, light;
	ts_comparison *c = ts_comparison_make(1);
	ts_pixel *pixels = traces_read(&pixel, traces[0], TS_B_mirror_pixel_record);
	f32 *lights = traces_read(&light, traces[0], TS_B_shade_radiance);
	char right[TS_WHERE_TEXT];
	assert_non_null(c);
	assert_true(pixel.n > 1);
	ts_pixel moved = pixels[0];
	pixels[0] = pixels[pixel.n - 1];
	pixels[pixel.n - 1] = moved;
	lights[0] += 7;
	const planted own[] = {{TS_B_mirror_pixel_record, &pixel}, {TS_B_shade_radiance, &light}};
	ts_trace *candidate = traces_plant(0, own, 2, "canonical", "");
	assert_int_equal(ts_compare_forced(c, traces[0], candidate, &exactly, 2), TS_DIFFERENT);
	const ts_named *first = &c->verdict[TS_B_shade_radiance].list.items[0];
	assert_true(c->verdict[TS_B_shade_radiance].judgement == TS_UNLIKE && first->difference.element == 0);
	snprintf(right, sizeof right, "pixel (%u, %u) [0]", (unsigned)(pixels[0].index % 64),
	         (unsigned)(pixels[0].index / 64));
	assert_string_equal(first->where, right);
	traces_drop(candidate);
	ts_comparison_free(c);
	free(lights);
	free(pixels);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_same),    cmocka_unit_test(test_own_inputs), cmocka_unit_test(test_planted),
		cmocka_unit_test(test_several), cmocka_unit_test(test_refused),    cmocka_unit_test(test_unreadable),
		cmocka_unit_test(test_mixed),   cmocka_unit_test(test_names),
	};
	return cmocka_run_group_tests(tests, traces_begin, traces_end);
}
