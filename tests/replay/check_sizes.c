/* Checks of sizes, shapes, sums, keys and floats of what a stage reads: the first value that is wrong and the last that
 * is right, in a run in memory; and the words of the refusals. */
#include <inttypes.h>
#include "tests/replay/loaded.h"

/* One reflector is one batch: what the run leaves is all that it made. */
static int begin(void **state)
{
	(void)state;
	ts_params params = small_params(64, 48);
	params.reflectors_count = 1;
	params.reflectors_px = 24;
	params.lookup_bounces = 2;
	loaded_run(ts_pipeline_find("reflections", "epr"), &params);
	return 0;
}

static u64 n_of(ts_buffer_id id) { return ts_frame_n(&run.frame, id); }

/* Checks the value and requires the whole message. */
__attribute__((format(printf, 6, 7))) static void says(const char *stage, ts_buffer_id id, u64 element,
                                                       const char *field, u64 value, const char *format, ...)
{
	char words[256];
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(words, sizeof words, format, arguments);
	va_end(arguments);
	assert_int_equal(check_with(stage, id, element, field, value), TS_ERROR);
	assert_string_equal(ts_error_message(), words);
}

/* Checks a stage with a row less of a buffer. */
static ts_status check_cut(const char *stage, ts_buffer_id id)
{
	ts_buffer *buffer = &run.frame.buffer[id], kept = *buffer;
	ts_npy *npy = &trace.item[id].npy, stored = *npy;
	buffer->n -= buffer->n / buffer->shape[0];
	buffer->shape[0]--;
	npy->n = buffer->n;
	npy->shape[0]--;
	ts_status status = check_for(stage);
	*buffer = kept;
	*npy = stored;
	return status;
}

/* Both shapes are told, of one dimension and of several. */
static void both_shapes_are_told(void **state)
{
	(void)state;
	char words[200];
	u64 pieces = n_of(TS_B_align_frame), pixels = n_of(TS_B_mirror_pixel_record);
	assert_int_equal(check_cut("points", TS_B_align_frame), TS_ERROR);
	snprintf(words, sizeof words,
	         "align.frame: shape %" PRIu64 "; align.frame of shape pieces is %" PRIu64
	         " with the other buffers and parameters of the trace",
	         pieces - 1, pieces);
	assert_string_equal(ts_error_message(), words);
	assert_int_equal(check_cut("shade", TS_B_lookup_point), TS_ERROR);
	snprintf(words, sizeof words,
	         "lookup.point: shape %" PRIu64 " x 25; lookup.point of shape mirror_pixels lookup_samples is %" PRIu64
	         " x 25 with the other buffers and parameters of the trace",
	         pixels - 1, pixels);
	assert_string_equal(ts_error_message(), words);
}

/* How many points stage points makes, the sums say, whatever the points of the reference are. */
static void sums_say_how_many_points_there_are(void **state)
{
	(void)state;
	ts_load load;
	u64 n = n_of(TS_B_points_offset);
	const u32 *sums = ts_frame_data(&run.frame, TS_B_points_offset);
	load_for(&load, ts_stage_find("points"));
	assert_int_equal(ts_check(&load, ts_stage_find("points")), TS_OK);
	assert_int_equal(load.sizes.n[TS_DIM_points], sums[n - 1]);
	assert_int_equal(load.sizes.n[TS_DIM_pieces], n - 1);
	load_for(&load, ts_stage_find("splat"));
	assert_int_equal(ts_check(&load, ts_stage_find("splat")), TS_OK);
	assert_int_equal(load.sizes.n[TS_DIM_points], n_of(TS_B_points_key));
}

/* Sums begin at 0, do not fall, and end at what they count. */
static void sums_begin_at_zero_and_never_fall(void **state)
{
	(void)state;
	u64 last = n_of(TS_B_mirror_pixel_offset) - 1, i = 1;
	const u32 *sums = ts_frame_data(&run.frame, TS_B_mirror_pixel_offset);
	while (sums[i] == 0) i++;
	u32 n = sums[last], most = sums[i];
	const ts_buffer_id id = TS_B_mirror_pixel_offset;
	says("image", id, 0, "", 1, "mirror_pixel.offset: element 0: 1 (00000001); 0, where sums begin, would be right");
	says("image", id, i + 1, "", 0,
	     "mirror_pixel.offset: element %" PRIu64 ": 0 (00000000); at least %u, the sum before it, would be right",
	     i + 1, (unsigned)most);
	says("image", id, last, "", n + 1,
	     "mirror_pixel.offset: element %" PRIu64 ": %u (%08x); %u (mirror_pixels), where sums end, would be right",
	     last, (unsigned)n + 1, (unsigned)n + 1, (unsigned)n);
}

