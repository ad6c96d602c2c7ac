/* The composites of MegaViews and ManyLoDs against angles in double precision, and separating axes in integers. */
#include "kernels/views/composites.h"
#include "tests/vectors/composites.h"

static judgement paraboloid_texel(const u32 *in, const u32 *out)
{
	double3 d = d3_row(in, 0);
	double n = in[3], sum = d3_length(d) + fabs(d.x), place[2] = {n / 2, n / 2};
	if (sum > 0) place[0] = (d.y / sum + 1) / 2 * n, place[1] = (d.z / sum + 1) / 2 * n;
	bool near = is_near(ts_row_f32(out, 0), place[0], 1e-6 * n) && is_near(ts_row_f32(out, 1), place[1], 1e-6 * n);
	u32 i = (u32)fmin(fmax(floorf(ts_row_f32(out, 0)), 0), n - 1),
		j = (u32)fmin(fmax(floorf(ts_row_f32(out, 1)), 0), n - 1);
	return right_if(near && out[2] == ((d.x < 0 ? 1u : 0u) * in[3] + j) * in[3] + i);
}

/* The stereographic image of the direction is the texel's middle. */
static judgement paraboloid_direction(const u32 *in, const u32 *out)
{
	double3 d = d3_row(out, 0);
	u32 n = in[1];
	double u = (in[0] % n + 0.5) * 2 / n - 1, v = (in[0] / n % n + 0.5) * 2 / n - 1;
	double along = in[0] < n * n ? d.x : -d.x;
	if (!is_near(d3_length(d), 1, 1e-6)) return WRONG;
	return right_if(is_near(d.y / (1 + along), u, 1e-5) && is_near(d.z / (1 + along), v, 1e-5));
}

/* The map takes an angle to the tangent of its half: from the near side of the ball to the far one. */
static judgement paraboloid_size(const u32 *in, const u32 *out)
{
	double alpha = acos(ts_row_f32(in, 0)), rho = asin(ts_row_f32(in, 1)), n = in[2];
	if (alpha + rho > 3.1) return NOT_JUDGED;
	double wide = n / 2 * (tan((alpha + rho) / 2) - tan((alpha - rho) / 2));
	return right_if(is_near(ts_row_f32(out, 0), wide, 1e-5 * wide));
}

/* By angles: alpha to the middle of the node, psi the half-angle of what any view can see. */
static judgement pair_fate(const u32 *in, const u32 *out)
{
	double3 vs = d3_sub(d3_row(in, 0), d3_row(in, 8));
	double d = d3_length(vs), s = ts_row_f32(in, 3), v = ts_row_f32(in, 11), pi = acos(-1), cutoff = ts_row_f32(in, 30);
	bool node_leaf = in[5] == 0 || in[7] >= in[28], view_leaf = in[13] == 0 || in[15] >= in[28];
	double psi = acos(fmin(fmax(ts_row_f32(in, 19), -1), 1)) + atan2(ts_row_f32(in, 25), ts_row_f32(in, 24));
	double cosine = d > 0 ? d3_dot(vs, d3_row(in, 16)) / d : 1, alpha = acos(fmin(fmax(cosine, -1), 1));
	double outside = psi >= pi || alpha <= psi ? -d : alpha - psi < pi / 2 ? d * sin(alpha - psi) : d;
	double nearest = d - v, sine = nearest > s ? s / nearest : 1, apart = ts_row_f32(in, 27) * s;
	double size = in[26] * sine / (fabs(vs.x) / (d > 0 ? d : 1) + sqrt(1 - sine * sine)), gap = d - s - v;
	bool close = is_near(outside, s + v, 1e-3) || is_near(psi, pi, 1e-3) || is_near(alpha, psi, 1e-3);
	close = close || is_near(alpha - psi, pi / 2, 1e-3) || is_near(size, 1, 1e-3) || is_near(nearest, s, 1e-4);
	close = close || is_near(d, apart, 1e-4) || is_near(gap, cutoff, 1e-4) || is_near(v, s / 2, 1e-6);
	if (close) return NOT_JUDGED;
	bool equivalent = nearest > s && size < 1 && v <= s;
	bool splits_view = node_leaf || (!view_leaf && s / 2 < v);
	u32 fate = splits_view ? TS_PAIR_SPLIT_VIEW : TS_PAIR_SPLIT_SCENE;
	if (node_leaf && view_leaf) fate = d < apart ? TS_PAIR_NEAR : TS_PAIR_RENDER;
	if (in[29] == 0 && equivalent) fate = TS_PAIR_RENDER;
	if (cutoff > 0 && gap > cutoff) fate = TS_PAIR_CULL;
	if (outside > s + v) fate = TS_PAIR_CULL;
	return right_if(out[0] == fate);
}

