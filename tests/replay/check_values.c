/* Checks of values that kernels loop over or address by; and whatever is planted anywhere, a stage is refused or ends
 * without harm, which the sanitizers judge. */
#include "tests/replay/faults.h"
#include "tests/whole.h"

/* Rows of a value that a kernel loops over or addresses by. */
static void values_that_kernels_address_by_are_bounded(void **state)
{
	(void)state;
	const ts_stage *eye = ts_stage_find("eye"), *points = ts_stage_find("points");
	const ts_stage *lookup = ts_stage_find("lookup"), *count = ts_stage_find("points.count"),
				   *image = ts_stage_find("image");
	const u64 n = TS_NONE;
	refuses(0, eye, TS_B_eye_view, 0, "width", 0, 33);
	refuses(0, eye, TS_B_eye_view, 0, "height", 0, n);
	refuses(0, lookup, TS_B_cube_size_face, 1, "n", 0, 17);
	refuses(0, lookup, TS_B_cube_size_face, 1, "offset", 0, 0);
	refuses(0, lookup, TS_B_cube_size_face, 0, "offset", 0, 1);
	refuses(1, ts_stage_find("mirror"), TS_B_cube_size_face, 1, "n", 0, 4096);
	refuses(0, count, TS_B_align_frame, 0, "s", 0, 0xbf800000);
	refuses(0, count, TS_B_align_frame, 3, "q", 5, 1u << 23);
	refuses(0, count, TS_B_align_frame, 3, "q", 0, 0x80000000);
	refuses(0, image, TS_B_mirror_pixel_offset, 0, "", 0, 1);
	refuses(0, image, TS_B_mirror_pixel_offset, 32 * 24, "", 0, n - 1);
	refuses(0, image, TS_B_mirror_pixel_offset, 32 * 24, "", 0, 0);
	refuses(0, points, TS_B_points_offset, 0, "", 0, 1);
}

/* The same of off-screen views and lights; a view of no light at all is right where nobody asks for it. */
static void wrong_views_are_refused(void **state)
{
	(void)state;
	const ts_stage *scatter = ts_stage_find("scatter"), *resolve = ts_stage_find("shadow_test");
	const ts_stage *views = ts_stage_find("lamp.view"), *image = ts_stage_find("image.shadow");
	const ts_buffer_id view = TS_B_offscreen_view, shape = TS_B_lamp_shape;
	refuses(TRACES_SOFT, scatter, view, 1, "width", 0, 17);
	refuses(TRACES_SOFT, scatter, view, 1, "width", 0, 0);
	refuses(TRACES_SOFT, scatter, view, 4, "height", 0, 15);
	refuses(TRACES_SOFT, scatter, view, 4, "height", 0, TS_NONE);
	refuses(TRACES_SOFT, scatter, view, 0, "offset", 0, 1);
	refuses(TRACES_SOFT, resolve, view, 3, "offset", 0, UINT64_MAX);
	refuses(TRACES_SOFT, resolve, view, 2, "orthographic", 0, 2);
	refuses(TRACES_SOFT, resolve, view, 2, "light", 0, TS_NONE);
	accepts(TRACES_SOFT, scatter, view, 2, "light", 0, TS_NONE);
	refuses(TRACES_OMNI, resolve, view, 11, "light", 0, TS_NONE);
	refuses(TRACES_OMNI, resolve, view, 7, "width", 0, 15);
	refuses(TRACES_OMNI, scatter, TS_B_cube_size_face, 1, "n", 0, 17);
	refuses(TRACES_IVIR, ts_stage_find("split.views"), view, 0, "width", 0, 17);
	refuses(TRACES_DEPTH, ts_stage_find("depth_map"), view, 4, "offset", 0, 16 * 16 * 5);
	refuses(TRACES_SOFT, views, shape, 0, "samples", 0, 0);
	refuses(TRACES_SOFT, views, shape, 0, "samples", 0, 6);
	refuses(TRACES_SOFT, views, shape, 0, "samples", 0, TS_NONE);
	refuses(TRACES_SOFT, views, shape, 0, "first", 0, 1);
	refuses(TRACES_PCSS, views, shape, 0, "first", 0, 1);
	refuses(TRACES_PCSS, ts_stage_find("pcss"), view, 0, "light", 0, TS_NONE);
	refuses(TRACES_PCSS, ts_stage_find("pcss"), view, 0, "width", 0, 17);
	refuses(TRACES_SOFT, image, shape, 0, "samples", 0, 0);
	refuses(TRACES_SOFT, image, TS_B_lamp_light, 0, "kind", 0, 3);
	refuses(TRACES_SOFT, image, TS_B_shadow_test_lit, 7, "", 0, 6);
}

