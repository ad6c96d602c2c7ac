/* Every primitive that methods share against an independent truth: rounded once from wider arithmetic, exact in
 * integers, or within the error that the contract states. And every fault that a port may have is found and named, of
 * all. */
#include "kernels/vectors/vectors.h"
#include "model/digest.h"
#include "tests/model/test.h"
#include "tests/vectors/truth.h"

static u32 in[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];
static _Alignas(8) u32 out[TS_VECTOR_ITEMS * TS_VECTOR_WORDS], found[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];

/* The sign of a zero that a sum of products gives is no part of a place on a cube. */
static bool same(const ts_vector *v, u32 a, u32 b)
{
	return a == b || (strcmp(v->name, "cube_place") == 0 && ts_u2f(a) == ts_u2f(b));
}

static void exact_primitives_match_wider_arithmetic(void **state)
{
	(void)state;
	for (u32 t = 0; t < N_EXACT; t++) {
		const ts_vector *v = ts_vectors_find(exact[t].name);
		assert_non_null(v);
		u32 words = ts_vector_out_words(v), n_wrong = 0;
		ts_vector_make(v, in, out);
		for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
			u32 right[TS_VECTOR_WORDS];
			exact[t].right(right, in + (size_t)i * ts_vector_in_words(v));
			for (u32 k = 0; k < words; k++) {
				u32 ours = out[(size_t)i * words + k];
				if (same(v, ours, right[k])) continue;
				if (n_wrong++ == 0)
					print_error("%s, item %u, word %u: %08x, not %08x\n", v->name, i, k, ours, right[k]);
			}
		}
		assert_int_equal(n_wrong, 0);
	}
}

static double ulp(double y) { return y == 0 ? 0x1p-149 : ldexp(1, ilogb(y) - 23); }

