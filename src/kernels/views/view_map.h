/* Renders pairs into dual-paraboloid maps, one map per node of views (MegaViews section 3.2; METHODS 13): the distance
 * between the middles of the two nodes, by 64-bit minimum, in the texels whose middle meets the scene node's ball.
 * The paper's rule (view_map.texel=point) writes it only into the texel of the node's middle, and a leaf wider than a
 * texel into all texels that it covers. */
#ifndef TS_KERNELS_VIEWS_VIEW_MAP_H
#define TS_KERNELS_VIEWS_VIEW_MAP_H
#include "kernels/base/args.h"
#include "kernels/views/cap.h"
#include "kernels/views/traverse.h"

/* A pyramid: level l is two maps of n >> l texels per side. */
typedef struct ts_pyramid {
	u32 n, levels;
	u32 point; /* view_map.texel=point */
	f32 fill;  /* radius of the ball that is filled, in radii of the node; 0: only the texel of its middle */
} ts_pyramid;

/* Number of texels before a level; with level = levels that of all levels. */
TS_FN u32 ts_k_pyramid_first(const ts_pyramid *pyramid, u32 level)
{
	u32 sum = 0u;
	for (u32 l = 0u; l < level; l++) sum += 2u * (pyramid->n >> l) * (pyramid->n >> l);
	return sum;
}

TS_FN u32 ts_k_pyramid_texels(const ts_pyramid *pyramid) { return ts_k_pyramid_first(pyramid, pyramid->levels); }

/* The texel of a level that contains a texel of the finest level. */
TS_FN u32 ts_k_pyramid_above(const ts_pyramid *pyramid, u32 texel, u32 level)
{
	u32 n = pyramid->n;
	u32 side = n >> level;
	u32 row = ((texel / n) % n) >> level;
	u32 column = (texel % n) >> level;
	return ts_k_pyramid_first(pyramid, level) + ((texel / (n * n)) * side + row) * side + column;
}

#define TS_ROWS_ts_own_args(ARG) \
	ARG(IN_OPT, u32, reflectors, octree_reflector) /* NULL: views are not from the middles of cubes */ \
	ARG(IN_OPT, u32, leaves, view_octree_leaf)
TS_ARGS(ts_own_args);

TS_FN u32 ts_k_ancestor(TS_GLOBAL const ts_node *nodes, u32 node, u32 level)
{
	while (nodes[node].level > level) node = nodes[node].parent;
	return node;
}

/* Whether the node belongs to a reflector whose own view is among those of the pair. */
TS_FN bool ts_k_pair_is_own(const ts_own_args *own, TS_GLOBAL const ts_node *views, u64 pair)
{
	u32 reflector = own->reflectors != NULL ? own->reflectors[ts_k_pair_node(pair)] : TS_NONE;
	u32 v = ts_k_pair_views(pair);
	return reflector != TS_NONE && ts_k_ancestor(views, own->leaves[reflector], views[v].level) == v;
}

#define TS_ROWS_ts_view_map_args(ARG) \
	ARG(IN, ts_node, nodes, octree_node) \
	ARG(IN, ts_node, views, view_octree_node) \
	ARG(IN, u64, pairs, traverse_rendered) /* or the pairs that are left of a queue */ \
	ARG(MIN, u64, texels, view_map_depth_node) \
	ARG(INNER, ts_own_args, own, none) \
	ARG(VALUE, ts_pyramid, pyramid, none)
TS_ARGS(ts_view_map_args);

/* Whether the cap fills the texel, but not the coarser texel that contains it. */
TS_FN bool ts_k_cap_is_filled(const ts_cap *cap, const ts_pyramid *pyramid, u32 level, u32 column, u32 row)
{
	if (!(ts_k_cap_inside(cap, pyramid->n, level, column, row) >= 0.0f)) return false;
	bool last = level + 1u == pyramid->levels;
	return last || !(ts_k_cap_inside(cap, pyramid->n, level + 1u, column >> 1u, row >> 1u) >= 0.0f);
}