/* Boxes that are inside out, views of no light, sums of boxes, and a grid that is not of whole blocks. */
static void wrong_segments_are_refused(void **state)
{
	(void)state;
	const ts_stage *gather = ts_stage_find("corner"), *hull = ts_stage_find("hull"),
				   *range = ts_stage_find("segment.extent");
	const ts_buffer_id box = TS_B_segment_box;
	refuses(TRACES_HULLS, gather, box, 0, "low", 0, 63);
	refuses(TRACES_HULLS, hull, box, 1, "low", 1, 64);
	refuses(TRACES_HULLS, hull, box, 0, "high", 0, 64);
	refuses(TRACES_HULLS, hull, TS_B_segment_box_offset, 0, "", 0, 1);
	refuses(TRACES_HULLS, hull, TS_B_segment_box_offset, 4096, "", 0, 0);
	refuses(TRACES_HULLS, hull, TS_B_segment_box_offset, 2049, "", 0, 0);
	refuses(TRACES_HULLS, range, TS_B_segment_label, 5, "", 0, 1024);
	refuses(TRACES_HULLS, ts_stage_find("rsm.patch"), TS_B_offscreen_view, 0, "light", 0, TS_NONE);
	refuses(TRACES_HULLS, ts_stage_find("rsm"), TS_B_offscreen_view, 0, "width", 0, 5);
	traces[TRACES_HULLS]->params.depth_grid_px = 63;
	ts_load *load;
	assert_int_equal(ts_replay_run(&load, range, traces[TRACES_HULLS], NULL, 1), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "would be right"));
	traces[TRACES_HULLS]->params.depth_grid_px = 64;
}

/* Fewer samples than views, which would leave views unmade; and no light at all. */
static void fewer_samples_than_views_are_refused(void **state)
{
	(void)state;
	ts_buffer shapes, none;
	ts_lamp *lamps = traces_read(&shapes, traces[TRACES_DEPTH], TS_B_lamp_shape);
	lamps[0].samples--;
	assert_int_equal(replay_with(TRACES_DEPTH, ts_stage_find("lamp.view"), TS_B_lamp_shape, &shapes), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "lights with 4 views; 5 would be right"));
	ts_buffer views;
	void *view = traces_read(&views, traces[TRACES_EPR], TS_B_offscreen_view);
	views.n = --views.shape[0];
	assert_int_equal(replay_with(TRACES_EPR, ts_stage_find("split.shadow"), TS_B_offscreen_view, &views), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "11 views; six a cube would be right"));
	free(view);
	void *light = traces_read(&none, traces[TRACES_OMNI], TS_B_lamp_light);
	none.n = none.shape[0] = 0;
	assert_int_equal(replay_with(TRACES_OMNI, ts_stage_find("lamp.cube"), TS_B_lamp_light, &none), TS_ERROR);
	assert_null(strchr(ts_error_message(), '\n'));
	free(light);
	free(lamps);
}