/* What the contract states of the elementary functions. */
static void elementary_functions_keep_their_bounds(void **state)
{
	(void)state;
	double turn = 2 * acos(-1);
	ts_vector_make(ts_vectors_find("log2"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		f32 x = ts_u2f(in[i]), y = ts_u2f(out[i]);
		if (isinf(x) && x > 0) continue;
		double right = x >= FLT_MIN ? log2((double)x) : -126;
		assert_true(fabs(y - right) <= 2.2 * ulp(right));
	}
	for (u32 k = 0; k < 2; k++) {
		ts_vector_make(ts_vectors_find(k == 0 ? "sin_turn" : "cos_turn"), in, out);
		for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
			f32 t = ts_u2f(in[i]);
			double r = fabsf(t) < 0x1p22f ? t - rint(t) : 0;
			assert_true(fabs(ts_u2f(out[i]) - (k == 0 ? sin(turn * r) : cos(turn * r))) <= 7.5e-8);
		}
	}
	ts_vector_make(ts_vectors_find("exp"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		f32 x = ts_u2f(in[i]), y = ts_u2f(out[i]);
		double right = exp((double)x);
		if (x < -87.33654f) assert_int_equal(out[i], 0);
		if (x > 88.72283f) assert_true(y > 3.4e38f && isfinite(y));
		if (x >= -87.33654f && x <= 88.72283f) assert_true(fabs(y - right) <= 0.96 * ulp(right));
	}
	ts_vector_make(ts_vectors_find("atan2"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		double y = ts_u2f(in[2 * i]), x = ts_u2f(in[2 * i + 1]), right = atan2(y, x);
		if (x > 0 && fabs(y) < x * 0x1p-99) right = ts_u2f(out[i]) == 0 ? 0 : right;
		assert_true(fabs(ts_u2f(out[i]) - right) <= 2.13 * ulp(right));
	}
	ts_vector_make(ts_vectors_find("texture_lod"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		const u32 *row = in + (size_t)i * 5;
		double f = ts_row_f32(row, 2), k = (double)row[0] * row[1] * f * f * ts_row_f32(row, 3) / ts_row_f32(row, 4);
		double right = fmin(128 * log2(fmax(1, k)), 4095);
		assert_true(fabs(out[i] - right) <= 0.501);
	}
}

/* Nothing that methods share is left without a truth. */
static void every_shared_primitive_has_a_truth(void **state)
{
	(void)state;
	assert_int_equal(TS_N_vectors, N_EXACT + 6);
	assert_null(ts_vectors_at(ts_vectors_count()));
	assert_null(ts_vectors_find("tan"));
	for (u32 i = 0; i < ts_vectors_count(); i++) {
		const ts_vector *v = ts_vectors_at(i);
		assert_ptr_equal(ts_vectors_find(v->name), v);
		assert_true(strspn(v->name, "abcdefghijklmnopqrstuvwxyz0123456789_") == strlen(v->name));
		assert_true(v->rule[0] != 0 && v->doc[0] != 0 && v->in[0].name != NULL);
		assert_in_range(ts_vector_in_words(v), 1, TS_VECTOR_WORDS);
		assert_in_range(ts_vector_out_words(v), 1, TS_VECTOR_WORDS);
	}
}

static bool in_range(const ts_vector_column *c, const u32 *at)
{
	u32 m = at[0] & 0x7fffffffu;
	i64 x = c->type == TS_VECTOR_I64   ? ts_row_i64(at, 0)
	        : c->type == TS_VECTOR_I32 ? (i64)ts_row_i32(at, 0)
	                                   : (i64)at[0];
	if (c->type == TS_VECTOR_U64) return true;
	if (c->type != TS_VECTOR_F32) return x >= c->low && x <= c->high;
	if (m == 0) return c->low == 0 || at[0] == 0;
	return m >> 23 >= c->low && m >> 23 <= c->high;
}

static void assert_finite(const ts_vector *v)
{
	const u32 *at = out;
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		for (const ts_vector_column *c = v->out; c->name != NULL; c++) {
			for (u32 k = 0; k < c->count && c->type == TS_VECTOR_F32; k++) assert_true(isfinite(ts_u2f(at[k])));
			at += c->count * ts_vector_type_words(c->type);
		}
	}
}

static void inputs_stay_within_their_ranges(void **state)
{
	(void)state;
	u32 n_wrong = 0;
	for (u32 t = 0; t < ts_vectors_count(); t++) {
		const ts_vector *v = ts_vectors_at(t);
		u32 n_beyond = 0;
		ts_vector_make(v, in, out);
		const u32 *at = in;
		for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
			for (const ts_vector_column *c = v->in; c->name != NULL; c++) {
				for (u32 k = 0; k < c->count; k++, at += ts_vector_type_words(c->type)) {
					if (in_range(c, at) || n_beyond++ > 0) continue;
					print_error("%s, item %u, %s: %08x\n", v->name, i, c->name, at[0]);
				}
			}
		}
		n_wrong += n_beyond;
		assert_finite(v);
	}
	assert_int_equal(n_wrong, 0);
}

/* Every bit of every file: a change of this digest is a change of the contract, TS_CONTRACT_VERSION. */
static void the_digest_of_all_bits_stays(void **state)
{
	(void)state;
	ts_digest digest;
	char hex[TS_DIGEST_BYTES];
	ts_digest_begin(&digest);
	for (u32 t = 0; t < ts_vectors_count(); t++) {
		const ts_vector *v = ts_vectors_at(t);
		ts_vector_make(v, in, out);
		ts_digest_add(&digest, in, ts_vector_in_words(v) * TS_VECTOR_ITEMS * sizeof *in);
		ts_digest_add(&digest, out, ts_vector_out_words(v) * TS_VECTOR_ITEMS * sizeof *out);
	}
	ts_digest_end(&digest, hex);
	assert_string_equal(hex, "27d0f88e1ee98ee13f27142ea49843a7a4b55b3bab1da91d73248a9266d386de");
}

static void compute(ts_vector_item *item, const ts_vector *v)
{
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		item(found + (size_t)i * ts_vector_out_words(v), in + (size_t)i * ts_vector_in_words(v));
	}
}

static const char *name_of(ts_vector_fault fault) { return ts_vector_fault_table[fault].name; }

