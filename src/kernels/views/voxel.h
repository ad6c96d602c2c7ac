/* The leaf voxels that a triangle touches: exactly those whose closed box meets the triangle snapped to the lattice
 * (octree_root.h). The posed triangle is at most half a step and the rounding error away from the snapped one, less
 * than a hundredth of a voxel.
 *
 * Box and triangle meet unless one of 13 axes separates them (Akenine-Moller 2001): the three of the box, the normal,
 * and the products of edges and box axes, which are the normals of the edges seen along each axis (Schwarz and Seidel
 * 2010). Each test asks whether a linear form of the voxel's indices is in a range, so voxels are found by narrowing
 * ranges: rows, then columns along the normal's longest component, then the few voxels of a column. Triangles that are
 * a line or a point in the lattice are treated alike.
 *
 * Coordinates are at most 2^19 in the lattice. The factors of an edge's form are at most 2^27, its values 2^40; those
 * of the normal's form 2^47 and 3 2^58, so that differences of two values stay below 2^62. */
#ifndef TS_KERNELS_VIEWS_VOXEL_H
#define TS_KERNELS_VIEWS_VOXEL_H
#include "kernels/base/args.h"
#include "kernels/base/closest.h"
#include "kernels/base/hit.h"
#include "kernels/base/surface.h"
#include "kernels/views/mask.h"
#include "kernels/views/octree_root.h"

/* low <= a i + b j + c k <= high */
typedef struct {
	i64 a, b, c, low, high;
} ts_form;
typedef struct {
	i64 first, last;
} ts_range;

/* A triangle in coordinates that are turned until the normal's longest component is the third. */
typedef struct {
	ts_range box[3];
	ts_form edge[9]; /* seen along the third axis, the first, the second */
	ts_form plane;
	u32 turn; /* the axis that is the third one here */
} ts_touch;

TS_FN i64 ts_k_least_i64(i64 a, i64 b) { return b < a ? b : a; }
TS_FN i64 ts_k_most_i64(i64 a, i64 b) { return a < b ? b : a; }

/* The part of a range with low <= step k <= high. */
TS_FN ts_range ts_k_narrow(ts_range r, i64 step, i64 low, i64 high)
{
	/* Turn both bounds so that the step is positive, or 0. */
	i64 from = step < 0 ? -high : low;
	i64 to = step < 0 ? -low : high;
	i64 size = step < 0 ? -step : step;
	/* Measure the bounds from the first voxel of the range. */
	i64 above = from - size * r.first;
	i64 room = to - size * r.first;
	/* Return early if nothing fits, or if a step of 0 keeps the whole range. */
	ts_range none;
	none.first = 0;
	none.last = -1;
	if (room < 0 || (size == 0 && above > 0)) return none;
	if (size == 0) return r;
	/* Round the quotients inward. None of the numbers is negative here, and unsigned division is the same in GLSL. */
	r.last = ts_k_least_i64(r.last, r.first + (i64)((u64)room / (u64)size));
	r.first = above > 0 ? r.first + (i64)((u64)(above + size - 1) / (u64)size) : r.first;
	return r;
}

/* The form of voxels (i, j, k) for which n.(256 (i, j, k) + box) meets [low, high]. */
TS_FN ts_form ts_k_form(i64 a, i64 b, i64 c, i64 low, i64 high)
{
	ts_form r;
	r.a = TS_VOXEL * a;
	r.b = TS_VOXEL * b;
	r.c = TS_VOXEL * c;
	r.low = low - (ts_k_most_i64(r.a, 0) + ts_k_most_i64(r.b, 0) + ts_k_most_i64(r.c, 0));
	r.high = high - (ts_k_least_i64(r.a, 0) + ts_k_least_i64(r.b, 0) + ts_k_least_i64(r.c, 0));
	return r;
}

/* The normal (a, b) of the edge from p to q seen along an axis, and the interval of the triangle, which lies between
 * the edge and o. */
typedef struct {
	i64 a, b, low, high;
} ts_side;

TS_FN ts_side ts_k_side(i64 pu, i64 pv, i64 qu, i64 qv, i64 ou, i64 ov)
{
	ts_side r;
	r.a = pv - qv;
	r.b = qu - pu;
	i64 at = r.a * pu + r.b * pv;
	i64 beyond = r.a * ou + r.b * ov;
	r.low = ts_k_least_i64(at, beyond);
	r.high = ts_k_most_i64(at, beyond);
	return r;
}

