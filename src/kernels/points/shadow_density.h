/* Density of the points of omnidirectional shadows from the eye's resolution (EPR section 5.1, eq. 5; METHODS 10).
 *
 * For each light sample l that may see the triangle, d_lt is the distance of the triangle from l, d_ev that of the eye
 * from the triangle's shadow volume, and s_l the density that iVIR demands for the six views of l (view_density.h). A
 * detail of the triangle is magnified by d_lx / d_lt on a receiver x, which the eye sees at f_e / d_ex pixels per unit,
 * so f_e d_lx / (d_ex d_lt) samples per unit are needed. The largest need of all light samples counts:
 * - safe: max_l min((f_e / d_lt) (1 + |l - e| / d_ev), s_l), since d_lx <= |l - e| + d_ex and d_ex >= d_ev;
 * - unit: max_l min(f_e / d_ev, f_l / d_lt), the paper's ratio with pixels per unit in place of distances;
 * - paper: s min(1, max_l d_lt / d_ev), s = max_l s_l, the printed ratio as a share of iVIR's scale. */
#ifndef TS_KERNELS_POINTS_SHADOW_DENSITY_H
#define TS_KERNELS_POINTS_SHADOW_DENSITY_H
#include "kernels/base/closest.h"
#include "kernels/points/view_density.h"

#define TS_SHADOW_NONE 0u
#define TS_SHADOW_SAFE 1u
#define TS_SHADOW_UNIT 2u
#define TS_SHADOW_PAPER 3u

#define TS_FAR_OF_NEAR 4096.0f /* shadows end beyond every receiver: four times half the scene's diagonal */

/* The distance of p from the quad a b c d, as two triangles. */
TS_FN f32 ts_k_quad_distance(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c, ts_v3 d)
{
	f32 one = ts_length(ts_sub(ts_k_closest_on_triangle(p, a, b, c), p));
	f32 other = ts_length(ts_sub(ts_k_closest_on_triangle(p, a, c, d), p));
	return ts_min(one, other);
}

/* Whether p and q are on the same side of the plane through the origin with the normal n, or in the plane. */
TS_FN bool ts_k_same_side(ts_v3 n, ts_v3 p, ts_v3 q)
{
	f32 of_p = ts_flush(ts_dot(n, p));
	f32 of_q = ts_flush(ts_dot(n, q));
	return (of_p >= 0.0f && of_q >= 0.0f) || (of_p <= 0.0f && of_q <= 0.0f);
}

/* Whether p is in the shadow: beyond the triangle, and between the planes through its edges. All are relative to the
 * light. */
TS_FN bool ts_k_is_in_shadow(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_v3 n = ts_cross(ts_sub(b, a), ts_sub(c, a));
	if (ts_flush(ts_dot(n, a)) == 0.0f || !ts_k_same_side(n, a, ts_sub(p, a))) return false;
	return ts_k_same_side(ts_cross(a, b), c, p) && ts_k_same_side(ts_cross(b, c), a, p) &&
	       ts_k_same_side(ts_cross(c, a), b, p);
}

/* d_ev: the least distance from the triangle, from its copy `times` as far from the light, and from the three quads
 * between both; 0 inside and beyond the far end. */
TS_FN f32 ts_k_shadow_distance(ts_v3 eye, ts_v3 light, ts_v3 a, ts_v3 b, ts_v3 c, f32 times)
{
	ts_v3 near[3];
	/* Move the origin to the light. */
	near[0] = ts_sub(a, light);
	near[1] = ts_sub(b, light);
	near[2] = ts_sub(c, light);
	ts_v3 e = ts_sub(eye, light);
	/* Return 0 in the shadow. */
	if (ts_k_is_in_shadow(e, near[0], near[1], near[2])) return 0.0f;
	/* Close the shadow volume by the triangle's copy. */
	ts_v3 far[3];
	for (u32 k = 0u; k < 3u; k++) far[k] = ts_scale(near[k], times);
	/* Find the least distance from both ends and from the three sides (EPR 5.1). */
	f32 r = ts_length(ts_sub(ts_k_closest_on_triangle(e, near[0], near[1], near[2]), e));
	r = ts_min(r, ts_length(ts_sub(ts_k_closest_on_triangle(e, far[0], far[1], far[2]), e)));
	for (u32 k = 0u; k < 3u; k++) {
		u32 next = k == 2u ? 0u : k + 1u;
		r = ts_min(r, ts_k_quad_distance(e, near[k], near[next], far[next], far[k]));
	}
	return r;
}

/* The need of light sample l. most: iVIR's density for the views of l; by the paper's rate, for all views. */
TS_FN f32 ts_k_shadow_need(const ts_density_args *args, u32 l, f32 most, ts_v3 a, ts_v3 b, ts_v3 c)
{
	/* Find d_lt, at least at the light's near plane. */
	TS_GLOBAL const ts_offscreen *view = &args->views[l * 6u];
	ts_v3 light = ts_load3(view->eye);
	ts_v3 eye = ts_load3(args->view->eye);
	f32 focal = args->view->focal;
	f32 to_light = ts_max(ts_length(ts_sub(ts_k_closest_on_triangle(light, a, b, c), light)), view->near);
	/* Return early where f_e / d_lt alone reaches what iVIR demands. */
	if (args->shadow == TS_SHADOW_SAFE && focal / to_light >= most) return most;
	/* Find d_ev, the distance of the eye from the shadow volume. */
	f32 times = ts_max((view->near * TS_FAR_OF_NEAR) / to_light, 1.0f);
	f32 to_eye = ts_k_shadow_distance(eye, light, a, b, c, times);
	/* Bound the magnification of a detail on any receiver. */
	if (args->shadow == TS_SHADOW_SAFE) {
		f32 farther = ts_length(ts_sub(light, eye)) / ts_max(to_eye, view->near);
		return ts_min((focal / to_light) * (1.0f + farther), most);
	}
	/* Take the ratio in pixels per unit, or as the paper has it (EPR 5.1, eq. 5). */
	to_eye = ts_max(to_eye, view->near);
	if (args->shadow == TS_SHADOW_UNIT) return ts_min(focal / to_eye, view->focal / to_light);
	return most * ts_min(1.0f, to_light / to_eye);
}

/* The density of a triangle for shadows: the largest need of the light samples that may see it (EPR 5.1, eq. 5). */
TS_CALL ts_need ts_k_shadow_density(const ts_density_args *args, TS_GLOBAL const u64 *words, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_need all;
	/* Find iVIR's density for all views, of which the paper's ratio is a share. */
	all.s = 0.0f;
	all.uneven = 1.0f;
	if (args->shadow == TS_SHADOW_PAPER) all = ts_k_view_density(args, words, a, b, c);
	ts_need r;
	r.s = 0.0f;
	r.uneven = 1.0f;
	for (u32 l = 0u; l * 6u < args->n_views; l++) {
		if (ts_k_cube_bits(words, l) == 0u) continue;
		/* Find iVIR's density for the sample's six views, and skip a sample that cannot need more than others. */
		ts_need most = all;
		if (args->shadow == TS_SHADOW_SAFE) most = ts_k_views_density(args, words, l * 6u, l * 6u + 6u, a, b, c);
		if (args->shadow != TS_SHADOW_UNIT && most.s <= r.s) continue;
		/* Keep the largest need; it is uneven only where iVIR's density is taken. */
		f32 s = ts_k_shadow_need(args, l, most.s, a, b, c);
		if (s <= r.s) continue;
		r.s = s;
		r.uneven = s == most.s ? most.uneven : 1.0f;
	}
	return r;
}

#endif
