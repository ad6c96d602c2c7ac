/* The composites of points against their formulas in double precision. */
#include <float.h>
#include "kernels/points/composites.h"
#include "tests/vectors/composites.h"

/* Along the shortest line from the triangle's closest point to the eye that does not go through the ball's middle, by
 * chords: what METHODS 2 says. */
static judgement path_length(const u32 *in, const u32 *out)
{
	double3 eye = d3_row(in, 0), centre = d3_row(in, 3), a = d3_row(in, 7), b = d3_row(in, 10), c = d3_row(in, 13);
	double radius = ts_row_f32(in, 6), way = ts_row_f32(out, 0), error = 20 * PLACE_ERROR;
	double3 nearest = on_triangle(eye, a, b, c), t = on_triangle(centre, a, b, c), near, cp;
	if (is_near(d3_distance(eye, centre), radius, 1e-5) || fatness(a, b, c) < 0.1) return NOT_JUDGED;
	if (d3_distance(eye, centre) < radius) return right_if(is_near(way, d3_distance(eye, nearest), error));
	if (in[16] != 0) return NOT_JUDGED;
	for (u32 step = 0; step < 2; step++) {
		near = on_segment(centre, t, eye);
		double d = d3_distance(near, centre);
		if (is_near(d, radius, 0.01 * (1 + radius)) || d < 0.05 * radius || d < 0.01) return NOT_JUDGED;
		if (d <= radius && step == 1) return right_if(is_near(way, d3_distance(eye, t), error));
		cp = d <= radius ? near : d3_mad(centre, d3_sub(near, centre), radius / d);
		if (step == 0) t = on_triangle(cp, a, b, c);
	}
	return right_if(is_near(way, d3_distance(eye, cp) + d3_distance(cp, t), error));
}

static judgement ball_spread(const u32 *in, const u32 *out)
{
	double r = ts_row_f32(in, 0), e = fmax(ts_row_f32(in, 1) - r, 0), t = fmax(ts_row_f32(in, 2) - r, 0);
	double right = fmin(2 * e * t / r, (double)FLT_MAX);
	return right_if(is_near(ts_row_f32(out, 0), right, 1e-5 * right + 1e-4 / r));
}

/* By neither the paper's path nor the ball's curve: rho f over the way, at most half the cube's n over the distance. */
static judgement eye_density(const u32 *in, const u32 *out)
{
	double3 centre = d3_row(in, 0), a = d3_row(in, 39), b = d3_row(in, 42), c = d3_row(in, 45);
	double s = ts_row_f32(out, 0), least = (double)ts_row_f32(in, 3) / 1024;
	double distance = d3_distance(on_triangle(centre, a, b, c), centre);
	double need = in[7] * 0.5 / fmax(distance, least);
	if (in[32] == 0) return right_if(s == 0 && out[1] == 0);
	if (fatness(a, b, c) < 0.1 || distance < 0.1) return NOT_JUDGED;
	if (out[1] != 0) return right_if(in[36] != 0 && is_near(s, need, 1e-2 * need));
	return right_if((s > 0) == (ts_row_f32(in, 34) > 0) && (in[36] == 0 || s <= need * 1.01));
}

/* VIR's rate and the orthographic ones; what is watertight is at least what is exact needs no judge here. */
static judgement view_density(const u32 *in, const u32 *out)
{
	double focal = ts_row_f32(in, 3), s = ts_row_f32(out, 0), x = ts_row_f32(in, 16), y = ts_row_f32(in, 17);
	double3 a = d3_row(in, 27), b = d3_row(in, 30), c = d3_row(in, 33), eye = d3_row(in, 0);
	double3 n = d3_cross(d3_sub(b, a), d3_sub(c, a));
	u32 rate = in[26];
	if (in[24] == 0) return right_if(s == 0);
	if (in[20] != 0 && rate == TS_RATE_VIR) return right_if(s == focal);
	if (fatness(a, b, c) < 0.1) return NOT_JUDGED;
	if (in[20] != 0 && rate == TS_RATE_WATERTIGHT) return right_if(s >= focal * sqrt(2) && s <= focal * 3);
	if (in[20] != 0) {
		double right = focal * sqrt(fmax(fabs(d3_dot(d3_unit(n), d3_row(in, 12))), 0.001));
		return right_if(is_near(s, right, 1e-3 * right));
	}
	if (rate != TS_RATE_VIR) return right_if(s >= 0);
	double d = fmax(d3_distance(on_triangle(eye, a, b, c), eye), ts_row_f32(in, 15));
	double right = focal * sqrt(1 + fmax(x, y) * fmax(x, y)) / d;
	return d < 0.1 ? NOT_JUDGED : right_if(is_near(s, right, 1e-2 * right));
}

