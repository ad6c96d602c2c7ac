/* The rows of records.def agree with each other. */
#include <string.h>
#include "model/table.h"
#include "tests/model/test.h"

/* ts_buffer_shape itself asserts that each shape is one. */
static void shapes_of_the_table_are_shapes(void **state)
{
	(void)state;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_shape *shape = ts_buffer_shape((ts_buffer_id)id);
		ts_shape again;
		assert_true(ts_shape_parse(&again, ts_buffer_table[id].shape) && again.n == shape->n);
		assert_true(shape->n >= 1);
		for (u32 i = 1; i < shape->n; i++) assert_int_equal(shape->axis[i].more, 0);
	}
}

static bool is_summed(ts_dim dim)
{
	size_t n;
	const ts_sum_info *sums = ts_sum_table(&n);
	for (size_t i = 0; i < n; i++) {
		if (sums[i].size == dim) return true;
	}
	return false;
}

static bool is_given(ts_dim dim)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (ts_buffer_gives((ts_buffer_id)id) == dim) return true;
	}
	return false;
}

/* A trace tells every size that is not computed: all but that of reflectors, which scene.info holds, and of paths,
 * whose buffer holds one more. */
static void every_size_is_told_or_computed(void **state)
{
	(void)state;
	for (u32 dim = 0; dim < TS_N_DIMS; dim++) {
		const ts_dim_info *info = &ts_dim_table[dim];
		assert_true(info->noun[0] != 0 && info->doc[0] != 0 && (info->bits == 32 || info->bits == 64));
		for (u32 other = 0; other < dim; other++) assert_string_not_equal(ts_dim_table[other].name, info->name);
		if (info->how != TS_IS_fixed && info->how != TS_IS_counted) continue;
		bool apart = dim == TS_DIM_reflectors || dim == TS_DIM_paths;
		if (is_given((ts_dim)dim) == apart) fail_msg("%s: %s", info->name, apart ? "is told" : "nothing tells it");
		assert_true(!is_summed((ts_dim)dim) || info->how == TS_IS_counted);
	}
	assert_true(ts_buffer_counts(TS_B_vpl_path) == TS_DIM_paths && ts_buffer_gives(TS_B_vpl_path) == TS_DIM_none);
	assert_true(ts_buffer_gives(TS_B_image_srgb) == TS_DIM_none &&
	            ts_buffer_gives(TS_B_depth_grid_depth) == TS_DIM_none);
	assert_true(ts_buffer_gives(TS_B_points_key) == TS_DIM_points &&
	            ts_buffer_gives(TS_B_depth_map_depth) == TS_DIM_texels);
}

static void tables_of_sums_hold_sums(void **state)
{
	(void)state;
	size_t n;
	const ts_sum_info *sums = ts_sum_table(&n);
	for (size_t i = 0; i < n; i++) {
		const ts_shape *shape = ts_buffer_shape(sums[i].buffer);
		const char *name = ts_buffer_table[sums[i].buffer].name;
		bool words = strcmp(ts_buffer_table[sums[i].buffer].element, "u32") == 0;
		if (!words || shape->n != 1 || shape->axis[0].more != 1) fail_msg("%s holds no sums", name);
		assert_ptr_equal(ts_sum_of(sums[i].buffer), &sums[i]);
	}
	assert_null(ts_sum_of(TS_B_scene_vertex));
}

/* Buffers with one more than there are things are sums; the levels of an octree are not read as such. */
static void every_buffer_of_one_more_holds_sums(void **state)
{
	(void)state;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool levels = id == TS_B_octree_level || id == TS_B_view_octree_level;
		bool more = ts_buffer_shape((ts_buffer_id)id)->axis[0].more == 1 && !levels;
		if (more != (ts_sum_of((ts_buffer_id)id) != NULL)) fail_msg("%s", ts_buffer_table[id].name);
	}
}

static bool has_field(const char *record, const char *name)
{
	size_t n;
	const ts_field_info *fields = ts_field_table(&n);
	for (size_t i = 0; i < n; i++) {
		bool same = strcmp(fields[i].record, record) == 0 && strcmp(fields[i].name, name) == 0;
		if (same) return fields[i].type[0] == 'u';
	}
	return false;
}

static void indices_name_fields_and_sizes(void **state)
{
	(void)state;
	size_t n;
	const ts_index_info *indices = ts_index_table(&n);
	for (size_t i = 0; i < n; i++) {
		const char *element = ts_buffer_table[indices[i].buffer].element;
		bool scalar = indices[i].field[0] == 0 && element[0] == 'u';
		if (!scalar && !has_field(element, indices[i].field)) {
			fail_msg("%s has no \"%s\"", ts_buffer_table[indices[i].buffer].name, indices[i].field);
		}
		ts_shape size;
		assert_true(ts_shape_parse(&size, indices[i].size) && size.n == 1);
		assert_memory_equal(&size.axis[0], &indices[i].of, sizeof indices[i].of);
	}
}

int main(void)
{
	const struct CMUnitTest table[] = {
		cmocka_unit_test(shapes_of_the_table_are_shapes), cmocka_unit_test(every_size_is_told_or_computed),
		cmocka_unit_test(tables_of_sums_hold_sums),       cmocka_unit_test(every_buffer_of_one_more_holds_sums),
		cmocka_unit_test(indices_name_fields_and_sizes),
	};
	return cmocka_run_group_tests(table, NULL, NULL);
}
