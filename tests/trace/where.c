/* Places in words, by hand-made buffers. */
#include "tests/trace/folder.h"
#include "trace/where.h"

static ts_trace trace;

static void put(ts_buffer_id id, const void *data, u32 n_dims, u64 d0, u64 d1, u64 d2)
{
	ts_trace_item *item = &trace.item[id];
	item->npy =
		(ts_npy){.n_dims = n_dims, .shape = {d0, d1, d2}, .n = d0 * (n_dims > 1 ? d1 : 1) * (n_dims > 2 ? d2 : 1)};
	if (data == NULL) return;
	item->path = strdup(scratch_path("%s", ts_buffer_table[id].name));
	file_write(item->path, data, (size_t)item->npy.n * ts_buffer_table[id].element_bytes);
}

static int begin(void **state)
{
	if (scratch_begin(state) != 0) return -1;
	static const u64 keys[] = {812ull << 32 | (u64)(32768 + 3) << 16 | (32768 + 5),
	                           7ull << 32 | (u64)(32768 - 9) << 16 | 0};
	static const ts_face cubes[] = {{.n = 4, .offset = 0}, {.n = 0, .offset = 96}, {.n = 2, .offset = 96}};
	static const ts_pixel pixels[] = {{.index = 3 * 64 + 12}, {.index = 0}};
	ts_params_default(&trace.params);
	trace.params.width = 64;
	put(TS_B_points_key, keys, 1, 2, 0, 0);
	put(TS_B_cube_size_face, cubes, 1, 3, 0, 0);
	put(TS_B_mirror_pixel_record, pixels, 1, 2, 0, 0);
	put(TS_B_points_record, NULL, 1, 2, 0, 0);
	put(TS_B_splat_depth_index, NULL, 1, 120, 0, 0);
	put(TS_B_lookup_point, NULL, 2, 2, 25, 0);
	put(TS_B_lookup_second_point, NULL, 2, 9, 4, 0);
	put(TS_B_image_srgb, NULL, 3, 36, 64, 3);
	put(TS_B_eye_depth_triangle, NULL, 2, 36, 64, 0);
	put(TS_B_visibility_bits, NULL, 2, 100, 2, 0);
	put(TS_B_cube_face_mip, NULL, 2, 900, 4, 0);
	put(TS_B_scene_vertex, NULL, 1, 50, 0, 0);
	put(TS_B_view_map_depth_node, NULL, 2, 9, 512, 0);
	return 0;
}

static int end(void **state)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) free(trace.item[id].path);
	return scratch_remove(state);
}

static void is(ts_buffer_id id, u64 element, const char *expected)
{
	char text[TS_WHERE_TEXT];
	assert_int_equal(ts_where(text, &trace, id, element), TS_OK);
	assert_string_equal(text, expected);
}

static void places_are_told_in_words(void **state)
{
	(void)state;
	is(TS_B_points_record, 0, "key (piece 812, x 5, y 3)");
	is(TS_B_points_key, 1, "key (piece 7, x -32768, y -9)");
	is(TS_B_splat_depth_index, 0, "reflector 0, face +X, texel (0, 0)");
	is(TS_B_splat_depth_index, 16 * 3 + 6, "reflector 0, face -Y, texel (2, 1)");
	is(TS_B_splat_depth_index, 95, "reflector 0, face -Z, texel (3, 3)");
	is(TS_B_splat_depth_index, 96 + 4 * 4 + 1, "reflector 2, face +Z, texel (1, 0)");
	is(TS_B_splat_depth_index, 5000, "texel 5000");
	is(TS_B_mirror_pixel_record, 0, "pixel (12, 3)");
	is(TS_B_lookup_point, 24, "pixel (12, 3) [24]");
	is(TS_B_lookup_point, 25, "pixel (0, 0) [0]");
	is(TS_B_lookup_second_point, 7, "entry of bounce 2 1 [3]");
	is(TS_B_image_srgb, (2 * 64 + 5) * 3 + 1, "pixel (5, 2) [1]");
	is(TS_B_eye_depth_triangle, 64 + 63, "pixel (63, 1)");
	is(TS_B_visibility_bits, 9, "triangle 4 [1]");
	is(TS_B_cube_face_mip, 9, "texel 2 [1]");
	is(TS_B_scene_vertex, 49, "vertex 49");
	is(TS_B_scene_triangle, 8, "triangle 8");
	is(TS_B_scene_surfel, 36, "surfel 36");
	is(TS_B_split_offset, 5, "triangle 5");
	is(TS_B_mirror_pixel_offset, 70, "pixel 70");
	is(TS_B_lookup_second_offset, 60, "sample 60");
	is(TS_B_octree_node, 5, "node 5");
	is(TS_B_octree_offset, 4, "leaf 4");
	is(TS_B_vpl_light, 3, "virtual point light 3");
	is(TS_B_view_octree_leaf, 3, "virtual point light 3");
	is(TS_B_view_octree_cone, 5, "view node 5");
	is(TS_B_view_map_depth_node, 5 * 512 + 7, "view node 5 [7]");
	is(TS_B_segment_box, 2, "box 2");
	is(TS_B_octree_root_least, 4, "element 4");
}

