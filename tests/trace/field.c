/* Floats apart, by closed forms; fields by the offsets of the structs; values as they are shown. */
#include <math.h>
#include "kernels/base/compat.h"
#include "kernels/base/num.h"
#include "tests/trace/folder.h"
#include "trace/field.h"

static void floats_are_apart_by_their_steps(void **state)
{
	(void)state;
	static const struct {
		f32 from, to;
		i64 ulps;
	} cases[] = {
		{0.0f, 0.0f, 0},
		{-0.0f, -0.0f, 0},
		{-0.0f, 0.0f, 1},
		{0.0f, -0.0f, -1},
		{0.0f, 0x1p-149f, 1},
		{-0.0f, -0x1p-149f, -1},
		{-0x1p-149f, 0x1p-149f, 3},
		{1.0f, 0x1.000002p+0f, 1},
		{1.0f, 0x1.fffffep-1f, -1},
		{1.0f, 2.0f, 1 << 23},
		{-1.0f, -2.0f, -(1 << 23)},
		{0x1p-126f, 0x1.fffffcp-127f, -1},
		{0.0f, 0x1p-126f, 1 << 23},
		{0x1.fffffep+127f, INFINITY, 1},
		{INFINITY, INFINITY, 0},
		{0.0f, INFINITY, 0x7f800000},
		{-INFINITY, INFINITY, 0xff000001},
		{INFINITY, -INFINITY, -(i64)0xff000001},
	};
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		i64 ulps = ts_field_ulps(ts_f2u(cases[i].from), ts_f2u(cases[i].to));
		if (ulps != cases[i].ulps)
			fail_msg("%a to %a: %lld", (double)cases[i].from, (double)cases[i].to, (long long)ulps);
	}
	static const u32 nans[] = {0x7fc00000u, 0xffc00000u, 0x7f800001u, 0xffffffffu};
	for (u32 i = 0; i < 4; i++) {
		assert_true(ts_field_is_nan(nans[i]));
		assert_true(ts_field_ulps(nans[i], nans[i]) == INT64_MAX && ts_field_ulps(0, nans[i]) == INT64_MAX);
	}
	assert_false(ts_field_is_nan(0x7f800000u) || ts_field_is_nan(0xff800000u) || ts_field_is_nan(0x80000000u));
}

/* As many steps of nextafter as floats apart; zero counts twice. */
static void steps_are_those_of_nextafter(void **state)
{
	(void)state;
	static const f32 from[] = {-0x1p-147f, 0x1.fffff0p-1f, -0x1.00001p+5f, 0x1.fffff8p-127f};
	for (u32 i = 0; i < 4; i++) {
		f32 at = from[i];
		for (i64 n = 0; n < 40; n++) {
			assert_true(ts_field_ulps(ts_f2u(from[i]), ts_f2u(at)) == n);
			bool minus_zero = at == 0 && signbit(at);
			at = minus_zero ? 0.0f : nextafterf(at, INFINITY);
		}
	}
}

static void shows(const ts_field *field, u64 bits, const char *expected)
{
	char text[TS_VALUE_TEXT];
	ts_field_show(text, field, bits);
	assert_string_equal(text, expected);
}

static void values_are_shown_with_their_bits(void **state)
{
	(void)state;
	const ts_field real = {.kind = 'f', .count = 1, .bytes = 4}, whole = {.kind = 'i', .count = 1, .bytes = 4};
	const ts_field byte = {.kind = 'u', .count = 1, .bytes = 1}, word = {.kind = 'u', .count = 1, .bytes = 4};
	const ts_field wide = {.kind = 'u', .count = 1, .bytes = 8};
	static const ts_axis points = {.number = 1, .n_factors = 1, .factor = {TS_DIM_points}};
	const ts_field key = {.kind = 'u', .count = 1, .bytes = 8, .of = &points, .none = true, .distance = true};
	const ts_field pair = {.kind = 'u', .count = 1, .bytes = 8, .of = &points};
	const ts_field index = {.kind = 'u', .count = 1, .bytes = 4, .of = &points, .none = true};
	const ts_field must = {.kind = 'u', .count = 1, .bytes = 4, .of = &points};
	shows(&pair, (u64)7 << 32 | 812, "7 | 812 (00000007_0000032c)");
	shows(&real, 0x40400000u, "3 = 0x1.8p+1 (40400000)");
	shows(&real, 0x80000000u, "-0 = -0x0p+0 (80000000)");
	shows(&real, 0x7f800000u, "inf = inf (7f800000)");
	shows(&whole, 0xffffffffu, "-1 (ffffffff)");
	shows(&byte, 7, "7 (07)");
	shows(&word, 812, "812 (0000032c)");
	shows(&wide, UINT64_MAX, "18446744073709551615 (ffffffffffffffff)");
	shows(&key, TS_EMPTY, "empty");
	shows(&key, 0x406000000000032cull, "3.5 | 812 (40600000_0000032c)");
	shows(&index, TS_NONE, "none");
	shows(&must, TS_NONE, "4294967295 (ffffffff)");
}

static void fields_stand_where_the_structs_have_them(void **state)
{
	(void)state;
	ts_fields f = ts_fields_of(TS_B_points_record);
	assert_int_equal(f.n, 5);
	assert_true(f.field[0].kind == 'f' && f.field[0].count == 3 && f.field[0].offset == offsetof(ts_point, centre));
	assert_true(f.field[2].kind == 'u' && f.field[2].offset == offsetof(ts_point, piece) &&
	            ts_field_names(&f.field[2], TS_DIM_pieces) && !ts_field_names(&f.field[2], TS_DIM_points) &&
	            !ts_field_names(&f.field[0], TS_DIM_pieces));
	ts_point point = {.centre = {1, 2, 3}, .piece = 812};
	assert_true(ts_field_bits(&f.field[0], &point, 2) == 0x40400000u && ts_field_bits(&f.field[2], &point, 0) == 812);
	char name[64];
	ts_field_name(name, &f.field[0], 2);
	assert_string_equal(name, "centre[2]");
	ts_field_name(name, &f.field[2], 0);
	assert_string_equal(name, "piece");
	f = ts_fields_of(TS_B_splat_depth_index);
	assert_true(f.n == 1 && f.field[0].name[0] == 0 && f.field[0].bytes == 8 && f.field[0].none);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		u32 bytes = 0;
		f = ts_fields_of((ts_buffer_id)id);
		for (u32 i = 0; i < f.n; i++) {
			assert_int_equal(f.field[i].offset, bytes);
			bytes += f.field[i].bytes * f.field[i].count;
		}
		assert_int_equal(bytes, ts_buffer_table[id].element_bytes);
	}
}

int main(void)
{
	const struct CMUnitTest field[] = {
		cmocka_unit_test(floats_are_apart_by_their_steps),
		cmocka_unit_test(steps_are_those_of_nextafter),
		cmocka_unit_test(values_are_shown_with_their_bits),
		cmocka_unit_test(fields_stand_where_the_structs_have_them),
	};
	return cmocka_run_group_tests(field, NULL, NULL);
}
