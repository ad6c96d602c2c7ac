/* The frame: accounting of bytes, batches, borrowed memory, and the tables of records.def. */
#include "model/frame.h"
#include "tests/model/test.h"

static void buffers_are_made_and_dropped(void **state)
{
	(void)state;
	ts_frame frame = {0};
	u64 *keys = ts_frame_make1(&frame, TS_B_points_key, 1000);
	assert_non_null(keys);
	memset(keys, 0xff, 8000);
	assert_non_null(ts_frame_make3(&frame, TS_B_image_radiance, 10, 20, 3));
	assert_int_equal(frame.bytes, 8000 + 2400);
	assert_ptr_equal(ts_frame_data(&frame, TS_B_points_key), keys);
	assert_int_equal(ts_frame_n(&frame, TS_B_image_radiance), 600);
	assert_int_equal(frame.buffer[TS_B_image_radiance].n_dims, 3);
	assert_int_equal(frame.buffer[TS_B_image_radiance].shape[1], 20);
	ts_frame_drop(&frame, TS_B_points_key);
	assert_false(frame.buffer[TS_B_points_key].made);
	assert_int_equal(frame.bytes, 2400);
	assert_int_equal(frame.peak_bytes, 10400);
	ts_frame_clear(&frame);
	assert_int_equal(frame.bytes, 0);
}

static void a_batch_replaces_the_one_before(void **state)
{
	(void)state;
	ts_frame frame = {0};
	for (u64 n = 0; n < 50; n++) {
		assert_non_null(ts_frame_make2(&frame, TS_B_lookup_point, n, 25));
		assert_int_equal(frame.bytes, n * 25 * 4);
	}
	assert_int_equal(frame.peak_bytes, 49 * 25 * 4);
	ts_frame_clear(&frame);
}

static void borrowed_memory_is_not_ours(void **state)
{
	(void)state;
	static const ts_triangle triangles[2];
	ts_frame frame = {0};
	ts_frame_borrow(&frame, TS_B_scene_triangle, triangles, 2);
	assert_int_equal(frame.bytes, 0);
	assert_ptr_equal(ts_frame_data(&frame, TS_B_scene_triangle), triangles);
	assert_int_equal(ts_frame_n(&frame, TS_B_scene_triangle), 2);
	ts_frame_clear(&frame);
}

static void a_cut_buffer_keeps_its_beginning(void **state)
{
	(void)state;
	ts_frame frame = {0};
	u64 *keys = ts_frame_make1(&frame, TS_B_points_key, 1000);
	assert_non_null(keys);
	for (u64 i = 0; i < 1000; i++) keys[i] = i;
	ts_frame_cut(&frame, TS_B_points_key, 10);
	assert_int_equal(ts_frame_n(&frame, TS_B_points_key), 10);
	assert_int_equal(frame.buffer[TS_B_points_key].shape[0], 10);
	assert_int_equal(frame.bytes, 80);
	keys = ts_frame_data(&frame, TS_B_points_key);
	for (u64 i = 0; i < 10; i++) assert_int_equal(keys[i], i);
	ts_frame_drop(&frame, TS_B_points_key);
	assert_int_equal(frame.bytes, 0);
}

static u32 n_released[3];
static ts_status fetch_nothing(void *resident)
{
	(void)resident;
	return TS_OK;
}
static void count_release(void *resident) { ++*(u32 *)resident; }

/* A device's copy is released once: when its buffer is released, when the buffer is lent again, or with the frame. */
static void what_is_resident_is_released(void **state)
{
	(void)state;
	static const ts_residence residence = {fetch_nothing, count_release};
	ts_frame frame = {.residence = &residence};
	assert_non_null(ts_frame_make1(&frame, TS_B_points_key, 10));
	frame.buffer[TS_B_points_key].resident = &n_released[0];
	ts_frame_drop(&frame, TS_B_points_key);
	assert_int_equal(n_released[0], 1);
	ts_frame_lend(&frame, TS_WORK_queue, n_released, sizeof n_released);
	frame.lent[TS_WORK_queue].resident = &n_released[1];
	ts_frame_lend(&frame, TS_WORK_queue, n_released, sizeof n_released);
	assert_int_equal(n_released[1], 1);
	frame.lent[TS_WORK_queue].resident = &n_released[2];
	ts_frame_clear(&frame);
	for (u32 i = 0; i < 3; i++) assert_int_equal(n_released[i], 1);
}

static void absurd_shapes_are_refused(void **state)
{
	(void)state;
	ts_frame frame = {0};
	assert_null(ts_frame_make2(&frame, TS_B_visibility_bits, (u64)1 << 40, (u64)1 << 40));
	assert_non_null(strstr(ts_error_message(), "visibility.bits"));
	assert_null(ts_frame_make1(&frame, TS_B_points_record, UINT64_MAX / 2));
	assert_non_null(strstr(ts_error_message(), "points.record"));
	assert_false(frame.buffer[TS_B_points_record].made);
	assert_int_equal(frame.bytes, 0);
}

static void every_record_is_covered_by_its_fields(void **state)
{
	(void)state;
	size_t n;
	const ts_field_info *fields = ts_field_table(&n);
	size_t bytes = 0, records = 0;
	for (size_t i = 0; i < n; i++) {
		assert_non_null(fields[i].record);
		assert_true(strlen(fields[i].name) > 0);
		size_t size = strcmp(fields[i].type, "u64") == 0 || strcmp(fields[i].type, "i64") == 0 ? 8 : 4;
		assert_int_equal(bytes % size, 0);
		bytes += size * fields[i].count;
		if (i + 1 == n || strcmp(fields[i].record, fields[i + 1].record) != 0) {
			for (u32 b = 0; b < TS_N_BUFFERS; b++) {
				if (strcmp(ts_buffer_table[b].element, fields[i].record) == 0) {
					assert_int_equal(ts_buffer_table[b].element_bytes, bytes);
				}
			}
			bytes = 0;
			records++;
		}
	}
	assert_true(records >= 10);
}

static void names_of_buffers_are_unique_and_keys_exist(void **state)
{
	(void)state;
	for (u32 a = 0; a < TS_N_BUFFERS; a++) {
		const ts_buffer_info *info = &ts_buffer_table[a];
		bool key_found = strcmp(info->order, "set") != 0;
		assert_non_null(strchr(info->name, '.'));
		for (u32 b = 0; b < TS_N_BUFFERS; b++) {
			assert_true(a == b || strcmp(info->name, ts_buffer_table[b].name) != 0);
			key_found |= strcmp(info->key, ts_buffer_table[b].name) == 0;
		}
		assert_true(key_found);
	}
}

int main(void)
{
	const struct CMUnitTest frame[] = {
		cmocka_unit_test(buffers_are_made_and_dropped),
		cmocka_unit_test(a_batch_replaces_the_one_before),
		cmocka_unit_test(borrowed_memory_is_not_ours),
		cmocka_unit_test(a_cut_buffer_keeps_its_beginning),
		cmocka_unit_test(what_is_resident_is_released),
		cmocka_unit_test(absurd_shapes_are_refused),
		cmocka_unit_test(every_record_is_covered_by_its_fields),
		cmocka_unit_test(names_of_buffers_are_unique_and_keys_exist),
	};
	return cmocka_run_group_tests(frame, NULL, NULL);
}
