/* Solid angle and form factor of a triangle, seen from a point p (CONTRACT rule 42). The solid angle is that of Van
 * Oosterom and Strackee (1983). The form factor (Baum, Rushmeier and Winget 1989) is the share of the light of a
 * surface at p that reaches the triangle; only the part above the surface's horizon counts, and only if p is on the
 * side from which the triangle's corners run counter-clockwise. Edges are computed from the corners, not as differences
 * of directions: the relative error of the solid angle of a small triangle is below 1e-6 over the cosine by which the
 * triangle is turned away, the error of a form factor below 1e-7. If p is at a corner, on an edge or in the plane, or
 * the triangle has no area, both are still numbers in their range: vectors without a direction count as 0. */
#ifndef TS_KERNELS_FORM_FACTOR_H
#define TS_KERNELS_FORM_FACTOR_H
#include "../base/vec.h"

/* The solid angle Omega, from 0 to 2 pi: tan(Omega / 2) = |a.(b x c)| / (1 + a.b + b.c + c.a), with unit vectors from p
 * to the corners. */
TS_FN f32 ts_k_solid_angle(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_v3 normal = ts_cross(ts_sub(b, a), ts_sub(c, a));
	ts_v3 to_b = ts_sub(b, p);
	ts_v3 to_c = ts_sub(c, p);
	ts_v3 ua = ts_normalize(ts_sub(a, p));
	ts_v3 ub = ts_normalize(to_b);
	ts_v3 uc = ts_normalize(to_c);
	f32 far = ts_flush(ts_length(to_b) * ts_length(to_c));
	f32 volume = far > 0.0f ? ts_abs(ts_dot(ua, normal)) / far : 0.0f;
	f32 sum = 1.0f + ts_dot(ua, ub);
	sum = sum + ts_dot(ub, uc);
	sum = sum + ts_dot(uc, ua);
	return 2.0f * ts_atan2(ts_flush(volume), ts_flush(sum));
}

/* The sum of the unit vectors to the corners. */
TS_FN ts_v3 ts_k_ways(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_v3 ways = ts_add(ts_normalize(ts_sub(a, p)), ts_normalize(ts_sub(b, p)));
	return ts_add(ways, ts_normalize(ts_sub(c, p)));
}

/* Gamma_i.n of the edge between two points. Gamma_i has the angle of the edge as seen from p for its length, and is
 * normal to the plane of p and the edge. */
TS_FN f32 ts_k_form_edge(ts_v3 p, ts_v3 n, ts_v3 from, ts_v3 to)
{
	ts_v3 r = ts_normalize(ts_sub(from, p));
	ts_v3 across = ts_cross(r, ts_sub(to, from));
	f32 length = ts_length(across);
	f32 angle = ts_atan2(length, ts_flush(ts_dot(r, ts_sub(to, p))));
	f32 along = ts_flush(ts_dot(across, n));
	return length > 0.0f ? (along / length) * angle : 0.0f;
}

/* The point of an edge on the horizon, from the corner above it to the one below (rule 16). */
TS_FN ts_v3 ts_k_form_cut(ts_v3 above, f32 d_above, ts_v3 below, f32 d_below)
{
	f32 t = d_above / (d_above - d_below);
	return ts_mad(above, ts_sub(below, above), t);
}

/* The form factor, from 0 to 1; n is a unit vector. F = |sum of Gamma_i.n| / 2 pi over the edges above the horizon and,
 * if the horizon cuts the triangle, the edge on the horizon. 0 unless p is in front of the triangle. */
TS_FN f32 ts_k_form_factor(ts_v3 p, ts_v3 n, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_v3 light = ts_cross(ts_sub(b, a), ts_sub(c, a));
	if (!(ts_flush(ts_dot(light, ts_sub(p, a))) > 0.0f)) return 0.0f;
	ts_v3 enters = a;
	ts_v3 leaves = a;
	f32 sum = 0.0f;
	for (u32 i = 0u; i < 3u; i++) {
		ts_v3 from = i == 0u ? a : i == 1u ? b : c;
		ts_v3 to = i == 0u ? b : i == 1u ? c : a;
		f32 d_from = ts_flush(ts_dot(n, ts_sub(from, p)));
		f32 d_to = ts_flush(ts_dot(n, ts_sub(to, p)));
		if (d_from >= 0.0f && d_to < 0.0f) to = leaves = ts_k_form_cut(from, d_from, to, d_to);
		if (d_from < 0.0f && d_to >= 0.0f) from = enters = ts_k_form_cut(to, d_to, from, d_from);
		if (d_from >= 0.0f || d_to >= 0.0f) sum = sum + ts_k_form_edge(p, n, from, to);
	}
	sum = sum + ts_k_form_edge(p, n, leaves, enters);
	return ts_min(ts_abs(sum) * 0.15915493667125701904296875f, 1.0f);
}

#endif
