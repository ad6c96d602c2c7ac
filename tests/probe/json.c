/* Parts of answers: numbers with their bits, and what is said of bits that agree or differ. */
#include "probe/parts.h"
#include "tests/model/test.h"

/* Takes over the value, and requires its text. */
static void assert_json(json_t *value, const char *right)
{
	char *text = json_dumps(value, JSON_COMPACT | JSON_ENCODE_ANY | JSON_REAL_PRECISION(9));
	assert_non_null(text);
	assert_string_equal(text, right);
	free(text);
	json_decref(value);
}

static void numbers_have_their_bits(void **state)
{
	(void)state;
	const ts_v3 v = ts_v3_make(1.5f, -0.0f, ts_u2f(0x7fc00000));
	assert_json(ts_probe_int(4294967296), "4294967296");
	assert_json(ts_probe_pair(7, 4000000000), "[7,4000000000]");
	assert_json(ts_probe_real(-2.25f), "-2.25");
	assert_json(ts_probe_real(ts_u2f(0x7f7fffff)), "3.40282347e38");
	assert_json(ts_probe_real(ts_u2f(0xff800000)), "\"not a finite number\"");
	assert_json(ts_probe_bits(1.5f), "{\"value\":1.5,\"bits\":\"3fc00000\"}");
	assert_json(ts_probe_v3(v), "[1.5,-0.0,\"not a finite number\"]");
	assert_json(ts_probe_v3_bits(v), "{\"value\":[1.5,-0.0,\"not a finite number\"],"
	                                 "\"bits\":[\"3fc00000\",\"80000000\",\"7fc00000\"]}");
	assert_json(ts_probe_face_name(12, 3), "\"12.-Y\"");
}

static void a_margin_is_told_in_steps(void **state)
{
	(void)state;
	ts_probe p = {.failed = false};
	json_t *o = json_object();
	ts_probe_put_margin(&p, o, 1.0f, 1.5f);
	assert_json(o, "{\"behind\":0.5,\"behind_ulps\":4194304}");
	assert_false(p.failed);
}

/* As many bits are shown as there are numbers, but four; none where all agree. */
static void checks_tell_the_bits_that_differ(void **state)
{
	(void)state;
	ts_probe p = {.failed = false};
	const f32 computed[5] = {1, 2, 3, 4, 5}, held[5] = {1, 2, -3, 4, 6};
	static const struct {
		u32 n;
		const char *right;
	} rows[] = {
		{1, "{\"check\":\"bits agree with image.radiance\"}"},
		{2, "{\"check\":\"bits agree with image.radiance\"}"},
		{3, "{\"check\":\"bits differ from image.radiance, which holds 3f800000 40000000 c0400000\"}"},
		{5, "{\"check\":\"bits differ from image.radiance, which holds 3f800000 40000000 c0400000 40800000\"}"},
	};
	for (u32 row = 0; row < sizeof rows / sizeof *rows; row++) {
		json_t *o = json_object();
		ts_probe_put_check(&p, o, TS_B_image_radiance, computed, held, rows[row].n);
		assert_json(o, rows[row].right);
	}
	const f32 zero[2] = {0.0f, -0.0f};
	json_t *o = json_object();
	ts_probe_put_check(&p, o, TS_B_image_radiance, zero, zero + 1, 1);
	assert_json(o, "{\"check\":\"bits differ from image.radiance, which holds 80000000\"}");
}

/* The first field that differs, with the bits that the buffer holds; of a scalar there is no name. */
static void checks_of_records_name_the_field(void **state)
{
	(void)state;
	ts_probe p = {.failed = false};
	p.fields[TS_B_points_record] = ts_fields_of(TS_B_points_record);
	p.fields[TS_B_cull_keep] = ts_fields_of(TS_B_cull_keep);
	const ts_point point = {.centre = {0, 1, 2}, .length = 0.5f, .piece = 7};
	ts_point held = point;
	json_t *o = json_object();
	ts_probe_put_record_check(&p, o, TS_B_points_record, &point, &held);
	assert_json(o, "{\"check\":\"bits agree with points.record\"}");
	held.piece = 9;
	o = json_object();
	ts_probe_put_record_check(&p, o, TS_B_points_record, &point, &held);
	assert_json(o, "{\"check\":\"bits differ from points.record, which holds in piece 9 (00000009)\"}");
	held.centre[1] = -1;
	o = json_object();
	ts_probe_put_record_check(&p, o, TS_B_points_record, &point, &held);
	assert_json(o, "{\"check\":\"bits differ from points.record, which holds in centre[1] -1 = -0x1p+0 (bf800000)\"}");
	const u32 keep = 1, drop = 0;
	o = json_object();
	ts_probe_put_record_check(&p, o, TS_B_cull_keep, &keep, &drop);
	assert_json(o, "{\"check\":\"bits differ from cull.keep, which holds 0 (00000000)\"}");
}

static void checks_of_keys_tell_both_halves(void **state)
{
	(void)state;
	ts_probe p = {.failed = false};
	const u64 key = 0x3f80000000000007;
	static const struct {
		u64 held;
		const char *right;
	} rows[] = {
		{0x3f80000000000007, "{\"check\":\"bits agree with splat.depth_index\"}"},
		{UINT64_MAX, "{\"check\":\"bits differ from splat.depth_index, which is empty\"}"},
		{0x400000000000000c, "{\"check\":\"bits differ from splat.depth_index, which holds 40000000_0000000c: "
	                         "depth 2, index 12\"}"},
	};
	for (u32 row = 0; row < sizeof rows / sizeof *rows; row++) {
		json_t *o = json_object();
		ts_probe_put_key_check(&p, o, TS_B_splat_depth_index, key, rows[row].held);
		assert_json(o, rows[row].right);
	}
}

/* The last bit counts; zeros are stored as one. */
static void sums_must_agree_to_the_last_bit(void **state)
{
	(void)state;
	ts_probe p = {.failed = false};
	json_t *same = json_object(), *other = json_object();
	ts_probe_put_sum(&p, same, ts_v3_make(1, 2, 0), ts_v3_make(1, 2, -0.0f));
	assert_json(same, "{\"sum\":\"terms add up to the bits of the total\"}");
	ts_probe_put_sum(&p, other, ts_v3_make(1, 2, 3), ts_v3_make(1, 2, ts_u2f(ts_f2u(3) + 1)));
	assert_json(other, "{\"sum\":\"terms do not add up to the total\"}");
}

/* A value that could not be made leaves the answer incomplete, which is remembered. */
static void a_missing_value_is_remembered(void **state)
{
	(void)state;
	ts_probe put = {.failed = false}, append = {.failed = false};
	json_t *o = json_object(), *list = json_array();
	ts_probe_put(&put, o, "a", json_integer(1));
	ts_probe_append(&append, list, json_integer(1));
	assert_true(!put.failed && !append.failed);
	ts_probe_put(&put, o, "b", NULL);
	ts_probe_append(&append, list, NULL);
	assert_true(put.failed && append.failed);
	assert_json(o, "{\"a\":1}");
	assert_json(list, "[1]");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(numbers_have_their_bits),          cmocka_unit_test(a_margin_is_told_in_steps),
		cmocka_unit_test(checks_tell_the_bits_that_differ), cmocka_unit_test(checks_of_records_name_the_field),
		cmocka_unit_test(checks_of_keys_tell_both_halves),  cmocka_unit_test(sums_must_agree_to_the_last_bit),
		cmocka_unit_test(a_missing_value_is_remembered),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
