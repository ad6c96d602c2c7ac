/* First differences: planted in every component of every buffer's elements, they are found just there. */
#include "../kernels/seeded.h"
#include "../../src/trace/same.h"

enum { N = 3000, MOST_BYTES = 128 };

static u8 a[N * MOST_BYTES], b[N * MOST_BYTES];

static void test_every_component(void **state)
{
	(void)state;
	u32 random = 7;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_field fields[TS_MAX_FIELDS];
		ts_place place;
		size_t bytes = ts_buffer_table[id].element_bytes;
		assert_true(bytes <= MOST_BYTES);
		for (size_t i = 0; i < N * bytes; i++) a[i] = b[i] = (u8)((random = random * 1664525u + 1013904223u) >> 24);
		assert_true(ts_same_find(&place, (ts_buffer_id)id, a, b, N));
		assert_true(ts_same_find(&place, (ts_buffer_id)id, NULL, NULL, 0));
		u32 n = ts_field_list(fields, (ts_buffer_id)id);
		size_t at = 0;
		for (u32 f = 0; f < n; f++) {
			for (u32 k = 0; k < fields[f].count; k++, at += ts_type_bytes(fields[f].type)) {
				u64 element = (random = random * 1664525u + 1013904223u) % N;
				b[element * bytes + at] ^= 1;
				b[N * bytes - 1] ^= 128;
				assert_false(ts_same_find(&place, (ts_buffer_id)id, a, b, N));
				assert_int_equal(place.element, element);
				assert_string_equal(place.field.name, fields[f].name);
				assert_int_equal(place.component, k);
				b[element * bytes + at] ^= 1;
				b[N * bytes - 1] ^= 128;
			}
		}
		assert_int_equal(at, bytes);
	}
}

static void assert_prints(const char *expected, ts_type type, const void *value)
{
	char text[TS_VALUE_TEXT];
	ts_value_print(text, type, value);
	assert_string_equal(text, expected);
}

static void test_values(void **state)
{
	(void)state;
	const u32 pi = 0x40490fdb, minus_zero = 0x80000000, nan = 0x7fc00000, below = 0xfffffffe, lowest = 1u << 31;
	const u64 empty = UINT64_MAX;
	const u8 one = 1;
	assert_prints("3.14159274 (0x1.921fb6p+1, 40490fdb)", TS_TYPE_F32, &pi);
	assert_prints("-0 (-0x0p+0, 80000000)", TS_TYPE_F32, &minus_zero);
	assert_prints("nan (nan, 7fc00000)", TS_TYPE_F32, &nan);
	assert_prints("-2 (fffffffe)", TS_TYPE_I32, &below);
	assert_prints("-2147483648 (80000000)", TS_TYPE_I32, &lowest);
	assert_prints("4294967294 (fffffffe)", TS_TYPE_U32, &below);
	assert_prints("18446744073709551615 (ffffffffffffffff)", TS_TYPE_U64, &empty);
	assert_prints("1 (01)", TS_TYPE_U8, &one);
}

static void test_lines(void **state)
{
	(void)state;
	ts_point x[2] = {{.piece = 5}, {.centre = {0, 1, 0}, .piece = 6}}, y[2];
	ts_place place;
	char text[TS_SAME_TEXT];
	memcpy(y, x, sizeof y);
	y[1].centre[1] = 2;
	assert_false(ts_same_find(&place, TS_B_points_record, x, y, 2));
	ts_same_print(text, &place, "here", &x[1], "there", &y[1]);
	assert_string_equal(text, "element 1, field centre[1]: 1 (0x1p+0, 3f800000) here, 2 (0x1p+1, 40000000) there");
	y[1] = x[1];
	y[0].piece = 4;
	assert_false(ts_same_find(&place, TS_B_points_record, x, y, 2));
	ts_same_print(text, &place, "here", x, "there", y);
	assert_string_equal(text, "element 0, field piece: 5 (00000005) here, 4 (00000004) there");
	u8 p[4] = {0}, q[4] = {0, 0, 0, 1};
	assert_false(ts_same_find(&place, TS_B_splat_tie, p, q, 4));
	ts_same_print(text, &place, "here", &p[3], "there", &q[3]);
	assert_string_equal(text, "element 3: 0 (00) here, 1 (01) there");
}

/* Bits decide. */
static void test_bits(void **state)
{
	(void)state;
	u32 x = 0x7fc00000, y = 0x7fc00000;
	ts_place place;
	assert_true(ts_same_find(&place, TS_B_density_scale, &x, &y, 1));
	x = 0;
	y = 0x80000000;
	assert_false(ts_same_find(&place, TS_B_density_scale, &x, &y, 1));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_every_component), cmocka_unit_test(test_values), cmocka_unit_test(test_lines),
		cmocka_unit_test(test_bits),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
