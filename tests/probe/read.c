/* Elements of an untrusted trace: what is fetched, and what is refused of values, places and whole traces. */
#include "tests/probe/mvr.h"
#include "tests/replay/spot.h"

/* Any run of elements, up to the last one, is the buffer's. */
static void any_run_of_elements_is_fetched(void **state)
{
	(void)state;
	const ts_vertex *vertices = data(&mvr, TS_B_pose_vertex);
	const u64 n = count(&mvr, TS_B_pose_vertex);
	static ts_vertex some[40];
	for (u32 i = 0; i < 30; i++) {
		u64 most = i % 3 == 0 ? 40 : i % 3, first = i < 3 ? n - most : below((u32)(n - most));
		require(ts_probe_fetch(mvr.probe, TS_B_pose_vertex, first, most, some));
		assert_memory_equal(some, vertices + first, most * sizeof *some);
	}
	require(ts_probe_fetch(mvr.probe, TS_B_pose_vertex, n, 0, some));
}

/* The last element that was asked for is named, where one is not there. */
static void elements_beyond_the_end_are_refused(void **state)
{
	(void)state;
	static ts_vertex some[4];
	const u64 n = count(&mvr, TS_B_pose_vertex);
	static const struct {
		u64 before, n;
	} rows[] = {{0, 1}, {1, 2}, {3, 4}};
	for (u32 row = 0; row < 3; row++) {
		char words[96];
		u64 first = n - rows[row].before;
		snprintf(words, sizeof words, "pose.vertex.npy: element %llu is named and not there; it has %llu",
		         (unsigned long long)n, (unsigned long long)n);
		assert_refused(ts_probe_fetch(mvr.probe, TS_B_pose_vertex, first, rows[row].n, some), words);
	}
	assert_refused(ts_probe_fetch(mvr.probe, TS_B_pose_vertex, UINT64_MAX, 1, some), "is named and not there");
	assert_refused(ts_probe_fetch(mvr.probe, TS_B_points_record, 0, 1, some), "this needs points.record; a trace");
}

/* Fetches elements 1 to 3 of a buffer, of which 2 has other bits in a component of a field. */
static ts_status fetch_with(ts_buffer_id id, const char *name, u32 component, u64 bits)
{
	damaged d;
	u8 found[3 * 80];
	size_t bytes = ts_buffer_table[id].element_bytes;
	const u8 *data = damage(&d, &mvr, id);
	spot place = spot_of(d.data, count(&mvr, id), id, 2, name, component);
	assert_true(3 * bytes <= sizeof found);
	memcpy(place.at, &bits, place.bytes);
	ts_status status = ts_probe_fetch(d.probe, id, 1, 3, found);
	if (status == TS_OK) assert_memory_equal(found, data + bytes, 3 * bytes);
	damage_end(&d);
	return status;
}

/* Every component of a float is finite. */
static void fetched_floats_must_be_finite(void **state)
{
	(void)state;
	static const u32 odd[] = {0x7f800000, 0xff800000, 0x7fc00000, 0xffffffff};
	for (u32 c = 0; c < 3; c++) {
		for (u32 i = 0; i < 4; i++) {
			char words[96];
			snprintf(words, sizeof words, "element 2 field position is %08x, not a finite number", (unsigned)odd[i]);
			assert_refused(fetch_with(TS_B_scene_vertex, "position", c, odd[i]), words);
		}
		require(fetch_with(TS_B_scene_vertex, "position", c, 0x7f7fffff));
		require(fetch_with(TS_B_scene_vertex, "position", c, 0x80000000));
	}
}

/* Every component of an index names something, or nothing where it may. */
static void fetched_indices_must_name_something(void **state)
{
	(void)state;
	const u64 vertices = count(&mvr, TS_B_scene_vertex), slots = count(&mvr, TS_B_scene_slot);
	char words[96];
	for (u32 c = 0; c < 3; c++) {
		require(fetch_with(TS_B_scene_triangle, "vertex", c, vertices - 1));
		snprintf(words, sizeof words, "element 2 field vertex names %u of %u", (unsigned)vertices, (unsigned)vertices);
		assert_refused(fetch_with(TS_B_scene_triangle, "vertex", c, vertices), words);
		assert_refused(fetch_with(TS_B_scene_triangle, "vertex", c, TS_NONE),
		               "element 2 field vertex names 4294967295");
	}
	for (u32 c = 0; c < 5; c++) {
		require(fetch_with(TS_B_scene_material, "slot", c, slots - 1));
		require(fetch_with(TS_B_scene_material, "slot", c, TS_NONE));
		snprintf(words, sizeof words, "element 2 field slot names %u of %u", (unsigned)slots, (unsigned)slots);
		assert_refused(fetch_with(TS_B_scene_material, "slot", c, slots), words);
	}
}