/* PCG-RXS-M-XS, in 64 bits. */
static u32 hash(u32 v)
{
	u64 state = (v * 747796405ull + 2891336453ull) & 0xffffffff;
	u64 word = ((state >> (4 + (state >> 28))) ^ state) * 277803737ull & 0xffffffff;
	return (u32)(word >> 22 ^ word);
}

static judgement cull_chance(const u32 *in, const u32 *out)
{
	u32 id = in[7] == 1 ? in[3] : in[3] ^ hash(in[7]);
	return right_if(out[0] == hash(id ^ hash(1 ^ hash(in[12]))) >> 8);
}

/* The image of a point before a ts_view. */
static void project(const u32 *view, double3 p, double at[3])
{
	double3 d = d3_sub(p, d3_row(view, 0));
	at[2] = -d3_dot(d3_row(view, 12), d);
	at[0] = view[7] * 0.5 + ts_row_f32(view, 3) * d3_dot(d3_row(view, 4), d) / at[2];
	at[1] = view[11] * 0.5 - ts_row_f32(view, 3) * d3_dot(d3_row(view, 8), d) / at[2];
}

static judgement splat_box(const u32 *in, const u32 *out)
{
	double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL}, half = 0.5 * ts_row_f32(in, 25), at[3];
	double nearest = HUGE_VAL;
	const i32 *box = (const i32 *)(const void *)out;
	for (u32 k = 0; k < 4; k++) {
		double3 p = d3_mad(d3_row(in, 16), d3_row(in, 19), k % 2 != 0 ? half : -half);
		project(in, d3_mad(p, d3_row(in, 22), k / 2 != 0 ? half : -half), at);
		if (at[2] < ts_row_f32(in, 15) + 0.5) return NOT_JUDGED;
		for (u32 i = 0; i < 2; i++) low[i] = fmin(low[i], at[i]), high[i] = fmax(high[i], at[i]);
		nearest = fmin(nearest, at[2]);
	}
	double inset = in[27] != 0 ? 0 : fmax(127.0 / 256 - ts_row_f32(in, 3) * (double)ts_row_f32(in, 26) / nearest, 0);
	for (u32 i = 0; i < 2; i++) {
		low[i] += inset;
		high[i] -= inset;
		double last = in[7 + 4 * i] - 1.0, slack = 0.02 + 1e-5 * fabs(low[i]) + 1e-5 * fabs(high[i]);
		double first = fmax(floor(low[i] - slack), 0), end = fmin(floor(high[i] + slack), last);
		if (box[i] < first || box[2 + i] > end) return WRONG;
		if (box[i] > fmax(floor(low[i] + slack), 0) || box[2 + i] < fmin(floor(high[i] - slack), last)) return WRONG;
	}
	return RIGHT;
}

static judgement plane_distance(const u32 *in, const u32 *out)
{
	double3 n = d3_row(in, 16), eye = d3_row(in, 0), d = d3_scale(d3_row(in, 12), -(double)ts_row_f32(in, 3));
	double x = (i32)in[24] + 0.5 - in[7] * 0.5, y = in[11] * 0.5 - ((i32)in[25] + 0.5);
	d = d3_unit(d3_mad(d3_mad(d, d3_row(in, 4), x), d3_row(in, 8), y));
	double along = d3_dot(n, d), own = ts_row_f32(in, 22), length = ts_row_f32(in, 23);
	double met = d3_dot(n, d3_sub(d3_row(in, 19), eye)) / along;
	if (fabs(along) < 0.01 || fabs(met) < 1e-3) return NOT_JUDGED;
	double right = met > 0 ? fmin(fmax(met, own - length), own + length) : own;
	return right_if(is_near(ts_row_f32(out, 0), right, 1e-3 * (1 + fabs(right))));
}

