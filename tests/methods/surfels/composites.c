/* The composites of surfels against rays and planes in double precision. */
#include "kernels/surfels/composites.h"
#include "kernels/surfels/surfel_setup.h"
#include "tests/vectors/composites.h"

/* Where the ray through the middle of a pixel near the centre meets the ellipse's plane, in its axes; and its depth. */
static judgement disc(const u32 *in, const u32 *out)
{
	const f32 *d = (const f32 *)(const void *)out;
	double3 eye = d3_row(in, 0), right = d3_row(in, 4), up = d3_row(in, 8), back = d3_row(in, 12);
	double3 centre = d3_row(in, 24), u = d3_row(in, 27), v = d3_row(in, 30), n = d3_cross(u, v);
	double focal = ts_row_f32(in, 3), x = 0.5 + d[2] - 0.3, y = 0.5 + d[3] + 0.2;
	bool parallel = in[16] != 0, flat = (out[11] & TS_DISC_FLAT) != 0, crosses = (out[11] & TS_DISC_CROSSES) != 0;
	double3 to_eye = parallel ? back : d3_sub(eye, centre);
	double facing = d3_dot(d3_unit(n), d3_unit(to_eye));
	if (fabs(facing) > 1e-5 && (facing < 0) != (out[24] == TS_DISC_TURNED)) return WRONG;
	if (out[24] != TS_DISC_DRAWN) return right_if((i32)out[14] < (i32)out[12] && d[10] == 0);
	if (flat || crosses || facing < 0.05 || d3_length(u) * focal > 1e4) return NOT_JUDGED;
	x += (i32)out[0], y += (i32)out[1];
	double i = (x - in[7] * 0.5) / focal, j = (in[11] * 0.5 - y) / focal;
	double3 aside = d3_mad(d3_scale(right, i), up, j), from = parallel ? d3_add(eye, aside) : eye;
	double3 way = parallel ? d3_scale(back, -1) : d3_sub(aside, back);
	double t = d3_dot(n, d3_sub(centre, from)) / d3_dot(n, way);
	double3 at = d3_sub(d3_mad(from, way, t), centre);
	double a = d3_dot(at, u) / d3_dot(u, u), b = d3_dot(at, v) / d3_dot(v, v);
	double dx = x - ((i32)out[0] + 0.5 + d[2]), dy = y - ((i32)out[1] + 0.5 + d[3]);
	double tilt = d[8] * dx + d[9] * dy, divisor = parallel ? 1 : 1 + tilt;
	if (divisor < 0.1 || fabs(tilt) > 2) return NOT_JUDGED;
	double found_a = (d[4] * dx + d[5] * dy) / divisor, found_b = (d[6] * dx + d[7] * dy) / divisor;
	double z = parallel ? d[10] * (1 - tilt) : d[10] / divisor, size = fmin(d3_length(u), d3_length(v));
	double error = (1e-5 + 1e-4 * (d3_length(centre) + d3_length(eye) + fabs(t)) / size) / facing * 0.1;
	if (fabs(a) > 20 || fabs(b) > 20 || error > 0.05) return NOT_JUDGED;
	bool same = is_near(found_a, a, error * (1 + fabs(a))) && is_near(found_b, b, error * (1 + fabs(b)));
	return right_if(same && is_near(z, t, error * size * (1 + fabs(a) + fabs(b)) + 1e-4 * d[10] * (1 + fabs(tilt))));
}