/* Sums that a stage can make again must be those. */
static void sums_made_again_must_be_the_same(void **state)
{
	(void)state;
	const u32 *sums = ts_frame_data(&run.frame, TS_B_points_offset);
	u64 i = 1;
	while (sums[i] == sums[i - 1]) i++;
	says("points", TS_B_points_offset, i, "", sums[i] - 1,
	     "points.offset: element %" PRIu64 ": %u (%08x); %u, which stage points.count makes of the same align.frame, "
	     "would be right",
	     i, (unsigned)sums[i] - 1, (unsigned)sums[i] - 1, (unsigned)sums[i]);
	accepts("points", TS_B_points_offset, i, "", sums[i]);
}

/* The low half of a key is an index, and all ones name nothing. */
static void keys_name_an_index_or_nothing(void **state)
{
	(void)state;
	u64 n = n_of(TS_B_points_key), high = 0x3f800000ull << 32;
	const ts_buffer_id id = TS_B_splat_depth_index;
	accepts("lookup", id, 0, "", UINT64_MAX);
	accepts("lookup", id, 0, "", high | (n - 1));
	says("lookup", id, 0, "", high | n,
	     "splat.depth_index: element 0: 1 | %" PRIu64 " (3f800000_%08x); less than %" PRIu64
	     " (points) in the low half, or all ones, would be right",
	     n, (unsigned)n, n);
	refuses("lookup", id, n_of(id) - 1, "", high | TS_NONE);
}

/* Indices with and without a value for none. */
static void indices_name_what_is_there(void **state)
{
	(void)state;
	u64 points = n_of(TS_B_points_key), pieces = n_of(TS_B_split_piece);
	accepts("shade", TS_B_lookup_point, 0, "", TS_NONE);
	says("shade", TS_B_lookup_point, 0, "", points,
	     "lookup.point: element 0: %" PRIu64 " (%08x); less than %" PRIu64
	     " (points), or 4294967295 for none, would be right",
	     points, (unsigned)points, points);
	accepts("splat", TS_B_points_record, 0, "piece", pieces - 1);
	says("splat", TS_B_points_record, 0, "piece", pieces,
	     "points.record: element 0, field piece: %" PRIu64 " (%08x); less than %" PRIu64 " (pieces) would be right",
	     pieces, (unsigned)pieces, pieces);
	refuses("splat", TS_B_points_record, points - 1, "piece", TS_NONE);
}

/* Every finite number is right, and no other. */
static void every_finite_number_is_right(void **state)
{
	(void)state;
	static const u32 finite[] = {0, 0x80000000, 1, 0x807fffff, 0x7f7fffff, 0xff7fffff},
					 others[] = {0x7f800000, 0xff800000, 0x7f800001, 0x7fc00000, 0xffffffff};
	u64 last = n_of(TS_B_points_record) - 1;
	for (u32 i = 0; i < sizeof finite / sizeof *finite; i++) {
		accepts("splat", TS_B_points_record, last, "centre", finite[i]);
	}
	for (u32 i = 0; i < sizeof others / sizeof *others; i++) {
		refuses("splat", TS_B_points_record, last, "centre", others[i]);
	}
	says("splat", TS_B_points_record, last, "length", 0x7f800000,
	     "points.record: element %" PRIu64 ", field length: inf = inf (7f800000); a finite number would be right",
	     last);
}

/* What sizes are computed from is checked before, whoever reads it. */
static void sizes_of_cubes_are_checked_first(void **state)
{
	(void)state;
	says("lookup", TS_B_cube_size_face, 0, "n", 25,
	     "cube_size.face: element 0, field n: 25 (00000019); at most 24, by the parameters, would be right");
	refuses("splat", TS_B_cube_size_face, 0, "n", 1u << 20);
	refuses("lookup", TS_B_cube_size_face, 0, "offset", 1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(what_is_loaded_is_right),
		cmocka_unit_test(both_shapes_are_told),
		cmocka_unit_test(sums_say_how_many_points_there_are),
		cmocka_unit_test(sums_begin_at_zero_and_never_fall),
		cmocka_unit_test(sums_made_again_must_be_the_same),
		cmocka_unit_test(keys_name_an_index_or_nothing),
		cmocka_unit_test(sizes_of_cubes_are_checked_first),
		cmocka_unit_test(indices_name_what_is_there),
		cmocka_unit_test(every_finite_number_is_right),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