/* A port with that fault in all of a primitive. */
static void every_fault_is_found_and_named(void **state)
{
	(void)state;
	for (u32 t = 0; t < ts_vectors_count(); t++) {
		const ts_vector *v = ts_vectors_at(t);
		ts_vector_make(v, in, out);
		assert_int_equal(ts_vector_judge(v, in, out, out).n_wrong, 0);
		for (const ts_vector_variant *variant = v->variants; variant->item != NULL; variant++) {
			compute(variant->item, v);
			ts_vector_verdict r = ts_vector_judge(v, in, out, found);
			if (r.n_wrong < 10) print_error("%s: only %u tell of %s\n", v->name, r.n_wrong, name_of(variant->fault));
			assert_true(r.n_wrong >= 10);
			assert_int_equal(r.n_explained[variant->fault], r.n_wrong);
			assert_int_equal(r.n_explained[r.fault], r.n_wrong);
			assert_int_equal(r.first_fault, r.fault);
		}
	}
}

static ts_vector_verdict judge_by(const char *name, ts_vector_item *item)
{
	const ts_vector *v = ts_vectors_find(name);
	ts_vector_make(v, in, out);
	compute(item, v);
	return ts_vector_judge(v, in, out, found);
}

/* The three of the contract's own list and two of halves, as a port would compute them. */
static void faults_of_the_contract_are_named(void **state)
{
	(void)state;
	assert_int_equal(judge_by("muladd", t_fused).fault, TS_FAULT_FMA);
	assert_int_equal(judge_by("div", t_scaled).fault, TS_FAULT_RECIPROCAL);
	ts_vector_verdict r = judge_by("muladd", t_half_wrong);
	assert_int_equal(r.fault, TS_FAULT_FMA);
	assert_in_range(r.n_explained[TS_FAULT_FMA], 20, r.n_wrong - 1000);
	r = judge_by("to_half", t_half_cut);
	assert_int_equal(r.fault, TS_FAULT_TRUNCATE);
	assert_int_equal(r.n_explained[TS_FAULT_TRUNCATE], r.n_wrong);
	r = judge_by("to_half", t_half_flushed);
	assert_int_equal(r.fault, TS_FAULT_FLUSH_HALF);
	assert_int_equal(r.n_explained[TS_FAULT_FLUSH_HALF], r.n_wrong);
	for (u32 f = 0; f < TS_N_FAULTS; f++) {
		assert_true(ts_vector_fault_table[f].name != NULL && ts_vector_fault_table[f].remedy[0] != 0);
	}
}

/* Rows of half: zeros of both signs from tiny floats, ties to even down and up of subnormal and normal halves, the
 * largest half from below and above, and what is beyond it. */
