/* Solid angle and form factor of a triangle, seen from a point p (CONTRACT rule 42). The solid angle is that of Van
 * Oosterom and Strackee (1983). The form factor (Baum, Rushmeier and Winget 1989) is the share of the light of a
 * surface at p that reaches the triangle; only the part above the surface's horizon counts, and only if p is on the
 * side from which the triangle's corners run counter-clockwise. Edges are computed from the corners, not as differences
 * of directions, and the horizon cuts what is seen from p, not the scene: the relative error of the solid angle of a
 * small triangle is below 1e-6 over the cosine by which the triangle is turned away, the error of a form factor below
 * 2e-7, wherever the scene is. If p is at a corner, on an edge or in the plane, or the triangle has no area, both are
 * still numbers in their range: vectors without a direction count as 0. */
#ifndef TS_KERNELS_HULLS_FORM_FACTOR_H
#define TS_KERNELS_HULLS_FORM_FACTOR_H
#include "kernels/base/vec.h"

/* The solid angle Omega, from 0 to 2 pi (Van Oosterom and Strackee 1983). With the unit vectors a, b and c from p to
 * the corners, tan(Omega / 2) = |a.(b x c)| / (1 + a.b + b.c + c.a). */
TS_FN f32 ts_k_solid_angle(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	/* Find the normal from differences of corners, in which small triangles keep their digits, and the directions to
	 * the corners. */
	ts_v3 normal = ts_cross(ts_sub(b, a), ts_sub(c, a));
	ts_v3 to_b = ts_sub(b, p);
	ts_v3 to_c = ts_sub(c, p);
	ts_v3 ua = ts_normalize(ts_sub(a, p));
	ts_v3 ub = ts_normalize(to_b);
	ts_v3 uc = ts_normalize(to_c);
	/* Compute |a.(b x c)| as a.normal / (|to_b| |to_c|), which does not cancel; it is 0 where p is at a corner. */
	f32 far = ts_flush(ts_length(to_b) * ts_length(to_c));
	f32 volume = far > 0.0f ? ts_abs(ts_dot(ua, normal)) / far : 0.0f;
	/* Compute the denominator 1 + a.b + b.c + c.a. */
	f32 sum = 1.0f + ts_dot(ua, ub);
	sum = sum + ts_dot(ub, uc);
	sum = sum + ts_dot(uc, ua);
	/* Take the angle by atan2: the denominator falls below 0 where Omega passes pi. */
	return 2.0f * ts_atan2(ts_flush(volume), ts_flush(sum));
}

/* The sum of the unit vectors to the corners. */
TS_FN ts_v3 ts_k_ways(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_v3 ways = ts_add(ts_normalize(ts_sub(a, p)), ts_normalize(ts_sub(b, p)));
	return ts_add(ways, ts_normalize(ts_sub(c, p)));
}

/* Whether p is in front of the plane through a, by more than 2^-19 of the coordinates, which is more than rounding can
 * do. A place on the plane is not in front, since it would see half the sphere as light. The normal has any length. */
TS_FN bool ts_k_is_in_front(ts_v3 p, ts_v3 a, ts_v3 normal)
{
	ts_v3 sum = ts_v3_make(ts_abs(p.x) + ts_abs(a.x), ts_abs(p.y) + ts_abs(a.y), ts_abs(p.z) + ts_abs(a.z));
	f32 rounding = ts_max(ts_max(sum.x, sum.y), sum.z) * 0.0000019073486328125f;
	return ts_flush(ts_dot(normal, ts_sub(p, a))) > ts_flush(ts_length(normal) * rounding);
}

/* Gamma_i.n of the edge between two points, seen from the origin. Gamma_i has the angle of the edge for its length, and
 * is normal to the plane of the origin and the edge. */
TS_FN f32 ts_k_form_edge(ts_v3 n, ts_v3 from, ts_v3 to, ts_v3 edge)
{
	ts_v3 r = ts_normalize(from);
	ts_v3 across = ts_cross(r, edge);
	f32 length = ts_length(across);
	f32 angle = ts_atan2(length, ts_flush(ts_dot(r, to)));
	f32 along = ts_flush(ts_dot(across, n));
	return length > 0.0f ? (along / length) * angle : 0.0f;
}

/* The share of an edge that is above the horizon, from its corner above to the one below (rule 16). */
TS_FN f32 ts_k_form_share(f32 d_above, f32 d_below) { return d_above / (d_above - d_below); }

/* The form factor, from 0 to 1 (Baum, Rushmeier and Winget 1989); n is a unit vector. F = |sum of Gamma_i.n| / (2 pi)
 * over the edges above the horizon and, if the horizon cuts the triangle, the edge on the horizon. F is 0 unless p is
 * in front of the triangle. */
TS_FN f32 ts_k_form_factor(ts_v3 p, ts_v3 n, ts_v3 a, ts_v3 b, ts_v3 c)
{
	/* Leave out a triangle unless p is in front of it by more than rounding. */
	if (!ts_k_is_in_front(p, a, ts_cross(ts_sub(b, a), ts_sub(c, a)))) return 0.0f;
	/* Start with an edge of length 0 on the horizon; it stays so unless the horizon cuts the triangle. */
	ts_v3 enters = ts_sub(a, p);
	ts_v3 leaves = enters;
	f32 sum = 0.0f;
	for (u32 i = 0u; i < 3u; i++) {
		/* Take edge ab, bc or ca as seen from p, and the heights of its ends above the horizon. */
		ts_v3 first = i == 0u ? a : i == 1u ? b : c;
		ts_v3 second = i == 0u ? b : i == 1u ? c : a;
		ts_v3 edge = ts_sub(second, first);
		ts_v3 from = ts_sub(first, p);
		ts_v3 to = ts_sub(second, p);
		f32 d_from = ts_flush(ts_dot(n, from));
		f32 d_to = ts_flush(ts_dot(n, to));
		/* Clip the edge at the horizon. The cut starts from the upper end, so that two triangles with a common edge cut
		 * it at the same place; an end at height 0 is above. */
		if (d_from < 0.0f && d_to < 0.0f) continue;
		if (d_to < 0.0f) edge = ts_scale(edge, ts_k_form_share(d_from, d_to));
		if (d_to < 0.0f) to = leaves = ts_add(from, edge);
		if (d_from < 0.0f) edge = ts_scale(edge, ts_k_form_share(d_to, d_from));
		if (d_from < 0.0f) from = enters = ts_sub(to, edge);
		/* Add Gamma_i.n of the part above the horizon (Baum, Rushmeier and Winget 1989). */
		sum = sum + ts_k_form_edge(n, from, to, edge);
	}
	/* Close the polygon along the horizon, and divide by 2 pi; rounding could exceed 1. */
	sum = sum + ts_k_form_edge(n, leaves, enters, ts_sub(enters, leaves));
	return ts_min(ts_abs(sum) * TS_PER_TWO_PI, 1.0f);
}

#endif
