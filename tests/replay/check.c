/* Checks of sizes, indices and floats: for each a fault planted in a copy of a buffer is refused with its place. */
#include "tests/replay/faults.h"

/* The first stage of any method that reads a buffer of its trace; NULL: none. Indices into lights need a method that
 * has some. */
static const ts_stage *reader_of(ts_buffer_id id, const ts_axis *of, u32 *m)
{
	for (*m = of != NULL && ts_axis_counts(of) == TS_DIM_lamps ? TRACES_SOFT : 0; *m < N_TRACES; ++*m) {
		if (traces[*m]->item[id].path == NULL) continue;
		FOR_STAGES(*m, stage)
		{
			if (ts_stage_reads(stage, id)) return stage;
		}
	}
	*m = 0;
	return NULL;
}

/* Whether there is none is told elsewhere, too: by reflectors, sums, or what a node has for children and parent. */
static bool is_bound(ts_buffer_id id)
{
	bool is_node = id == TS_B_octree_node || id == TS_B_view_octree_node;
	return id == TS_B_scene_object || id == TS_B_surfel_blend_heaviest || is_node;
}

/* Just past the end, and far past it. */
static void indices_past_the_end_are_refused(void **state)
{
	(void)state;
	size_t n_indices;
	const ts_index_info *indices = ts_index_table(&n_indices);
	for (size_t row = 0; row < n_indices; row++) {
		u32 m;
		ts_buffer_id id = indices[row].buffer, ids[TS_N_BUFFERS + 1];
		const ts_stage *stage = reader_of(id, &indices[row].of, &m);
		if (id == TS_B_fragment_list_surfel) continue; /* where sums have an order alone */
		assert_non_null(stage);
		ts_load *load;
		ts_replay_reads(ids, stage, traces[m]->pipeline, &traces[m]->params);
		assert_int_equal(ts_load_begin(&load, ids, traces[m], NULL, 1), TS_OK);
		assert_int_equal(ts_check(load, stage), TS_OK);
		u64 size = ts_axis_size(&indices[row].of, &load->sizes), n = ts_frame_n(&load->run.frame, id), last = n - 1;
		assert_true(size != TS_UNKNOWN);
		ts_load_end(load);
		bool key = ts_buffer_table[id].element_bytes == 8 && strcmp(ts_buffer_table[id].element, "u64") == 0;
		refuses(m, stage, id, last, indices[row].field, 0, size);
		refuses(m, stage, id, 0, indices[row].field, 0, 0xfffffffe);
		if (key) refuses(m, stage, id, last, "", 0, 0x3f800000ffffffffull);
		if (!indices[row].none) {
			refuses(m, stage, id, last, indices[row].field, 0, TS_NONE);
		} else if (!is_bound(id)) {
			accepts(m, stage, id, last, indices[row].field, 0, key ? UINT64_MAX : TS_NONE);
		}
	}
}

/* Every float of every buffer that a stage reads. */
static void floats_that_are_no_numbers_are_refused(void **state)
{
	(void)state;
	static const u32 odd[] = {0x7f800000, 0xff800000, 0x7fc00000, 0x7f800001};
	u32 n_tested = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		u32 m;
		const ts_stage *stage = reader_of((ts_buffer_id)id, NULL, &m);
		const ts_fields fields = ts_fields_of((ts_buffer_id)id);
		u32 n = fields.n;
		for (u32 f = 0; f < n && stage != NULL; f++) {
			u64 elements = traces[m]->item[id].npy.n;
			if (fields.field[f].kind != 'f' || elements == 0) continue;
			u64 element = random_below((u32)elements);
			refuses(m, stage, (ts_buffer_id)id, element, fields.field[f].name, fields.field[f].count - 1,
			        odd[n_tested++ % 4]);
		}
	}
	assert_true(n_tested > 60);
}

/* A row less, of every buffer whose rows another buffer counts. */
static void a_row_less_is_refused(void **state)
{
	(void)state;
	static const ts_buffer_id counted[] = {
		TS_B_pose_vertex,
		TS_B_cube_size_face,
		TS_B_eye_depth_triangle,
		TS_B_mirror_pixel_offset,
		TS_B_visibility_bits,
		TS_B_split_density,
		TS_B_cull_keep,
		TS_B_align_frame,
		TS_B_points_offset,
		TS_B_points_record,
		TS_B_splat_depth_index,
		TS_B_lookup_point,
		TS_B_lookup_second_offset,
		TS_B_lookup_third_offset,
		TS_B_cube_face_depth_triangle,
		TS_B_cube_face_mip,
		TS_B_lamp_shape,
		TS_B_offscreen_view,
		TS_B_depth_map_depth,
		TS_B_scatter_colour,
		TS_B_shadow_test_lit,
		TS_B_rsm_depth_triangle,
		TS_B_gbuffer_pixel,
		TS_B_depth_grid_depth,
		TS_B_segment_label,
		TS_B_segment_extent,
		TS_B_segment_box_offset,
		TS_B_corner_moment,
		TS_B_corner_lobes,
		TS_B_indirect_irradiance,
		TS_B_voxel_mask,
		TS_B_view_octree_leaf,
		TS_B_view_octree_cone,
		TS_B_view_map_depth_node,
		TS_B_view_map_fused_depth,
		TS_B_vpl_gather_pair_offset,
		TS_B_surfel_depth_surfel,
		TS_B_surfel_blend_sum,
	};
	for (u32 i = 0; i < sizeof counted / sizeof *counted; i++) {
		u32 m;
		ts_buffer buffer;
		const ts_stage *stage = NULL;
		for (m = 0; m < N_TRACES && stage == NULL; m++) {
			if (traces[m]->item[counted[i]].path == NULL) continue;
			FOR_STAGES(m, s)
			{
				ts_buffer_id reads[TS_N_BUFFERS + 1];
				ts_replay_reads(reads, s, traces[m]->pipeline, &traces[m]->params);
				for (u32 k = 0; reads[k] != TS_N_BUFFERS; k++) {
					if (reads[k] == counted[i]) stage = s; /* the last: it reads most */
				}
			}
		}
		assert_non_null(stage);
		m--;
		void *data = traces_read(&buffer, traces[m], counted[i]);
		buffer.n -= buffer.n / buffer.shape[0];
		buffer.shape[0]--;
		ts_status status = replay_with(m, stage, counted[i], &buffer);
		if (status != TS_ERROR) fail_msg("%s accepts a row less of %s", stage->name, ts_buffer_table[counted[i]].name);
		bool told = strstr(ts_error_message(), "shape") != NULL || strstr(ts_error_message(), "would be right") != NULL;
		if (!told) fail_msg("%s", ts_error_message());
		assert_null(strchr(ts_error_message(), '\n'));
		free(data);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(indices_past_the_end_are_refused),
		cmocka_unit_test(floats_that_are_no_numbers_are_refused),
		cmocka_unit_test(a_row_less_is_refused),
	};
	return cmocka_run_group_tests(tests, traces_begin, traces_end);
}