static void halves_meet_every_kind_of_rounding(void **state)
{
	(void)state;
	u32 n_zero[2] = {0}, n_tie[2][2] = {{0}}, n_largest[2] = {0}, n_infinite[2] = {0};
	ts_vector_make(ts_vectors_find("to_half"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		double x = fabs((double)ts_u2f(in[i])), y = fabs((double)ts_u2f(out[i]));
		bool normal = x >= 0x1p-14;
		double step = ldexp(1, normal ? ilogb(x) - 10 : -24);
		if (x > 0 && x < FLT_MIN) n_zero[out[i] >> 31] += y == 0;
		if (fabs(x - y) == step / 2) n_tie[normal][y > x]++;
		if (y == 65504 && x != y) n_largest[x > y]++;
		if (isinf(y)) n_infinite[x > 65520]++;
	}
	for (u32 k = 0; k < 2; k++) {
		assert_true(n_zero[k] >= 3 && n_tie[k][0] >= 100 && n_tie[k][1] >= 100 && n_largest[k] >= 2 &&
		            n_infinite[k] >= 1);
	}
}

#if defined(__SSE__)
#include <xmmintrin.h>
static void compute_flushing(const ts_vector *v)
{
	unsigned before = _mm_getcsr();
	_mm_setcsr(before | 0x8040);
	compute(v->item, v);
	_mm_setcsr(before);
}

static bool flushes(const ts_vector *v)
{
	for (const ts_vector_variant *variant = v->variants; variant->item != NULL; variant++) {
		if (variant->fault == TS_FAULT_FLUSH) return true;
	}
	return false;
}

/* A processor that flushes is named, and only the bare operations tell: the contract's functions do not depend on
 * it. */
static void a_flushing_processor_is_named(void **state)
{
	(void)state;
	for (u32 t = 0; t < ts_vectors_count(); t++) {
		const ts_vector *v = ts_vectors_at(t);
		ts_vector_make(v, in, out);
		compute_flushing(v);
		ts_vector_verdict r = ts_vector_judge(v, in, out, found);
		u32 n_flushed = r.n_explained[TS_FAULT_FLUSH];
		if ((r.n_wrong != 0) != flushes(v) || r.n_wrong != n_flushed)
			print_error("%s: %u differ\n", v->name, r.n_wrong);
		assert_int_equal(r.n_wrong != 0, flushes(v));
		assert_int_equal(r.n_wrong, n_flushed);
		if (r.n_wrong != 0) assert_int_equal(r.fault, TS_FAULT_FLUSH);
	}
}
#else
static void a_flushing_processor_is_named(void **state)
{
	(void)state;
	skip();
}
#endif

/* One bit of one item of every primitive. */
static void one_wrong_bit_is_found(void **state)
{
	(void)state;
	for (u32 t = 0; t < ts_vectors_count(); t++) {
		const ts_vector *v = ts_vectors_at(t);
		u32 words = ts_vector_out_words(v), item = (t * 977 + 5) % TS_VECTOR_ITEMS, word = t % words;
		ts_vector_make(v, in, out);
		memcpy(found, out, (size_t)words * TS_VECTOR_ITEMS * sizeof *out);
		found[(size_t)item * words + word] ^= 1u << t % 32;
		ts_vector_verdict r = ts_vector_judge(v, in, out, found);
		assert_int_equal(r.n_wrong, 1);
		assert_int_equal(r.first, item);
		ts_vector_spot spot = ts_vector_out_spot(v, r.first_element);
		assert_in_range(word - spot.word, 0, ts_vector_type_words(spot.column->type) - 1);
	}
}

static void floats_are_apart_by_their_steps(void **state)
{
	(void)state;
	assert_int_equal(ts_vector_ulps(0x3f800000, 0x3f800001), 1);
	assert_int_equal(ts_vector_ulps(0x3f800001, 0x3f7fffff), -2);
	assert_int_equal(ts_vector_ulps(0, 0x80000000), -1);
	assert_int_equal(ts_vector_ulps(0x80000001, 1), 3);
	assert_int_equal(ts_vector_ulps(0xff7fffff, 0x7f7fffff), 2 * 0x7f7fffffll + 1);
}

static void dtypes_and_shapes_are_described(void **state)
{
	(void)state;
	char descr[TS_VECTOR_DESCR];
	u64 shape[TS_MAX_DIMS];
	ts_vector_in_descr(descr, ts_vectors_find("texture_bilinear"));
	assert_string_equal(descr, "[('texels', '<u8', (4,)), ('uv', '<f4', (2,)), ('wrap', '<u4', (2,))]");
	ts_vector_in_descr(descr, ts_vectors_find("fix"));
	assert_string_equal(descr, "[('x', '<f4'), ('frac', '<i4'), ('bits', '<i4')]");
	ts_vector_out_descr(descr, ts_vectors_find("edge"));
	assert_string_equal(descr, "'<i8'");
	assert_int_equal(ts_vector_out_shape(shape, ts_vectors_find("edge")), 1);
	assert_int_equal(ts_vector_out_shape(shape, ts_vectors_find("cross")), 2);
	assert_true(shape[0] == TS_VECTOR_ITEMS && shape[1] == 3);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(exact_primitives_match_wider_arithmetic),
		cmocka_unit_test(elementary_functions_keep_their_bounds),
		cmocka_unit_test(every_shared_primitive_has_a_truth),
		cmocka_unit_test(inputs_stay_within_their_ranges),
		cmocka_unit_test(the_digest_of_all_bits_stays),
		cmocka_unit_test(every_fault_is_found_and_named),
		cmocka_unit_test(faults_of_the_contract_are_named),
		cmocka_unit_test(halves_meet_every_kind_of_rounding),
		cmocka_unit_test(a_flushing_processor_is_named),
		cmocka_unit_test(one_wrong_bit_is_found),
		cmocka_unit_test(floats_are_apart_by_their_steps),
		cmocka_unit_test(dtypes_and_shapes_are_described),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
