/* Exact conversions against rint, sanitizing against its definition, elementary functions against double precision, and
 * the hash against its inverse. Strides are prime, so that every exponent meets every pattern of low bits. */
#include <float.h>
#include <stdlib.h>
#include "tests/kernels/seeded.h"

enum { FEW = 104729, MANY = 1031 };

/* x * 2^frac to the nearest, ties to even, saturated. */
static i32 fixed(f32 x, i32 frac, i32 width)
{
	if (isnan(x)) return 0;
	double limit = ldexp(1, width) - 1, y = rint(ldexp(x, frac));
	return (i32)(y > limit ? limit : y < -limit ? -limit : y);
}

static void judge_fix(u32 u, i32 frac, i32 width)
{
	f32 x = ts_u2f(u);
	if (ts_fix(x, frac, width) == fixed(x, frac, width)) return;
	print_error("ts_fix(%a, %d, %d) = %d, not %d\n", (double)x, frac, width, ts_fix(x, frac, width),
	            fixed(x, frac, width));
	fail();
}

/* Every format in use. */
static const i32 format[][2] = {{8, 23}, {8, 30}, {8, 12}, {24, 25}, {0, 23}, {16, 31}};
enum { N_FORMATS = sizeof format / sizeof format[0] };

static void fixed_point_rounds_to_the_nearest(void **state)
{
	(void)state;
	for (u32 k = 0; k < N_FORMATS; k++) {
		for (u64 u = k; u <= 0xffffffffu; u += k == 0 ? MANY : FEW) judge_fix((u32)u, format[k][0], format[k][1]);
	}
}

/* Both signs of every exponent with the mantissas at which rounding turns; the last exponent holds infinity and NaN. */
static void fixed_point_is_right_at_every_exponent(void **state)
{
	(void)state;
	for (u32 i = 0; i < 512; i++) {
		for (u32 k = 0; k < N_FORMATS; k++) {
			for (u32 b = 0; b <= 23; b++) {
				u32 one = (1u << b) & 0x7fffffu;
				judge_fix(i << 23 | one, format[k][0], format[k][1]);
				judge_fix(i << 23 | (0x7fffffu ^ one), format[k][0], format[k][1]);
				judge_fix(i << 23 | (0x7fffffu & ~((1u << b) - 1)), format[k][0], format[k][1]);
				judge_fix(i << 23 | (bits() & 0x7fffffu), format[k][0], format[k][1]);
			}
		}
	}
}

static void fixed_point_ties_go_to_even(void **state)
{
	(void)state;
	for (i32 k = -100000; k < 100000; k++) {
		f32 x = ((f32)k + 0.5f) / 256;
		assert_int_equal(ts_fix(x, 8, 23) & 1, 0);
		assert_int_equal(abs(2 * ts_fix(x, 8, 23) - (2 * k + 1)), 1);
	}
	assert_int_equal(ts_fix(INFINITY, 8, 23), 8388607);
	assert_int_equal(ts_fix(-INFINITY, 8, 23), -8388607);
	assert_int_equal(ts_fix(NAN, 8, 23), 0);
	assert_int_equal(ts_fix(-NAN, 8, 23), 0);
}

static f32 sanitized(f32 x)
{
	if (isnan(x) || fabsf(x) < ldexpf(1, -39)) return 0;
	return fabsf(x) > ldexpf(1, 62) ? copysignf(ldexpf(1, 62), x) : x;
}

static f32 flushed(f32 x) { return fabsf(x) < ldexpf(1, -100) ? 0 : x; }

static void judge_san(u32 u)
{
	f32 x = ts_u2f(u);
	assert_true(same_bits(ts_san(x), sanitized(x)));
	assert_true(same_bits(ts_san(ts_san(x)), ts_san(x)));
	if (isnan(x)) {
		assert_true(same_bits(ts_put(x), 0));
		return;
	}
	assert_true(same_bits(ts_flush(x), flushed(x)));
	assert_true(same_bits(ts_put(x), isinf(x) ? copysignf(FLT_MAX, x) : flushed(x)));
}

static void sanitizing_follows_its_definition(void **state)
{
	(void)state;
	for (u64 u = 0; u <= 0xffffffffu; u += 8191) judge_san((u32)u);
	for (u32 i = 0; i < 512; i++) {
		for (u32 m = 0; m < 3; m++) {
			judge_san(i << 23 | m);
			judge_san(i << 23 | (0x7fffffu - m));
		}
	}
}