/* Edge k seen along the three axes. */
TS_FN void ts_k_touch_edge(ts_touch *t, u32 k, const ts_i3 *p, const ts_i3 *q, const ts_i3 *o)
{
	ts_side s = ts_k_side(p->x, p->y, q->x, q->y, o->x, o->y);
	t->edge[k] = ts_k_form(s.a, s.b, 0, s.low, s.high);
	s = ts_k_side(p->y, p->z, q->y, q->z, o->y, o->z);
	t->edge[k + 3u] = ts_k_form(0, s.a, s.b, s.low, s.high);
	s = ts_k_side(p->z, p->x, q->z, q->x, o->z, o->x);
	t->edge[k + 6u] = ts_k_form(s.b, 0, s.a, s.low, s.high);
}

/* The range of voxels whose closed interval meets that of the coordinates. */
TS_FN ts_range ts_k_touch_range(i32 a, i32 b, i32 c, i32 last)
{
	i32 low = ts_min_i32(a, ts_min_i32(b, c));
	i32 high = ts_max_i32(a, ts_max_i32(b, c));
	ts_range r;
	r.first = ts_max_i32(((low + TS_VOXEL - 1) >> TS_VOXEL_BITS) - 1, 0);
	r.last = ts_min_i32(high >> TS_VOXEL_BITS, last);
	return r;
}

typedef struct {
	i64 x, y, z;
} ts_l3;

TS_FN ts_l3 ts_k_lattice_normal(ts_i3 a, ts_i3 b, ts_i3 c)
{
	ts_l3 r;
	i64 ux = b.x - a.x;
	i64 uy = b.y - a.y;
	i64 uz = b.z - a.z;
	i64 vx = c.x - a.x;
	i64 vy = c.y - a.y;
	i64 vz = c.z - a.z;
	r.x = uy * vz - uz * vy;
	r.y = uz * vx - ux * vz;
	r.z = ux * vy - uy * vx;
	return r;
}

TS_FN ts_i3 ts_k_turned(ts_i3 p, u32 turn)
{
	return turn == 0u ? ts_i3_make(p.y, p.z, p.x) : turn == 1u ? ts_i3_make(p.z, p.x, p.y) : p;
}

TS_FN ts_i3 ts_k_turned_back(ts_i3 p, u32 turn)
{
	return turn == 0u ? ts_i3_make(p.z, p.x, p.y) : turn == 1u ? ts_i3_make(p.y, p.z, p.x) : p;
}

/* The axis of the normal's longest component; of equal components the lowest axis. */
TS_FN u32 ts_k_touch_turn(ts_l3 n)
{
	i64 x = n.x < 0 ? -n.x : n.x;
	i64 y = n.y < 0 ? -n.y : n.y;
	i64 z = n.z < 0 ? -n.z : n.z;
	return x >= y && x >= z ? 0u : y >= z ? 1u : 2u;
}

/* Sets up the tests of a triangle with corners a, b, c in the lattice; voxels have indices up to `last`. */
TS_FN ts_touch ts_k_touch(ts_i3 a, ts_i3 b, ts_i3 c, i32 last)
{
	ts_touch r;
	/* Turn the axes so that the normal's longest component is the third: then a column meets few voxels. */
	r.turn = ts_k_touch_turn(ts_k_lattice_normal(a, b, c));
	a = ts_k_turned(a, r.turn);
	b = ts_k_turned(b, r.turn);
	c = ts_k_turned(c, r.turn);
	/* Set the tests of the box's three axes (Akenine-Moller 2001; Schwarz and Seidel 2010). */
	r.box[0] = ts_k_touch_range(a.x, b.x, c.x, last);
	r.box[1] = ts_k_touch_range(a.y, b.y, c.y, last);
	r.box[2] = ts_k_touch_range(a.z, b.z, c.z, last);
	/* Set the tests of the nine products of edges and axes. */
	ts_k_touch_edge(&r, 0u, &a, &b, &c);
	ts_k_touch_edge(&r, 1u, &b, &c, &a);
	ts_k_touch_edge(&r, 2u, &c, &a, &b);
	/* Set the test of the normal, along which the triangle is a point. */
	ts_l3 n = ts_k_lattice_normal(a, b, c);
	i64 at = n.x * a.x + n.y * a.y + n.z * a.z;
	r.plane = ts_k_form(n.x, n.y, n.z, at, at);
	return r;
}

/* The range of voxels i of row j, seen along the third axis. */
TS_FN ts_range ts_k_touch_row(const ts_touch *t, i64 j)
{
	ts_range r = t->box[0];
	for (u32 e = 0u; e < 3u; e++) {
		i64 at = t->edge[e].b * j;
		r = ts_k_narrow(r, t->edge[e].a, t->edge[e].low - at, t->edge[e].high - at);
	}
	return r;
}