/* What one size counts is called by its noun, where the trace says no more of it. */
static void what_a_size_counts_has_its_noun(void **state)
{
	(void)state;
	u32 n = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_shape *shape = ts_buffer_shape((ts_buffer_id)id);
		ts_dim dim = ts_axis_counts(&shape->axis[0]);
		if (shape->n != 1 || dim == TS_DIM_none || dim == TS_DIM_texels || trace.item[id].npy.n != 0) continue;
		char expected[TS_WHERE_TEXT];
		snprintf(expected, sizeof expected, "%s 9", ts_dim_table[dim].noun);
		is((ts_buffer_id)id, 9, expected);
		n++;
	}
	assert_true(n > 40);
}

/* Sums over all pixels, and over all of their samples. */
static void sums_over_pixels_name_their_pixel(void **state)
{
	(void)state;
	const ts_view eye = {.width = 64, .height = 36};
	ts_trace_item *view = &trace.item[TS_B_eye_view], *offset = &trace.item[TS_B_mirror_pixel_offset];
	put(TS_B_eye_view, &eye, 1, 1, 0, 0);
	offset->npy.n = 64 * 36 + 1;
	is(TS_B_mirror_pixel_offset, 70, "pixel (6, 1)");
	is(TS_B_fragment_list_offset, 64 * 36 - 1, "pixel (63, 35)");
	offset->npy.n = 4 * 64 * 36 + 1;
	is(TS_B_mirror_pixel_offset, 70, "pixel (6, 1), sample 0");
	is(TS_B_mirror_pixel_offset, 3 * 64 * 36 + 70, "pixel (6, 1), sample 3");
	offset->npy.n = 0;
	free(view->path);
	*view = (ts_trace_item){.path = NULL};
}

static void crops_name_pixels_of_the_whole(void **state)
{
	(void)state;
	ts_trace_item *item = &trace.item[TS_B_image_srgb], whole = *item;
	item->npy.shape[0] = 5;
	item->npy.shape[1] = 10;
	item->cropped = true;
	memcpy(item->crop, (u32[]){20, 30, 10, 5}, sizeof item->crop);
	is(TS_B_image_srgb, (2 * 10 + 7) * 3 + 2, "pixel (27, 32) [2]");
	*item = whole;
}

/* A place names no cube, texel or size that the reference lacks. */
static void places_name_nothing_that_is_lacking(void **state)
{
	(void)state;
	char *keys = trace.item[TS_B_points_key].path, *cubes = trace.item[TS_B_cube_size_face].path;
	trace.item[TS_B_points_key].path = trace.item[TS_B_cube_size_face].path = NULL;
	is(TS_B_points_record, 1, "point 1");
	is(TS_B_splat_depth_index, 3, "texel 3");
	trace.item[TS_B_points_key].path = keys;
	trace.item[TS_B_cube_size_face].path = cubes;
	trace.params.width = 0;
	is(TS_B_mirror_pixel_record, 0, "pixel 0");
	trace.params.width = 64;
	ts_trace_item *item = &trace.item[TS_B_lookup_point], whole = *item;
	item->npy.shape[1] = 0;
	is(TS_B_lookup_point, 0, "pixel (12, 3)");
	*item = whole;
}

/* Texels of views that are no cubes' faces: by the view that has them. */
static void texels_are_told_by_their_view(void **state)
{
	(void)state;
	static const ts_offscreen views[] = {{.width = 5, .height = 3, .offset = 0},
	                                     {.width = 0, .height = 0, .offset = 15},
	                                     {.width = 4, .height = 4, .offset = 15},
	                                     {.width = 2, .height = 2, .offset = 40}};
	char *cubes = trace.item[TS_B_cube_size_face].path;
	ts_trace_item *item = &trace.item[TS_B_offscreen_view];
	trace.item[TS_B_cube_size_face].path = NULL;
	put(TS_B_offscreen_view, views, 1, 4, 0, 0);
	is(TS_B_splat_depth_index, 0, "view 0, texel (0, 0)");
	is(TS_B_splat_depth_index, 14, "view 0, texel (4, 2)");
	is(TS_B_splat_depth_index, 15, "view 2, texel (0, 0)");
	is(TS_B_splat_depth_index, 15 + 11, "view 2, texel (3, 2)");
	is(TS_B_splat_depth_index, 31, "texel 31");
	is(TS_B_splat_depth_index, 39, "texel 39");
	is(TS_B_splat_depth_index, 43, "view 3, texel (1, 1)");
	is(TS_B_splat_depth_index, 44, "texel 44");
	free(item->path);
	*item = (ts_trace_item){.path = NULL};
	trace.item[TS_B_cube_size_face].path = cubes;
}

int main(void)
{
	const struct CMUnitTest where[] = {
		cmocka_unit_test(places_are_told_in_words),
		cmocka_unit_test(what_a_size_counts_has_its_noun),
		cmocka_unit_test(sums_over_pixels_name_their_pixel),
		cmocka_unit_test(crops_name_pixels_of_the_whole),
		cmocka_unit_test(places_name_nothing_that_is_lacking),
		cmocka_unit_test(texels_are_told_by_their_view),
	};
	return cmocka_run_group_tests(where, begin, end);
}