/* Fills the texels of the front or the back of a map that the cap covers. */
TS_FN void ts_k_cap_fill(TS_GLOBAL u64 *map, const ts_pyramid *pyramid, const ts_cap *cap, bool back, u64 key)
{
	ts_cap_box box = ts_k_cap_box(cap, pyramid->n);
	if (box.x.from >= box.x.to || box.y.from >= box.y.to) return;
	for (u32 level = 0u; level < pyramid->levels; level++) {
		u32 side = pyramid->n >> level;
		TS_GLOBAL u64 *texels = map + ts_k_pyramid_first(pyramid, level) + (back ? side * side : 0u);
		for (u32 row = (u32)box.y.from >> level; row <= ((u32)box.y.to - 1u) >> level; row++) {
			for (u32 column = (u32)box.x.from >> level; column <= ((u32)box.x.to - 1u) >> level; column++) {
				u64 at = (u64)row * (u64)side + (u64)column;
				if (ts_k_cap_is_filled(cap, pyramid, level, column, row)) ts_min_u64(&texels[at], key);
			}
		}
	}
}

/* Width of a ball in texels. A ball no wider than a texel is only in the texel of its middle. */
TS_FN f32 ts_k_map_width(const ts_pyramid *pyramid, ts_v3 vs, f32 radius)
{
	f32 d = ts_length(vs);
	return d > radius ? ts_k_paraboloid_size(ts_abs(vs.x) / d, radius / d, pyramid->n) : 2.0f * (f32)pyramid->n;
}

TS_FN void ts_k_map_pair(const ts_view_map_args *args, u64 pair)
{
	/* Make the key from the distance between the middles and the node: the nearest node wins, and of equally near ones
	 * the lowest. */
	TS_GLOBAL const ts_node *node = &args->nodes[ts_k_pair_node(pair)];
	u32 v = ts_k_pair_views(pair);
	ts_v3 vs = ts_sub(ts_load3(node->centre), ts_load3(args->views[v].centre));
	u64 key = ((u64)ts_f2u(ts_put(ts_length(vs))) << 32) | ts_k_pair_node(pair);
	/* Find the map of the node of views, and the radius of the ball to fill. */
	TS_GLOBAL u64 *map = args->texels + (u64)v * ts_k_pyramid_texels(&args->pyramid);
	f32 radius = node->radius * args->pyramid.fill;
	/* Render the middle as a point, as the paper does; go on to fill the ball only if it is wider than a texel
	 * (MegaViews 3.2, "Multi-Pixel Filling"). */
	if (args->pyramid.point != 0u) {
		ts_min_u64(&map[ts_k_paraboloid_texel(vs, args->pyramid.n)], key);
		if (!(radius > 0.0f) || !(ts_k_map_width(&args->pyramid, vs, radius) > 1.0f)) return;
	}
	/* Fill the texels of both maps whose middle is a direction that meets the ball. */
	for (u32 side = 0u; side < 2u; side++) {
		ts_cap cap = ts_k_cap(vs, radius, side == 1u);
		ts_k_cap_fill(map, &args->pyramid, &cap, side == 1u, key);
	}
}

/* scatter over pairs */
TS_FN void ts_k_view_map_item(const ts_view_map_args *args, u64 i)
{
	u64 pair = args->pairs[i];
	if (pair < TS_STRUCK && !ts_k_pair_is_own(&args->own, args->views, pair)) ts_k_map_pair(args, pair);
}

/* The nearest key in a texel of the map at `texels` and in the coarser texels above it; TS_EMPTY: none. */
TS_FN u64 ts_k_map_key(TS_GLOBAL const u64 *texels, const ts_pyramid *pyramid, u32 texel)
{
	u64 key = TS_EMPTY;
	for (u32 level = 0u; level < pyramid->levels; level++) {
		u64 there = texels[ts_k_pyramid_above(pyramid, texel, level)];
		key = there < key ? there : key;
	}
	return key;
}

#endif
