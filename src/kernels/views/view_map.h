/* Rendered pairs in dual-paraboloid maps, one a node of views (MegaViews section 3.2; METHODS 13): the distance between
 * the middles of the two nodes in one texel, by 64-bit minimum. Leaves wider than a texel may be splatted into a
 * coarser level of a pyramid over the map, whose texels show through where finer ones are empty. */
#ifndef TS_KERNELS_VIEW_MAP_H
#define TS_KERNELS_VIEW_MAP_H
#include "../base/args.h"
#include "traverse.h"

/* A pyramid: level l is two maps of n >> l texels a side. */
typedef struct {
	u32 n, levels;
} ts_pyramid;

/* Texels before a level; those of all levels, before the last but one. */
TS_FN u32 ts_k_pyramid_first(const ts_pyramid *pyramid, u32 level)
{
	u32 sum = 0u;
	for (u32 l = 0u; l < level; l++) sum += 2u * (pyramid->n >> l) * (pyramid->n >> l);
	return sum;
}

TS_FN u32 ts_k_pyramid_texels(const ts_pyramid *pyramid) { return ts_k_pyramid_first(pyramid, pyramid->levels); }

/* Texel of the level above a texel of the finest. */
TS_FN u32 ts_k_pyramid_above(const ts_pyramid *pyramid, u32 texel, u32 level)
{
	u32 n = pyramid->n;
	u32 side = n >> level;
	u32 row = ((texel / n) % n) >> level;
	u32 column = (texel % n) >> level;
	return ts_k_pyramid_first(pyramid, level) + ((texel / (n * n)) * side + row) * side + column;
}

#define TS_ROWS_ts_view_map_args(ARG) \
	ARG(IN, ts_node, nodes, octree_node) \
	ARG(IN, ts_node, views, view_octree_node) \
	ARG(IN, u64, pairs, traverse_rendered) /* or what is left of a queue */ \
	ARG(MIN, u64, texels, view_map_depth_node) \
	ARG(VALUE, ts_pyramid, pyramid, none)
TS_ARGS(ts_view_map_args);

/* ceil(log2(size)), seen from the middle of the views; at most the last. */
TS_FN u32 ts_k_map_level(const ts_pyramid *pyramid, ts_v3 vs, f32 d, f32 radius)
{
	if (pyramid->levels == 1u) return 0u;
	f32 divisor = d > 0.0f ? d : 1.0f;
	f32 sine = d > radius ? radius / divisor : 1.0f;
	f32 size = ts_k_paraboloid_size(ts_abs(vs.x) / divisor, sine, pyramid->n);
	u32 level = 0u;
	while (level + 1u < pyramid->levels && (f32)(1u << level) < size) level++;
	return level;
}

TS_FN void ts_k_map_pair(const ts_view_map_args *args, u64 pair)
{
	TS_GLOBAL const ts_node *node = &args->nodes[ts_k_pair_node(pair)];
	u32 v = ts_k_pair_views(pair);
	ts_v3 vs = ts_sub(ts_load3(node->centre), ts_load3(args->views[v].centre));
	f32 d = ts_length(vs);
	u32 level = ts_k_map_level(&args->pyramid, vs, d, node->radius);
	u32 texel = ts_k_pyramid_above(&args->pyramid, ts_k_paraboloid_texel(vs, args->pyramid.n), level);
	u64 key = ((u64)ts_f2u(ts_put(d)) << 32) | ts_k_pair_node(pair);
	ts_min_u64(&args->texels[(u64)v * ts_k_pyramid_texels(&args->pyramid) + texel], key);
}

/* scatter over pairs */
TS_FN void ts_k_view_map_item(const ts_view_map_args *args, u64 i)
{
	if (args->pairs[i] < TS_STRUCK) ts_k_map_pair(args, args->pairs[i]);
}

/* What is in a texel of the map at `texels`, or in the finest level above that has something; TS_EMPTY: none has. */
TS_FN u64 ts_k_map_key(TS_GLOBAL const u64 *texels, const ts_pyramid *pyramid, u32 texel)
{
	u64 key = TS_EMPTY;
	for (u32 level = 0u; level < pyramid->levels && key == TS_EMPTY; level++) {
		key = texels[ts_k_pyramid_above(pyramid, texel, level)];
	}
	return key;
}

#endif