static double3 mirrored(double3 i, double3 n) { return d3_unit(d3_mad(i, n, -2 * d3_dot(i, n))); }

static void offset(u32 k, double o[2])
{
	for (u32 i = 0; i < 2; i++) o[i] = (ts_sample_offset[k][i] + 0.5) / 128;
}

static judgement sample_ray(const u32 *in, const u32 *out)
{
	double o[2];
	offset(in[27], o);
	double3 p = d3_mad(d3_mad(d3_row(in, 0), d3_row(in, 8), o[0]), d3_row(in, 12), o[1]);
	double3 n = d3_mad(d3_mad(d3_row(in, 4), d3_row(in, 16), o[0]), d3_row(in, 20), o[1]);
	double3 way = d3_sub(p, d3_row(in, 24));
	if (d3_distance(d3_row(out, 0), p) > 2e-5) return WRONG;
	if (d3_length(n) < 0.1 || d3_length(way) < 0.1) return NOT_JUDGED;
	return right_if(d3_distance(d3_row(out, 3), mirrored(d3_unit(way), d3_unit(n))) <= 1e-3);
}

static judgement bounce_direction(const u32 *in, const u32 *out)
{
	double o[2], spread = ts_row_f32(in, 15);
	offset(in[16], o);
	double3 n = d3_mad(d3_mad(d3_row(in, 3), d3_row(in, 6), o[0] * spread), d3_row(in, 9), o[1] * spread);
	double3 way = d3_sub(d3_row(in, 0), d3_row(in, 12));
	if (d3_length(way) < 0.1) return NOT_JUDGED;
	return right_if(d3_distance(d3_row(out, 0), mirrored(d3_unit(way), d3_unit(n))) <= 1e-4);
}

static judgement depth_code(const u32 *in, const u32 *out)
{
	double steps = 8191 * log2(fmax((double)ts_row_f32(in, 0) / ts_row_f32(in, 1), 1)) / 20;
	bool between = fabs(steps - rint(steps)) > 0.01;
	u32 code = (u32)fmin(floor(steps), 8190);
	return right_if(between ? out[0] == code : out[0] + 1 >= code && out[0] <= code + 1);
}

static judgement colour_code(const u32 *in, const u32 *out)
{
	static const u32 shift[3] = {13, 6, 0}, most[3] = {63, 127, 63};
	for (u32 k = 0; k < 3; k++) {
		double shown = fmin(fmax((double)ts_row_f32(in, k) * ts_row_f32(in, 3), 0), 1);
		if (!is_near(out[0] >> shift[k] & most[k], sqrt(shown) * most[k], 0.5001)) return WRONG;
	}
	return right_if(out[0] >> 19 == 0);
}

/* Decoded, each channel within half a step; steps are no wider than the greatest channel needs. */
static judgement shared_code(const u32 *in, const u32 *out)
{
	double step = ldexp(1, (int)(out[0] >> 27) - 24), most = 0;
	for (u32 k = 0; k < 3; k++) {
		double channel = fmin(fmax(ts_row_f32(in, k), 0), 65280);
		if (!is_near((out[0] >> 9 * k & 511) * step, channel, 0.5001 * step)) return WRONG;
		most = fmax(most, channel);
	}
	return right_if(out[0] >> 27 == 0 || most >= 255 * step);
}

static void composites_match_double_precision(void **state)
{
	(void)state;
	static const composite composites[] = {TS_LIST_points_composites(COMPOSITE)};
	judge_all(composites, TS_N_points_composites);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(composites_match_double_precision)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
