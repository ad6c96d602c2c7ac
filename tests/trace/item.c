/* Files of traces: paths that are too long by a byte, and candidates of other shapes than the reference's. */
#include "tests/trace/folder.h"
#include "trace/item.h"

/* A folder's name so long that the path of "k.npy" in it takes `bytes`, its end included. */
static char *folder_for(size_t bytes)
{
	size_t n = bytes - sizeof "/k.npy";
	char *dir = malloc(n + 1);
	assert_non_null(dir);
	memset(dir, 'd', n);
	dir[n] = 0;
	return dir;
}

static void a_path_a_byte_too_long_fails(void **state)
{
	(void)state;
	static char path[TS_PATH];
	for (size_t bytes = TS_PATH - 2; bytes < TS_PATH + 3; bytes++) {
		char *dir = folder_for(bytes);
		ts_status status = ts_item_path(path, dir, "k.npy", TS_IN_FOLDER);
		assert_int_equal(status, bytes <= TS_PATH ? TS_OK : TS_ERROR);
		if (status == TS_OK) {
			assert_int_equal(strlen(path), bytes - 1);
			assert_string_equal(path + bytes - sizeof "/k.npy", "/k.npy");
		} else {
			char message[64];
			snprintf(message, sizeof message, "d: a path of %zu bytes in it; at most 4095 would do", bytes - 1);
			says(message);
		}
		free(dir);
	}
}

static ts_trace_item item_of(u32 n_dims, u64 d0, u64 d1, u64 d2)
{
	static char path[] = "port/file.npy";
	return (ts_trace_item){.path = path, .npy = {.n_dims = n_dims, .shape = {d0, d1, d2}}};
}

static void matches(ts_buffer_id id, ts_trace_item reference, ts_trace_item candidate)
{
	if (ts_item_match(id, &reference, &candidate) != TS_OK) fail_msg("%s", ts_error_message());
}

static void differs(ts_buffer_id id, ts_trace_item reference, ts_trace_item candidate, const char *what)
{
	assert_int_equal(ts_item_match(id, &reference, &candidate), TS_ERROR);
	assert_string_equal(ts_error_message(), what);
}

/* Every size must be the reference's, but for the first where it was computed: points, not pixels or triangles. */
static void only_computed_sizes_may_differ(void **state)
{
	(void)state;
	matches(TS_B_image_srgb, item_of(3, 36, 64, 3), item_of(3, 36, 64, 3));
	differs(TS_B_image_srgb, item_of(3, 36, 64, 3), item_of(3, 37, 64, 3),
	        "port/file.npy: shape 37 x 64 x 3; the reference's is 36 x 64 x 3");
	differs(TS_B_image_srgb, item_of(3, 36, 64, 3), item_of(3, 36, 63, 3),
	        "port/file.npy: shape 36 x 63 x 3; the reference's is 36 x 64 x 3");
	differs(TS_B_scene_triangle, item_of(1, 5, 0, 0), item_of(1, 6, 0, 0),
	        "port/file.npy: shape 6; the reference's is 5");
	matches(TS_B_scene_triangle, item_of(1, 5, 0, 0), item_of(1, 5, 0, 0));
	matches(TS_B_points_record, item_of(1, 5, 0, 0), item_of(1, 7, 0, 0));
	matches(TS_B_lookup_point, item_of(2, 5, 25, 0), item_of(2, 7, 25, 0));
	differs(TS_B_lookup_point, item_of(2, 5, 25, 0), item_of(2, 7, 9, 0),
	        "port/file.npy: shape 7 x 9; the reference's is 5 x 25");
}

static void crops_must_be_the_same(void **state)
{
	(void)state;
	ts_trace_item whole = item_of(3, 36, 64, 3), part = item_of(3, 5, 10, 3), other;
	memcpy(part.crop, (u32[]){1, 2, 10, 5}, sizeof part.crop);
	other = part;
	matches(TS_B_image_srgb, part, other);
	differs(TS_B_image_srgb, whole, part,
	        "port/file.npy: crop 1,2,10,5; the reference's is 0,0,0,0, of width 0 where it is whole");
	for (u32 i = 0; i < 4; i++) {
		other.crop[i]++;
		assert_int_equal(ts_item_match(TS_B_image_srgb, &part, &other), TS_ERROR);
		other.crop[i]--;
	}
}

int main(void)
{
	const struct CMUnitTest item[] = {
		cmocka_unit_test(a_path_a_byte_too_long_fails),
		cmocka_unit_test(only_computed_sizes_may_differ),
		cmocka_unit_test(crops_must_be_the_same),
	};
	return cmocka_run_group_tests(item, NULL, NULL);
}