/* The range of voxels k of column (i, j) that the plane meets. */
TS_FN ts_range ts_k_touch_column(const ts_touch *t, i64 i, i64 j)
{
	i64 at = t->plane.a * i + t->plane.b * j;
	return ts_k_narrow(t->box[2], t->plane.c, t->plane.low - at, t->plane.high - at);
}

/* The tests of the remaining axes. */
TS_FN bool ts_k_touch_voxel(const ts_touch *t, i64 i, i64 j, i64 k)
{
	for (u32 e = 3u; e < 9u; e++) {
		i64 at = t->edge[e].a * i + t->edge[e].b * j + t->edge[e].c * k;
		if (at < t->edge[e].low || at > t->edge[e].high) return false;
	}
	return true;
}

#define TS_ROWS_ts_voxel_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_root, root, octree_root) \
	ARG(SUM_OPT, u64, mask, voxel_mask) /* NULL: the mask is finished; lists are made */ \
	ARG(IN, u64, bits, voxel_mask)      /* the finished mask */ \
	ARG(IN, u32, before, voxel_before) \
	ARG(SUM, u32, offset, octree_offset)          /* [k + 1]: count, start, then end of list k */ \
	ARG(OUT_OPT, u32, triangles, octree_triangle) /* NULL: they are counted */ \
	ARG(VALUE, u32, levels, none) \
	ARG(VALUE, u32, first_leaf, none) /* a node */
TS_ARGS(ts_voxel_args);

/* The weights of the triangle's point nearest to p. */
TS_FN ts_v3 ts_k_nearest_weights(const ts_corners *t, ts_v3 p)
{
	return ts_k_hit_barycentrics(ts_k_closest_on_triangle(p, t->a, t->b, t->c), t);
}

/* Whether a masked triangle has a hole at its point nearest to the voxel's middle, with the footprint of a voxel. Such
 * a triangle is not in the voxel. */
TS_FN bool ts_k_voxel_is_cut(const ts_voxel_args *args, u32 triangle, const ts_corners *t, ts_i3 voxel)
{
	if (!ts_k_is_masked(&args->scene, triangle)) return false;
	ts_v3 w = ts_k_nearest_weights(t, ts_k_voxel_middle(args->root, args->levels, voxel));
	return ts_k_is_below_cutoff(&args->scene, triangle, w, t->n, ts_k_voxel_side(args->root, args->levels));
}

/* Adds to the mask, to the count of a leaf, or to its list, in the order of arrival, until leaf_sort sorts the list. */
TS_FN void ts_k_voxel_meet(const ts_voxel_args *args, u32 triangle, const ts_corners *t, ts_i3 voxel)
{
	if (ts_k_voxel_is_cut(args, triangle, t, voxel)) return;
	u64 code = ts_k_morton(voxel);
	if (args->mask != NULL) {
		ts_or_u64(&args->mask[ts_k_mask_word(args->levels, code)], ts_k_mask_bit(code));
		return;
	}
	u32 leaf = ts_k_mask_id(args->bits, args->before, args->levels, code) - args->first_leaf;
	u32 place = ts_next_u32(&args->offset[leaf + 1u]);
	if (args->triangles != NULL) args->triangles[place] = triangle;
}

/* scatter over triangles: into the mask, the counts of the leaves, or their lists */
TS_FN void ts_k_voxel_item(const ts_voxel_args *args, u64 i)
{
	/* Leave out triangles without area. */
	ts_corners t = ts_k_corners(&args->scene, (u32)i);
	if (ts_k_is_degenerate(t.n)) return;
	/* Snap the corners to the lattice, on which all tests are exact integers. */
	ts_i3 a = ts_k_root_place(args->root, args->levels, t.a);
	ts_i3 b = ts_k_root_place(args->root, args->levels, t.b);
	ts_i3 c = ts_k_root_place(args->root, args->levels, t.c);
	ts_touch touch = ts_k_touch(a, b, c, (i32)(1u << args->levels) - 1);
	/* Narrow the voxels to rows, to ranges of columns, and to the few voxels of a column. */
	for (i64 y = touch.box[1].first; y <= touch.box[1].last; y++) {
		ts_range row = ts_k_touch_row(&touch, y);
		for (i64 x = row.first; x <= row.last; x++) {
			ts_range column = ts_k_touch_column(&touch, x, y);
			for (i64 z = column.first; z <= column.last; z++) {
				/* Test the axes that are left, and enter the voxel, its axes turned back. */
				if (!ts_k_touch_voxel(&touch, x, y, z)) continue;
				ts_k_voxel_meet(args, (u32)i, &t, ts_k_turned_back(ts_i3_make((i32)x, (i32)y, (i32)z), touch.turn));
			}
		}
	}
}

#endif