/* The low half of a key is an index; all ones are none, and ones in one half are not. */
static void fetched_keys_must_name_an_index(void **state)
{
	(void)state;
	const u64 n = count(&mvr, TS_B_scene_triangle), high = (u64)0x3f800000 << 32;
	char words[96];
	require(fetch_with(TS_B_eye_depth_triangle, "", 0, TS_EMPTY));
	require(fetch_with(TS_B_eye_depth_triangle, "", 0, high | (n - 1)));
	snprintf(words, sizeof words, "element 2 names %u of %u", (unsigned)n, (unsigned)n);
	assert_refused(fetch_with(TS_B_eye_depth_triangle, "", 0, high | n), words);
	assert_refused(fetch_with(TS_B_eye_depth_triangle, "", 0, high | TS_NONE), "element 2 names 4294967295 of ");
}

static void a_buffer_is_read_once_and_whole(void **state)
{
	(void)state;
	damaged d;
	damage(&d, &mvr, TS_B_scene_triangle);
	const void *whole = ts_probe_whole(d.probe, TS_B_scene_triangle);
	assert_non_null(whole);
	assert_memory_equal(whole, data(&mvr, TS_B_scene_triangle), count(&mvr, TS_B_scene_triangle) * sizeof(ts_triangle));
	assert_ptr_equal(ts_probe_whole(d.probe, TS_B_scene_triangle), whole);
	assert_null(ts_probe_whole(d.probe, TS_B_points_record));
	assert_refused(TS_ERROR, "this needs points.record; a trace that was written whole has them");
	damage_end(&d);
	ts_triangle *triangles = damage(&d, &mvr, TS_B_scene_triangle);
	triangles[count(&mvr, TS_B_scene_triangle) - 1].vertex[2] = TS_NONE;
	assert_null(ts_probe_whole(d.probe, TS_B_scene_triangle));
	damage_end(&d);
}

/* What is there, how much of it, and what the method makes. */
static void a_probe_knows_what_is_there(void **state)
{
	(void)state;
	static const ts_buffer_id lacking[] = {TS_B_eye_view, TS_B_points_key, TS_B_scene_vertex, TS_B_points_record,
	                                       TS_N_BUFFERS},
							  there[] = {TS_B_eye_view, TS_B_scene_vertex, TS_N_BUFFERS};
	assert_true(ts_probe_has(mvr.probe, TS_B_eye_view) && !ts_probe_has(mvr.probe, TS_B_points_key));
	assert_true(ts_probe_makes(mvr.probe, TS_B_eye_view) && !ts_probe_makes(mvr.probe, TS_B_points_key));
	assert_int_equal(ts_probe_n(mvr.probe, TS_B_scene_vertex), count(&mvr, TS_B_scene_vertex));
	assert_int_equal(ts_probe_n(mvr.probe, TS_B_points_key), 0);
	require(ts_probe_require(mvr.probe, there));
	assert_refused(ts_probe_require(mvr.probe, lacking), "this needs points.key, points.record; a trace");
}

/* A pixel of three bytes; columns and rows beyond the picture are not there. */
static void pixels_are_fetched_by_row_and_column(void **state)
{
	(void)state;
	const u8 *srgb = data(&mvr, TS_B_image_srgb);
	for (u32 y = 0; y <= HEIGHT; y++) {
		for (u32 x = 0; x <= WIDTH; x++) {
			u8 found[3];
			bool there;
			require(ts_probe_fetch_pixel(mvr.probe, TS_B_image_srgb, x, y, 3, found, &there));
			assert_int_equal(there, x < WIDTH && y < HEIGHT);
			if (there) assert_memory_equal(found, srgb + (y * WIDTH + x) * 3, 3);
		}
	}
	bool there = true;
	require(ts_probe_fetch_pixel(mvr.probe, TS_B_points_key, 0, 0, 1, NULL, &there));
	assert_false(there);
}

