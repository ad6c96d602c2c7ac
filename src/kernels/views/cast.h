/* The first triangle that a ray meets, found in the scene's octree: of least distance, then of least index, so that the
 * order of the search changes nothing. Back faces of single-sided materials and cut-out parts of masked materials let
 * the ray pass.
 *
 * Two triangles with a common edge test it with the same numbers of opposite signs, so no ray slips between them. Boxes
 * are enlarged by a 128th of their half side, which is more than snapping and rounding move a triangle. */
#ifndef TS_KERNELS_VIEWS_CAST_H
#define TS_KERNELS_VIEWS_CAST_H
#include "kernels/base/args.h"
#include "kernels/base/hit.h"
#include "kernels/base/morton.h"
#include "kernels/base/records.h"
#include "kernels/base/surface.h"

#define TS_CAST_STACK 96 /* 7 siblings per level, and a node */

#define TS_ROWS_ts_cast_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_node, nodes, octree_node) /* at least one */ \
	ARG(IN, u32, offset, octree_offset) \
	ARG(IN, u32, triangles, octree_triangle) \
	ARG(VALUE, u32, first_leaf, none) /* index of the node */ \
	ARG(VALUE, f32, leaf, none)       /* side of a leaf */
TS_ARGS(ts_cast_args);

typedef struct {
	ts_v3 o, d, inverse;
} ts_cast_ray;
typedef struct {
	f32 t;
	u32 triangle;
	ts_v3 weights;
} ts_cast_hit; /* triangle is TS_NONE if there is none */

/* 2^60 and 2^-60: an inverse that times any extent of a scene stays finite. */
#define TS_MOST_INVERSE 1152921504606846976.0f
#define TS_LEAST_INVERTED 8.67361737988403547205962240695953369140625e-19f

/* 1 / x, or 2^60 with the sign of x where that is more. */
TS_FN f32 ts_k_cast_inverse(f32 x)
{
	if (ts_abs(x) < TS_LEAST_INVERTED) return x < 0.0f ? -TS_MOST_INVERSE : TS_MOST_INVERSE;
	return 1.0f / x;
}

TS_FN ts_cast_ray ts_k_cast_ray(ts_v3 o, ts_v3 d)
{
	ts_cast_ray r;
	r.o = o;
	r.d = d;
	r.inverse = ts_v3_make(ts_k_cast_inverse(d.x), ts_k_cast_inverse(d.y), ts_k_cast_inverse(d.z));
	return r;
}

/* Whether the ray meets a node's box between 0 and `most`, by slabs (Kay and Kajiya 1986). */
TS_FN bool ts_k_cast_meets(const ts_cast_ray *ray, TS_GLOBAL const ts_node *node, f32 most)
{
	f32 half_side = node->radius * 0.581860840320587158203125f; /* 129 / 128 of 1 / sqrt 3 */
	ts_v3 extent = ts_v3_make(half_side, half_side, half_side);
	ts_v3 to = ts_sub(ts_load3(node->centre), ray->o);
	ts_v3 a = ts_mul(ts_sub(to, extent), ray->inverse);
	ts_v3 b = ts_mul(ts_add(to, extent), ray->inverse);
	ts_v3 low = ts_min3(a, b);
	ts_v3 high = ts_max3(a, b);
	f32 enters = ts_max(ts_max(low.x, low.y), ts_max(low.z, 0.0f));
	f32 leaves = ts_min(ts_min(high.x, high.y), ts_min(high.z, most));
	return enters <= leaves;
}

/* Whether the ray passes all edges on the same side. For each edge, as d.(b x a), the neighbour across the edge
 * computes the same bits with the opposite sign. A ray through an edge, where the number is 0, passes on both sides. */
TS_FN bool ts_k_cast_inside(const ts_cast_ray *ray, const ts_corners *t)
{
	ts_v3 a = ts_sub(t->a, ray->o);
	ts_v3 b = ts_sub(t->b, ray->o);
	ts_v3 c = ts_sub(t->c, ray->o);
	f32 u = ts_flush(ts_dot(ray->d, ts_cross(c, b)));
	f32 v = ts_flush(ts_dot(ray->d, ts_cross(a, c)));
	f32 w = ts_flush(ts_dot(ray->d, ts_cross(b, a)));
	return (u >= 0.0f && v >= 0.0f && w >= 0.0f) || (u <= 0.0f && v <= 0.0f && w <= 0.0f);
}

TS_FN void ts_k_cast_triangle(const ts_cast_args *args, const ts_cast_ray *ray, u32 triangle, ts_cast_hit *best)
{
	/* Leave out triangles without area, the backs of single-sided ones, and those whose edges the ray does not pass on
	 * one side. */
	ts_corners t = ts_k_corners(&args->scene, triangle);
	if (ts_k_is_degenerate(t.n) || !ts_k_is_facing(&args->scene, triangle, &t, ray->o)) return;
	if (!ts_k_cast_inside(ray, &t)) return;
	/* Keep the hit if it is the first on the ray; of equal distances the lower index wins, so that the order of the
	 * search changes nothing. */
	ts_hit hit = ts_k_hit(ray->o, ray->d, &t);
	if (!(hit.t > 0.0f) || hit.t > best->t || (hit.t == best->t && triangle >= best->triangle)) return;
	/* Let the ray pass where a mask cuts the surface away; this comes last, since it reads a texture. */
	if (ts_k_is_cut(&args->scene, triangle, hit.weights, t.n, args->leaf)) return;
	best->t = hit.t;
	best->triangle = triangle;
	best->weights = hit.weights;
}

/* Pushes the children of a node, the nearest last: the octants in the reverse of the order in which the ray meets
 * them. */
TS_FN u32 ts_k_cast_push(const ts_cast_ray *ray, TS_GLOBAL const ts_node *node, u32 *stack, u32 n)
{
	u32 turn = (ray->d.x < 0.0f ? 1u : 0u) | (ray->d.y < 0.0f ? 2u : 0u) | (ray->d.z < 0.0f ? 4u : 0u);
	for (u32 k = 8u; k-- > 0u;) {
		u32 octant = k ^ turn;
		if (((node->children >> octant) & 1u) == 0u) continue;
		stack[n] = node->child + ts_k_count_bits(node->children & ((1u << octant) - 1u));
		n++;
	}
	return n;
}

/* The first hit of the ray from o in the unit direction d. */
TS_FN ts_cast_hit ts_k_cast(const ts_cast_args *args, ts_v3 o, ts_v3 d)
{
	/* Start at the root, with no hit: 2^62 stands for infinity. */
	u32 stack[TS_CAST_STACK];
	u32 n = 1u;
	ts_cast_ray ray = ts_k_cast_ray(o, d);
	ts_cast_hit best;
	best.t = TS_MOST_INPUT;
	best.triangle = TS_NONE;
	best.weights = ts_v3_make(0.0f, 0.0f, 0.0f);
	stack[0] = 0u;
	while (n > 0u) {
		/* Take the next node; leave it out unless the ray enters its box before the best hit. */
		n--;
		u32 id = stack[n];
		TS_GLOBAL const ts_node *node = &args->nodes[id];
		if (!ts_k_cast_meets(&ray, node, best.t)) continue;
		/* Descend into an inner node. */
		if (node->children != 0u) {
			n = ts_k_cast_push(&ray, node, stack, n);
			continue;
		}
		/* Test the triangles of a leaf. */
		u32 leaf = id - args->first_leaf;
		for (u32 k = args->offset[leaf]; k < args->offset[leaf + 1u]; k++) {
			ts_k_cast_triangle(args, &ray, args->triangles[k], &best);
		}
	}
	return best;
}

#endif