static void conversions_to_integers_match_libm(void **state)
{
	(void)state;
	for (u64 u = 0; u <= 0xffffffffu; u += 8191) {
		f32 x = ts_u2f((u32)u);
		double t = isnan(x) ? 0 : x < -2147483648.0 ? -2147483648.0 : x > 2147483647.0 ? 2147483647.0 : (double)x;
		assert_int_equal(ts_f2i(x), (i32)trunc(t));
		assert_int_equal(ts_floor_i32(x), (i32)floor(t));
		if (fabsf(x) < 4194304) assert_true(ts_rint(x) == rintf(x));
	}
	for (i32 k = -8388607; k < 8388607; k += 2) assert_true(ts_rint((f32)k / 2) == rintf((f32)k / 2));
}

static void min_max_and_clamp_match_libm(void **state)
{
	(void)state;
	for (u32 i = 0; i < 100000; i++) {
		f32 a = ts_san(ts_u2f(bits())), b = ts_san(ts_u2f(bits())), x = ts_san(ts_u2f(bits()));
		assert_true(ts_min(a, b) == fminf(a, b) && ts_max(a, b) == fmaxf(a, b));
		assert_true(ts_clamp(x, fminf(a, b), fmaxf(a, b)) == fminf(fmaxf(x, fminf(a, b)), fmaxf(a, b)));
		assert_true(same_bits(ts_abs(a), fabsf(a)));
	}
}

/* From a float near y to the next one. */
static double ulp(double y) { return y == 0 ? ldexp(1, -149) : ldexp(1, ilogb(y) - 23); }

static void logarithm_keeps_its_bound(void **state)
{
	(void)state;
	double worst = 0;
	for (u32 u = 0x00800000u; u < 0x7f800000u; u += 211) {
		f32 x = ts_u2f(u);
		double y = log2(x);
		worst = fmax(worst, fabs(ts_log2(x) - y) / ulp(y));
	}
	assert_true(worst > 0 && worst <= 2.2);
	for (i32 k = -126; k < 128; k++) assert_true(ts_log2(ldexpf(1, k)) == (f32)k);
	const f32 outside[] = {0, -0.0f, ldexpf(1, -149), ldexpf(0.999f, -126), -1, -INFINITY, NAN};
	for (u32 i = 0; i < sizeof outside / sizeof outside[0]; i++) assert_true(ts_log2(outside[i]) == -126);
}

static void sine_and_cosine_keep_their_bound(void **state)
{
	(void)state;
	double turn = 2 * acos(-1), worst = 0;
	for (u64 u = 0; u <= 0xffffffffu; u += MANY) {
		f32 t = ts_u2f((u32)u);
		double r = fabsf(t) < 4194304 ? t - rint(t) : 0;
		worst = fmax(worst, fabs(ts_sin_turn(t) - sin(turn * r)));
		worst = fmax(worst, fabs(ts_cos_turn(t) - cos(turn * r)));
		assert_true(ts_sin_turn(-t) == -ts_sin_turn(t) && ts_cos_turn(-t) == ts_cos_turn(t));
	}
	assert_true(worst > 0 && worst <= 7.5e-8);
	for (i32 k = -64; k < 64; k++) {
		assert_true(ts_sin_turn((f32)k / 4) == (f32)lround(sin(turn * k / 4)));
		assert_true(ts_cos_turn((f32)k / 4) == (f32)lround(cos(turn * k / 4)));
	}
}

static void exponential_keeps_its_bound(void **state)
{
	(void)state;
	double worst = 0;
	for (u32 sign = 0; sign < 2; sign++) {
		for (u32 u = 0; u < 0x42b20000u; u += 211) {
			f32 x = ts_u2f(u | sign << 31);
			if (x < -87.33654f || x > 88.72283f) continue;
			double y = exp((double)x);
			worst = fmax(worst, fabs(ts_exp(x) - y) / ulp(y));
		}
	}
	assert_true(worst > 0.5 && worst <= 0.96);
	const f32 below_it[] = {-87.337f, -100, -1e30f, -INFINITY}, above_it[] = {88.723f, 100, 1e30f, INFINITY, NAN};
	for (u32 i = 0; i < 4; i++) assert_true(same_bits(ts_exp(below_it[i]), 0));
	for (u32 i = 0; i < 5; i++) assert_true(same_bits(ts_exp(above_it[i]), ts_exp(88.72283172607421875f)));
	assert_true(isfinite(ts_exp(INFINITY)) && ts_exp(INFINITY) > 3.4e38f);
	assert_true(ts_exp(0) == 1 && ts_exp(-0.0f) == 1 && ts_exp(ldexpf(1, -149)) == 1);
}