/* Sums may not fall; and points are written only where stage count would put them. */
static void falling_sums_are_refused(void **state)
{
	(void)state;
	static const struct {
		const char *stage;
		ts_buffer_id id;
	} rows[] = {
		{"image", TS_B_mirror_pixel_offset},
		{"splat", TS_B_points_offset},
		{"points", TS_B_points_offset},
		{"shade", TS_B_lookup_second_offset},
		{"shade.second", TS_B_lookup_third_offset},
	};
	for (u32 row = 0; row < sizeof rows / sizeof *rows; row++) {
		ts_buffer buffer;
		u32 *sums = traces_read(&buffer, traces[0], rows[row].id);
		u64 i = buffer.n / 2;
		u32 last = sums[buffer.n - 1];
		while (sums[i] == 0 || sums[i] + 1 >= last) i++;
		u64 fallen = sums[i] - 1 < sums[i - 1] ? i : i + 1;
		refuses(0, ts_stage_find(rows[row].stage), rows[row].id, fallen, "", 0, 0);
		free(sums);
	}
	ts_buffer buffer;
	u32 *sums = traces_read(&buffer, traces[0], TS_B_points_offset);
	u64 i = 1;
	while (sums[i] == sums[i - 1]) i++;
	refuses(0, ts_stage_find("points"), TS_B_points_offset, i, "", 0, sums[i] - 1);
	assert_non_null(strstr(ts_error_message(), "stage points.count makes"));
	free(sums);
}

/* Points that are made again: where the counts say, and no others. */
static void points_are_made_again_where_counts_say(void **state)
{
	(void)state;
	static const char *const stages[] = {"splat.direct", "lookup.second", "shade"};
	ts_buffer buffer, found;
	u32 *sums = traces_read(&buffer, traces[TRACES_BUFFERLESS], TS_B_points_offset), n_points = sums[buffer.n - 1];
	u64 i = 1;
	while (sums[i] == sums[i - 1]) i++;
	for (u32 s = 0; s < 3; s++) {
		refuses(TRACES_BUFFERLESS, ts_stage_find(stages[s]), TS_B_points_offset, i, "", 0, sums[i] - 1);
		assert_non_null(strstr(ts_error_message(), "stage points.count makes"));
	}
	void *points = traces_read(&found, traces[TRACES_BUFFERLESS], TS_B_lookup_point);
	for (u32 s = 1; s < 3; s++) {
		refuses(TRACES_BUFFERLESS, ts_stage_find(stages[s]), TS_B_lookup_point, 0, "", 0, n_points);
	}
	free(points);
	free(sums);
}

/* A piece that covers all of the lattice is walked; many of them are too much. */
static void too_many_lattice_squares_are_refused(void **state)
{
	(void)state;
	ts_buffer buffer;
	ts_align *frames = traces_read(&buffer, traces[0], TS_B_align_frame);
	const i32 all[6] = {-8388607, -8388607, 8388607, -8388607, 8388607, 8388607};
	for (u32 i = 0; i < 5; i++) {
		frames[i].s = 1;
		memcpy(frames[i].q, all, sizeof all);
	}
	assert_int_equal(replay_with(0, ts_stage_find("points.count"), TS_B_align_frame, &buffer), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "lattice squares"));
	free(frames);
}

typedef enum { SOME_FLOATS, WHOLE_ELEMENTS, ANYTHING, N_DAMAGES } damage_kind;

/* An extreme value; a float is finite, s of align.frame not negative, and near and focal of offscreen.view more than 0,
 * so that it is not refused. */
static u64 extreme(ts_buffer_id id, const ts_field *field)
{
	static const u64 extremes[] = {0,          1,          2,          255,        0x7fffffff, 0x80000000,
	                               0xfffffffe, UINT64_MAX, 0x7f7fffff, 0xff7fffff, 0x3f800000, 0x5e800000,
	                               0xde800000, 0x80000001, 0x00800000, 4096};
	u64 value = extremes[random_below(16)];
	if (field->kind != 'f') return value;
	if ((value & 0x7f800000) == 0x7f800000) value = (value & 0x80000000) | 0x7f7fffff;
	bool view = id == TS_B_offscreen_view && (strcmp(field->name, "near") == 0 || strcmp(field->name, "focal") == 0);
	if (view) return (value & 0x7fffffff) > 0x00800000 ? value & 0x7fffffff : 0x00800000;
	return strcmp(field->name, "s") == 0 ? value & 0x7fffffff : value;
}