/* Of the finest level: the direction of the texel's middle meets the ball. */
static judgement cap_inside(const u32 *in, const u32 *out)
{
	double3 vs = d3_row(in, 0);
	double d = d3_length(vs), n = in[5], r = ts_row_f32(in, 3);
	double u = (in[7] + 0.5) * 2 / n - 1, v = (in[8] + 0.5) * 2 / n - 1, square = u * u + v * v;
	double along = (1 - square) / (1 + square);
	double3 way = {in[4] != 0 ? -along : along, 2 * u / (1 + square), 2 * v / (1 + square)};
	if (in[6] != 0 || d < 0.1) return NOT_JUDGED;
	if (is_near(d, r, 1e-3 * d)) return NOT_JUDGED;
	if (d < r) return right_if(ts_row_f32(out, 0) >= 0);
	double angle = atan2(d3_length(d3_cross(way, vs)), d3_dot(way, vs)), rho = asin(r / d);
	return is_near(angle, rho, 1e-3) ? NOT_JUDGED : right_if((ts_row_f32(out, 0) >= 0) == (angle < rho));
}

/* Do the closed box and the triangle overlap along an axis? In 128 bits nothing overflows. */
static bool overlaps(const u32 *in, const i64 axis[3])
{
	__int128 low = 0, high = 0, from = 0, to = 0;
	for (u32 c = 0; c < 3; c++) {
		__int128 at = 0;
		for (u32 k = 0; k < 3; k++) at += (__int128)axis[k] * in[3 * c + k];
		low = c == 0 || at < low ? at : low;
		high = c == 0 || at > high ? at : high;
	}
	for (u32 k = 0; k < 3; k++) {
		__int128 a = (__int128)axis[k] * (256 * (i64)in[10 + k]), b = (__int128)axis[k] * (256 * (i64)in[10 + k] + 256);
		from += a < b ? a : b;
		to += a < b ? b : a;
	}
	return low <= to && high >= from;
}

static judgement voxel_touches(const u32 *in, const u32 *out)
{
	i64 edge[3][3];
	bool touches = true;
	for (u32 c = 0; c < 3; c++) {
		for (u32 k = 0; k < 3; k++) edge[c][k] = (i64)in[3 * ((c + 1) % 3) + k] - in[3 * c + k];
	}
	for (u32 k = 0; k < 3; k++) {
		u32 p = (k + 1) % 3, q = (k + 2) % 3;
		i64 axis[3] = {k == 0, k == 1, k == 2};
		touches = touches && overlaps(in, axis);
		for (u32 c = 0; c < 3; c++) {
			i64 across[3] = {0};
			across[p] = -edge[c][q];
			across[q] = edge[c][p];
			touches = touches && overlaps(in, across);
		}
	}
	const i64 *e = edge[0], *f = edge[1];
	i64 normal[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
	return right_if(out[0] == (touches && overlaps(in, normal) ? 1u : 0u));
}

/* Signed volumes of the ray with each edge. */
static judgement cast_inside(const u32 *in, const u32 *out)
{
	double3 o = d3_row(in, 0), d = d3_row(in, 3);
	u32 n_left = 0, n_right = 0;
	for (u32 k = 0; k < 3; k++) {
		double3 a = d3_sub(d3_row(in, 6 + 3 * k), o), b = d3_sub(d3_row(in, 6 + 3 * ((k + 1) % 3)), o);
		double volume = d3_dot(d, d3_cross(b, a)), size = d3_length(a) * d3_length(b);
		if (fabs(volume) < 1e-6 * size) return NOT_JUDGED;
		n_left += volume > 0;
		n_right += volume < 0;
	}
	return right_if(out[0] == (n_left == 3 || n_right == 3));
}

static judgement vpl_form(const u32 *in, const u32 *out)
{
	double3 way = d3_row(in, 0), from = d3_row(in, 3), n = d3_row(in, 6);
	double d = d3_length(way), near = ts_row_f32(in, 9);
	if (d == 0) return right_if(out[0] == 0);
	double leaves = d3_length(from) > 0 ? d3_dot(way, from) / d : 0.25, arrives = -d3_dot(way, n) / d;
	double right = fmax(leaves, 0) * fmax(arrives, 0) / acos(-1) / fmax(d * d, near * near);
	double error = 1e-6 * right + 1e-6 / fmax(d * d, near * near);
	return right_if(is_near(ts_row_f32(out, 0), right, error));
}

static void composites_match_double_precision(void **state)
{
	(void)state;
	static const composite composites[] = {TS_LIST_views_composites(COMPOSITE)};
	judge_all(composites, TS_N_views_composites);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(composites_match_double_precision)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
