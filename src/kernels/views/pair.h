/* The fate of a pair of a node of the scene and a node of views (MegaViews section 3.2, figures 4, 6 and 8, whose text
 * is lost; METHODS 13). Figure 4 is evaluated without angles: with c = vs . n and s = |vs x n|, s cos psi - c sin psi
 * is |vs| sin(alpha - psi), and c cos psi + s sin psi is |vs| cos(alpha - psi). */
#ifndef TS_KERNELS_VIEWS_PAIR_H
#define TS_KERNELS_VIEWS_PAIR_H
#include "kernels/base/records.h"
#include "kernels/views/paraboloid.h"

typedef struct {
	ts_v3 p;
	f32 r;
	bool leaf;
} ts_ball;
/* The cone of the views of a node: their directions are at most theta from the axis. */
typedef struct {
	ts_v3 axis;
	f32 cosine; /* of theta */
} ts_cone_k;
/* Half the field of view of every view, phi: a right angle, or pi for views to all sides; or psi = theta + phi. */
typedef struct {
	f32 cosine, sine;
} ts_aperture;

/* Fates of a pair. */
#define TS_PAIR_SPLIT_SCENE 0u
#define TS_PAIR_SPLIT_VIEW 1u
#define TS_PAIR_RENDER 2u
#define TS_PAIR_CULL 3u
#define TS_PAIR_NEAR 4u

/* Cosines and what is computed from them are rounded, so a pair that is nearer to the bounds than this is kept: 2^-22
 * of a cosine, 2^-20 of the distance. */
#define TS_CULL_COSINE 0.0000002384185791015625f
#define TS_CULL_DISTANCE 0.00000095367431640625f

TS_FN ts_ball ts_k_node_ball(TS_GLOBAL const ts_node *node)
{
	ts_ball r;
	r.p = ts_load3(node->centre);
	r.r = node->radius;
	r.leaf = node->children == 0u;
	return r;
}

TS_FN ts_cone_k ts_k_load_cone(TS_GLOBAL const ts_cone *cone)
{
	ts_cone_k r;
	r.axis = ts_load3(cone->axis);
	r.cosine = cone->cosine;
	return r;
}

/* Cosine and sine of psi = theta + phi. */
TS_FN ts_aperture ts_k_pair_psi(const ts_cone_k *cone, const ts_aperture *phi)
{
	f32 c = ts_max(cone->cosine - TS_CULL_COSINE, -1.0f);
	f32 square = c * c;
	f32 s = ts_sqrt(ts_flush(ts_max(1.0f - square, 0.0f)));
	ts_aperture r;
	r.cosine = ts_diff_of_products(c, phi->cosine, s, phi->sine);
	f32 sc = s * phi->cosine;
	f32 cs = c * phi->sine;
	r.sine = sc + cs;
	return r;
}

/* Figure 4: fs, how far the ball's middle lies outside the cone; at most 0 if it lies inside. No angle is computed: psi
 * is pi or more if its sine is not positive, alpha is at most psi if the sine of alpha - psi is not positive, and alpha
 * - psi is a right angle or more if its cosine is not positive. Then the cone's apex is nearest, at distance d. */
TS_FN f32 ts_k_pair_outside_psi(ts_v3 vs, ts_v3 axis, ts_aperture psi)
{
	f32 d = ts_length(vs);
	if (!(psi.sine > 0.0f)) return -d;
	f32 along = ts_dot(vs, axis);
	f32 aside = ts_length(ts_cross(vs, axis));
	f32 sine = ts_diff_of_products(aside, psi.cosine, along, psi.sine);
	f32 cc = along * psi.cosine;
	f32 ss = aside * psi.sine;
	return cc + ss > 0.0f || !(sine > 0.0f) ? sine : d;
}

TS_FN f32 ts_k_pair_outside(const ts_ball *s, const ts_ball *v, const ts_cone_k *cone, const ts_aperture *phi)
{
	return ts_k_pair_outside_psi(ts_sub(s->p, v->p), cone->axis, ts_k_pair_psi(cone, phi));
}

/* The bound that fs must pass for a pair to be culled. */
TS_FN f32 ts_k_pair_reach(const ts_ball *s, const ts_ball *v)
{
	f32 slack = ts_length(ts_sub(s->p, v->p)) * TS_CULL_DISTANCE;
	return (s->r + v->r) + slack;
}

/* Whether the ball lies outside of what any of the views can see. */
TS_FN bool ts_k_pair_is_culled(const ts_ball *s, const ts_ball *v, const ts_cone_k *cone, const ts_aperture *phi)
{
	f32 fs = ts_k_pair_outside(s, v, cone, phi);
	return fs > 0.0f && fs > ts_k_pair_reach(s, v);
}

/* Width of the ball of s in texels, seen from the nearest place in the ball of v; -1 if that place may lie in the ball
 * of s. Only the length of vs is shortened (figure 6); alpha stays that of the middles. */
TS_FN f32 ts_k_pair_size(const ts_ball *s, const ts_ball *v, u32 n)
{
	ts_v3 vs = ts_sub(s->p, v->p);
	f32 d = ts_length(vs);
	f32 nearest = d - v->r;
	if (!(nearest > s->r)) return -1.0f;
	return ts_k_paraboloid_size(ts_abs(vs.x) / d, s->r / nearest, n);
}

/* Figure 6: whether all views show s in the same texel, or in one of its neighbours. Two leaves, which the figure takes
 * for equivalent too, are left to ts_k_pair_fate. */
TS_FN bool ts_k_pair_is_equivalent(const ts_ball *s, const ts_ball *v, u32 n)
{
	f32 size = ts_k_pair_size(s, v, n);
	return size >= 0.0f && size < 1.0f && v->r <= s->r;
}

/* Figure 8: whether the node of views is split, which keeps its ball no larger than the scene's. In an octree a child's
 * ball has half the radius of its parent's. */
TS_FN bool ts_k_pair_splits_view(const ts_ball *s, const ts_ball *v)
{
	f32 child = s->r * 0.5f;
	return s->leaf || (!v->leaf && child < v->r);
}

/* Distance between the surfaces of two balls; at most 0 where the balls touch. */
TS_FN f32 ts_k_pair_gap(const ts_ball *s, const ts_ball *v) { return ts_length(ts_sub(s->p, v->p)) - (s->r + v->r); }

/* True for two leaves whose middles are nearer than `apart` radii of the scene's leaf. */
TS_FN bool ts_k_pair_is_near(const ts_ball *s, const ts_ball *v, f32 apart)
{
	return s->leaf && v->leaf && ts_length(ts_sub(s->p, v->p)) < apart * s->r;
}

#endif