static void damage(const ts_buffer *buffer, ts_buffer_id id, damage_kind kind, u32 times)
{
	const ts_fields fields = ts_fields_of(id);
	u32 n = fields.n;
	for (u32 i = 0; i < times && buffer->n != 0; i++) {
		u64 element = random_below((u32)buffer->n);
		u32 chosen = random_below(n);
		for (u32 f = 0; f < n; f++) {
			bool wanted = kind == WHOLE_ELEMENTS || f == chosen;
			if (!wanted || (kind != ANYTHING && fields.field[f].kind != 'f')) continue;
			u32 one = kind == WHOLE_ELEMENTS ? fields.field[f].count : random_below(fields.field[f].count);
			for (u32 k = 0; k < fields.field[f].count; k++) {
				bool large = kind == WHOLE_ELEMENTS && i % 2 == 0;
				u64 value = large ? 0x7f7fffff : extreme(id, &fields.field[f]);
				if (one == fields.field[f].count || one == k) put(buffer, id, element, fields.field[f].name, k, value);
			}
		}
	}
}

/* An absurd view asks for 4096 pieces of every triangle. */
static bool is_slow(const ts_stage *stage, ts_buffer_id id)
{
	return id == TS_B_offscreen_view && strncmp(stage->name, "split.", 6) == 0;
}

static void damage_and_run(u32 m, const ts_stage *stage, ts_buffer_id id, damage_kind kind)
{
	ts_buffer buffer;
	void *data = traces_read(&buffer, traces[m], id);
	u32 times = kind == ANYTHING || is_slow(stage, id) ? 2 : kind == SOME_FLOATS ? 400 : 64;
	damage(&buffer, id, kind, times);
	bool ran = replay_with(m, stage, id, &buffer) == TS_OK;
	/* A mask that changes changes the counts of points, a place that changes the leaves of octrees. */
	bool counts = strcmp(stage->name, "points") == 0 || strstr(stage->name, "octree") != NULL;
	if (m == TRACES_BUFFERLESS) counts = ts_stage_reads(stage, TS_B_points_offset);
	if (kind != ANYTHING && !counts && !ran) fail_msg("%s", ts_error_message());
	free(data);
}

/* Each buffer of each stage is damaged in one way, in turn; whole: in each. */
static void damage_is_refused_or_does_no_harm(void **state)
{
	(void)state;
	u32 n_ways = whole_or(N_DAMAGES, 1), way = 0;
	for (u32 m = 0; m < N_TRACES; m++) {
		FOR_STAGES(m, stage)
		{
			if (traces_known(m, stage)) continue;
			for (u32 id = 0; id < TS_N_BUFFERS; id++) {
				if (!ts_stage_reads(stage, (ts_buffer_id)id) || traces[m]->item[id].path == NULL) continue;
				for (u32 k = 0; k < n_ways; k++)
					damage_and_run(m, stage, (ts_buffer_id)id, (damage_kind)(way++ % N_DAMAGES));
			}
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(values_that_kernels_address_by_are_bounded),
		cmocka_unit_test(wrong_views_are_refused),
		cmocka_unit_test(wrong_segments_are_refused),
		cmocka_unit_test(fewer_samples_than_views_are_refused),
		cmocka_unit_test(falling_sums_are_refused),
		cmocka_unit_test(points_are_made_again_where_counts_say),
		cmocka_unit_test(too_many_lattice_squares_are_refused),
		cmocka_unit_test(damage_is_refused_or_does_no_harm),
	};
	return cmocka_run_group_tests(tests, traces_begin, traces_end);
}
