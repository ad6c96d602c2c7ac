/* Dtypes of all buffers: of the size of their elements, and taken back in the header of a file. */
#include "tests/trace/folder.h"

/* Sizes of the types in a dtype must add up to the element: no padding that records.def does not name. */
static void dtypes_are_as_wide_as_their_elements(void **state)
{
	(void)state;
	char descr[TS_NPY_DESCR];
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		size_t bytes = 0;
		ts_npy_descr(descr, (ts_buffer_id)id);
		for (const char *at = descr; (at = strpbrk(at, "<|")) != NULL; at++) {
			unsigned count = 1;
			assert_true((at[0] == '|' && strncmp(at + 1, "u1'", 3) == 0) ||
			            (at[0] == '<' && strchr("fiu", at[1]) != NULL));
			if (at[3] == '\'') sscanf(at + 4, ", (%u,)", &count);
			bytes += (size_t)(at[2] - '0') * count;
		}
		assert_int_equal(bytes, ts_buffer_table[id].element_bytes);
	}
	ts_npy_descr(descr, TS_B_points_record);
	assert_string_equal(descr, "[('centre', '<f4', (3,)), ('length', '<f4'), ('piece', '<u4'), ('flags', '<u4'), "
	                           "('pad', '<u4', (2,))]");
}

static void headers_read_back_what_was_written(void **state)
{
	(void)state;
	char head[TS_NPY_HEADER], descr[TS_NPY_DESCR];
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_npy npy;
		size_t element = ts_buffer_table[id].element_bytes;
		ts_npy_descr(descr, (ts_buffer_id)id);
		size_t bytes = ts_npy_header(head, descr, 2, (const u64[]){5, 3});
		assert_int_equal(ts_npy_parse(&npy, "f", head, bytes, bytes + 15 * element, descr, element), TS_OK);
		assert_true(npy.n == 15 && npy.data_at == bytes);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(dtypes_are_as_wide_as_their_elements),
	                                   cmocka_unit_test(headers_read_back_what_was_written)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