/* All quadrants; the shorter coordinate from as long as the other down to 2^-60 of it. */
static void arc_tangent_keeps_its_bound(void **state)
{
	(void)state;
	double worst = 0;
	for (u32 i = 0; i < 2000000; i++) {
		f32 x = ldexpf(1 + uniform(0, 1), -(i32)below(30)),
			y = ldexpf(1 + uniform(0, 1), -(i32)below(i % 2 == 0 ? 2 : 60));
		u32 signs = bits();
		x = (signs & 1) != 0 ? -x : x;
		y = (signs & 2) != 0 ? -y : y;
		double right = atan2((double)y, (double)x);
		worst = fmax(worst, fabs(ts_atan2(y, x) - right) / ulp(right));
		assert_true(ts_atan2(-y, x) == -ts_atan2(y, x));
	}
	assert_true(worst > 0.5 && worst <= 2.13);
	const f32 half = 1.57079637050628662109375f;
	assert_true(same_bits(ts_atan2(0, 0), 0) && ts_atan2(0, 3) == 0 && ts_atan2(3, 0) == half &&
	            ts_atan2(-3, 0) == -half);
	assert_true(ts_atan2(0, -3) == 2 * half && ts_atan2(5, 5) == half / 2 && ts_atan2(-5, 5) == -half / 2);
	assert_true(ts_atan2(ldexpf(1, -101), 1) == 0 && ts_atan2(ldexpf(1, -99), 1) == ldexpf(1, -99));
}

static u32 inverse(u32 odd)
{
	u32 x = odd;
	for (u32 i = 0; i < 5; i++) x *= 2 - odd * x;
	return x;
}

/* The steps of the generator undone one by one. */
static u32 unpcg(u32 h)
{
	u32 w = (h ^ h >> 22) * inverse(277803737u);
	u32 shift = (w >> 28) + 4, s = w;
	for (u32 known = shift; known < 32; known += shift) s = w ^ s >> shift;
	return (s - 2891336453u) * inverse(747796405u);
}

static void each_step_of_the_hash_is_undone(void **state)
{
	(void)state;
	for (u64 v = 0; v <= 0xffffffffu; v += MANY) assert_int_equal(unpcg(ts_pcg((u32)v)), (u32)v);
}

/* Uniform numbers fill [0, 1) evenly, in every stream, and streams and seeds differ. */
static void random_numbers_fill_the_unit_evenly(void **state)
{
	(void)state;
	enum { N = 1 << 16, N_BINS = 256 };
	for (u32 stream = 1; stream <= 7; stream++) {
		u32 count[N_BINS] = {0}, n_same = 0;
		double chi2 = 0;
		for (u32 i = 0; i < N; i++) {
			f32 x = ts_uniform(ts_random(i, stream, 0));
			assert_true(x >= 0 && x < 1 && x * 16777216 == floorf(x * 16777216));
			count[(u32)(x * N_BINS)]++;
			n_same += ts_random(i, stream, 0) == ts_random(i, stream + 1, 0);
			n_same += ts_random(i, stream, 0) == ts_random(i, stream, 1);
		}
		for (u32 b = 0; b < N_BINS; b++) chi2 += pow(count[b] - (double)N / N_BINS, 2) / ((double)N / N_BINS);
		assert_true(fabs(chi2 - (N_BINS - 1)) < 5 * sqrt(2.0 * (N_BINS - 1)));
		assert_true(n_same <= 2);
	}
	assert_true(ts_uniform(0xffffffffu) < 1 && ts_uniform(255) == 0 && ts_uniform(256) > 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(fixed_point_rounds_to_the_nearest), seeded_test(fixed_point_is_right_at_every_exponent),
		seeded_test(fixed_point_ties_go_to_even),       seeded_test(sanitizing_follows_its_definition),
		seeded_test(min_max_and_clamp_match_libm),      seeded_test(conversions_to_integers_match_libm),
		seeded_test(logarithm_keeps_its_bound),         seeded_test(sine_and_cosine_keep_their_bound),
		seeded_test(exponential_keeps_its_bound),       seeded_test(arc_tangent_keeps_its_bound),
		seeded_test(each_step_of_the_hash_is_undone),   seeded_test(random_numbers_fill_the_unit_evenly),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
