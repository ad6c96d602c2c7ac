/* A linear field of normals for each surfel (NV40: Phong Shading for PBR; METHODS 16): n + a n_a + b n_b at the centre
 * + a u + b v. The slopes n_a and n_b fit the normals of the nearest surfels by least squares:
 *
 *     minimize  sum w (n_j - n - a_j n_a - b_j n_b)^2 + r sum w (a_j a_j + b_j b_j) (n_a^2 + n_b^2).
 *
 * (a_j, b_j) is the place of neighbour j in the surfel's plane. w = max(n . n_j, 0), since the back of a thin sheet
 * does not affect its front. The second sum (ridge regression, Hoerl and Kennard 1970) has a small factor r; where
 * neighbours stand along a line it gives the shortest slopes. The kernel takes no decision, so it has no margin. */
#ifndef TS_KERNELS_SURFELS_NORMAL_FIELD_H
#define TS_KERNELS_SURFELS_NORMAL_FIELD_H
#include "kernels/base/args.h"
#include "kernels/surfels/surfel_setup.h"

#define TS_FIELD_NEIGHBOURS 8u
#define TS_FIELD_SLOPES 6u /* n_a, n_b */
#define TS_FIELD_RIDGE 0.0009765625f

#define TS_ROWS_ts_normal_field_args(ARG) \
	ARG(IN, ts_surfel, surfels, scene_surfel) \
	ARG(IN, u32, near, surfel_near_surfel) \
	ARG(OUT, f32, slopes, normal_field_slope)
TS_ARGS(ts_normal_field_args);

/* The sums of the fit. */
typedef struct {
	f32 aa, ab, bb;
	ts_v3 a, b;
} ts_field_sums;

TS_FN ts_v3 ts_k_san3(ts_v3 a) { return ts_v3_make(ts_san(a.x), ts_san(a.y), ts_san(a.z)); }

/* Adds a neighbour to the sums. */
TS_FN void ts_k_field_add(ts_field_sums *sums, TS_GLOBAL const ts_surfel *surfel, TS_GLOBAL const ts_surfel *other)
{
	/* Load the axes of the surfel, and both normals. */
	ts_v3 u = ts_load3(surfel->u);
	ts_v3 v = ts_load3(surfel->v);
	ts_v3 n = ts_k_disc_normal(surfel);
	ts_v3 n_j = ts_k_disc_normal(other);
	/* Find the neighbour's place (a_j, b_j) in the surfel's plane, and the change of the normal. */
	ts_v3 d = ts_sub(ts_load3(other->centre), ts_load3(surfel->centre));
	ts_v3 change = ts_k_san3(ts_sub(n_j, n));
	f32 a = ts_san(ts_dot(d, u) / ts_dot(u, u));
	f32 b = ts_san(ts_dot(d, v) / ts_dot(v, v));
	/* Weight by the cosine between the normals, so that the back of a thin sheet does not count. */
	f32 w = ts_max(ts_san(ts_dot(n, n_j)), 0.0f);
	/* Add to the normal equations of the fit. */
	sums->aa = sums->aa + w * (a * a);
	sums->ab = sums->ab + w * (a * b);
	sums->bb = sums->bb + w * (b * b);
	sums->a = ts_mad(sums->a, change, w * a);
	sums->b = ts_mad(sums->b, change, w * b);
}

TS_FN ts_field_sums ts_k_field_sums(const ts_normal_field_args *args, u64 i)
{
	ts_field_sums r;
	r.aa = r.ab = r.bb = 0.0f;
	r.a = r.b = ts_v3_make(0.0f, 0.0f, 0.0f);
	for (u32 k = 0u; k < TS_FIELD_NEIGHBOURS; k++) {
		u32 other = args->near[i * TS_FIELD_NEIGHBOURS + k];
		if (other != TS_NONE) ts_k_field_add(&r, &args->surfels[i], &args->surfels[other]);
	}
	return r;
}

/* x of the equations p x + q y = s, q x + r y = t; per_det is 1 / (p r - q q). */
TS_FN ts_v3 ts_k_field_slope(ts_v3 s, ts_v3 t, f32 q, f32 r, f32 per_det)
{
	return ts_v3_make(ts_diff_of_products(s.x, r, t.x, q) * per_det, ts_diff_of_products(s.y, r, t.y, q) * per_det,
	                  ts_diff_of_products(s.z, r, t.z, q) * per_det);
}

/* map over surfels */
TS_FN void ts_k_normal_field_item(const ts_normal_field_args *args, u64 i)
{
	ts_field_sums sums = ts_k_field_sums(args, i);
	f32 ridge = TS_FIELD_RIDGE * (ts_san(sums.aa) + ts_san(sums.bb));
	f32 aa = ts_san(sums.aa) + ridge;
	f32 bb = ts_san(sums.bb) + ridge;
	f32 ab = ts_san(sums.ab);
	ts_v3 a = ts_k_san3(sums.a);
	ts_v3 b = ts_k_san3(sums.b);
	f32 det = ts_diff_of_products(aa, bb, ab, ab);
	f32 per_det = 1.0f / (det > 0.0f ? det : 1.0f);
	ts_store3(args->slopes + i * TS_FIELD_SLOPES, ts_k_field_slope(a, b, ab, bb, per_det));
	ts_store3(args->slopes + i * TS_FIELD_SLOPES + 3u, ts_k_field_slope(b, a, ab, aa, per_det));
}

#endif