/* What stages read is loaded once, and again where others read more; nothing is kept of what was refused. */
static void stages_share_what_is_loaded(void **state)
{
	(void)state;
	static const char *const eye[] = {"eye", NULL}, *const both[] = {"eye", "image", NULL};
	damaged d;
	ts_triangle *triangles = damage(&d, &mvr, TS_B_scene_triangle), kept = triangles[0];
	require(ts_probe_load_for(d.probe, eye));
	const ts_load *load = d.probe->load;
	const void *at = ts_probe_loaded(d.probe, TS_B_scene_triangle);
	assert_memory_equal(at, triangles, sizeof *triangles);
	assert_null(load->item[TS_B_mirror_pixel_offset]);
	require(ts_probe_load_for(d.probe, eye));
	assert_true(d.probe->load == load && ts_probe_loaded(d.probe, TS_B_scene_triangle) == at);
	require(ts_probe_load_for(d.probe, both));
	assert_non_null(d.probe->load->item[TS_B_mirror_pixel_offset]);
	assert_memory_equal(ts_probe_loaded(d.probe, TS_B_mirror_pixel_offset), data(&mvr, TS_B_mirror_pixel_offset),
	                    (size_t)count(&mvr, TS_B_mirror_pixel_offset) * sizeof(u32));
	load = d.probe->load;
	require(ts_probe_load_for(d.probe, eye));
	assert_ptr_equal(d.probe->load, load);
	damage_end(&d);
	triangles = damage(&d, &mvr, TS_B_scene_triangle);
	triangles[0].vertex[1] = TS_NONE;
	assert_refused(ts_probe_load_for(d.probe, eye), "scene.triangle");
	assert_null(d.probe->load);
	triangles[0] = kept;
	require(ts_probe_load_for(d.probe, eye));
	damage_end(&d);
}

/* Sizes are those that the buffers have; where files disagree the least, and crops say nothing. */
static void sizes_are_those_of_the_buffers(void **state)
{
	(void)state;
	const u64 n = count(&mvr, TS_B_scene_triangle);
	ts_trace trace = *mvr.trace;
	ts_probe *probe;
	assert_int_equal(mvr.probe->sizes.n[TS_DIM_triangles], n);
	assert_int_equal(mvr.probe->sizes.n[TS_DIM_width], WIDTH);
	assert_int_equal(mvr.probe->sizes.n[TS_DIM_cubes], MIRRORS);
	assert_int_equal(mvr.probe->sizes.n[TS_DIM_reflectors], MIRRORS);
	assert_int_equal(mvr.probe->sizes.n[TS_DIM_points], TS_UNKNOWN);
	trace.item[TS_B_scene_triangle].npy.shape[0] = n - 7;
	require(ts_probe_open(&probe, &trace));
	assert_int_equal(probe->sizes.n[TS_DIM_triangles], n - 7);
	ts_probe_close(probe);
	trace.item[TS_B_scene_triangle].cropped = true;
	require(ts_probe_open(&probe, &trace));
	assert_true(probe->sizes.n[TS_DIM_triangles] != n - 7);
	ts_probe_close(probe);
	ts_probe_close(NULL);
}

static void a_trace_without_params_is_refused(void **state)
{
	(void)state;
	ts_trace trace = *mvr.trace;
	ts_probe *probe = mvr.probe;
	trace.has_params = false;
	assert_refused(ts_probe_open(&probe, &trace), "trace.json has no params");
	assert_null(probe);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(any_run_of_elements_is_fetched),      cmocka_unit_test(elements_beyond_the_end_are_refused),
		cmocka_unit_test(fetched_floats_must_be_finite),       cmocka_unit_test(a_probe_knows_what_is_there),
		cmocka_unit_test(fetched_indices_must_name_something), cmocka_unit_test(fetched_keys_must_name_an_index),
		cmocka_unit_test(a_buffer_is_read_once_and_whole),     cmocka_unit_test(pixels_are_fetched_by_row_and_column),
		cmocka_unit_test(stages_share_what_is_loaded),         cmocka_unit_test(sizes_are_those_of_the_buffers),
		cmocka_unit_test(a_trace_without_params_is_refused),
	};
	return cmocka_run_group_tests(tests, mvr_make, mvr_drop);
}