static judgement surfel_fragment(const u32 *in, const u32 *out)
{
	const f32 *d = (const f32 *)(const void *)in;
	double dx = (double)((i32)in[32] - (i32)in[0]) - d[2], dy = (double)((i32)in[33] - (i32)in[1]) - d[3];
	bool parallel = (in[11] & TS_DISC_PARALLEL) != 0, crosses = (in[11] & TS_DISC_CROSSES) != 0;
	double tilt = d[8] * dx + d[9] * dy, divisor = parallel ? 1 : 1 + tilt, screen2 = (dx * dx + dy * dy) * d[26];
	bool meets = divisor > 0 && (in[11] & TS_DISC_FLAT) == 0;
	if (fabs(divisor) < 0.05) return NOT_JUDGED;
	double a = (d[4] * dx + d[5] * dy) / divisor + (crosses ? d[16] : 0);
	double b = (d[6] * dx + d[7] * dy) / divisor + (crosses ? d[17] : 0);
	double r2 = a * a + b * b, z = d[10] * (parallel ? 1 - tilt : 1 / divisor), exponent, peak = 1;
	if (is_near(r2, 1, 1e-4) || is_near(screen2, 1, 1e-4) || is_near(z, d[31], 1e-4 * (1 + z))) return NOT_JUDGED;
	bool inside = meets && r2 <= 1 && z >= d[31], covers;
	if (in[24] == TS_FILTER_EWA) {
		double q = d[16] * dx * dx + 2 * d[17] * dx * dy + d[18] * dy * dy;
		if (is_near(q, 4, 1e-3)) return NOT_JUDGED;
		covers = q <= 4 && d[19] > 0, exponent = q / 2, peak = d[19];
	} else {
		bool object = inside && in[24] != TS_FILTER_SCREEN;
		bool screen = d[26] > 0 && in[24] != TS_FILTER_OBJECT && !crosses && screen2 <= 1;
		covers = object || screen;
		exponent = (object && screen ? fmin(r2, screen2) : object ? r2 : screen2) * d[28];
	}
	if (out[0] != covers || out[1] != inside) return WRONG;
	double right = peak * exp(-exponent), depth = inside ? z : d[10];
	bool near = is_near(ts_row_f32(out, 2), depth, 1e-4 * (1 + fabs(depth)));
	return right_if(near &&
	                (!covers || exponent > 80 || is_near(ts_row_f32(out, 3), right, 1e-4 * (1 + exponent) * right)));
}

/* Lambert's law and (r.v)^32, or three tones. */
static judgement surfel_light(const u32 *in, const u32 *out)
{
	double3 p = d3_row(in, 18), n = d3_row(in, 21), v = d3_row(in, 24), d = d3_sub(d3_row(in, 0), p), l = d;
	double dd = d3_dot(d, d), range = ts_row_f32(in, 7), pi = acos(-1), arrives = 1;
	if (in[3] == TS_LIGHT_KIND_SPOT || dd < 0.01) return NOT_JUDGED;
	l = in[3] == TS_LIGHT_KIND_DIRECTIONAL ? d3_scale(d3_row(in, 4), -1) : d3_unit(d);
	if (in[3] == TS_LIGHT_KIND_POINT) arrives = (range > 0 ? fmax(1 - pow(dd / range / range, 2), 0) : 1) / dd;
	double cosine = d3_dot(n, l), tone = fmin(floor(cosine * 3 + 1), 3) / 3, tones = cosine * 3 + 1;
	double3 mirror = d3_mad(d3_scale(l, -1), n, 2 * cosine), albedo = d3_row(in, 27), intensity = d3_row(in, 8);
	if (fabs(cosine) < 1e-5 || is_near(tones, rint(tones), 1e-5)) return NOT_JUDGED;
	double shine = in[17] == 0 ? 0.25 * pow(fmax(d3_dot(mirror, v), 0), 32) : 0, paint = in[17] == 0 ? cosine : tone;
	double scale = cosine > 0 ? arrives * ts_row_f32(in, 16) / pi : 0;
	double3 right = {(albedo.x * paint + shine) * scale * intensity.x, (albedo.y * paint + shine) * scale * intensity.y,
	                 (albedo.z * paint + shine) * scale * intensity.z};
	double error = d3_length(intensity) * (1e-4 * scale + 1e-5 / dd) + 1e-7;
	return right_if(d3_distance(d3_row(out, 0), right) <= error);
}

static void composites_match_double_precision(void **state)
{
	(void)state;
	static const composite composites[] = {TS_LIST_surfels_composites(COMPOSITE)};
	judge_all(composites, TS_N_surfels_composites);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(composites_match_double_precision)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
