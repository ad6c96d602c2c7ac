/* Fused maps for every node of views (MegaViews section 3.2, "Image Queries"; METHODS 13): level by level from the
 * root, the node that a texel of the parent's map shows is moved to the child's middle, within its texel.
 * view_map.fusion=min keeps the nearer of the moved node and the child's own, view_map.fusion=paper the child's own
 * wherever there is one. A query computes one texel of a fused map without making the maps. */
#ifndef TS_KERNELS_VIEWS_VIEW_MAP_FUSE_H
#define TS_KERNELS_VIEWS_VIEW_MAP_FUSE_H
#include "kernels/base/args.h"
#include "kernels/views/view_map.h"

#define TS_ROWS_ts_view_map_fuse_args(ARG) \
	ARG(IN, ts_node, views, view_octree_node) \
	ARG(IN, u64, texels, view_map_depth_node) \
	ARG(OUT, u32, depths, view_map_fused_depth) \
	ARG(OUT, u32, nodes, view_map_fused_node) \
	ARG(VALUE, ts_pyramid, pyramid, none) \
	ARG(VALUE, u32, first, none)   /* node of the level */ \
	ARG(VALUE, u32, nearest, none) /* view_map.fusion=min */
TS_ARGS(ts_view_map_fuse_args);

/* The distance from b of the point that lies `distance` from a in the direction of a texel's middle. */
TS_FN f32 ts_k_moved_depth(ts_v3 a, f32 distance, ts_v3 b, u32 texel, u32 n)
{
	ts_v3 q = ts_mad(a, ts_k_paraboloid_direction(texel, n), distance);
	return ts_length(ts_sub(q, b));
}

/* The fused texel of a node, distance << 32 | node of the scene, from that of its parent, `above`; TS_EMPTY:
 * nothing. */
TS_FN u64 ts_k_fused(const ts_view_map_fuse_args *args, u32 node, u64 above, u32 texel)
{
	u64 first = (u64)node * ts_k_pyramid_texels(&args->pyramid);
	u64 own = ts_k_map_key(args->texels + first, &args->pyramid, texel);
	if (above == TS_EMPTY || (own != TS_EMPTY && args->nearest == 0u)) return own;
	ts_v3 a = ts_load3(args->views[args->views[node].parent].centre);
	ts_v3 b = ts_load3(args->views[node].centre);
	f32 moved = ts_k_moved_depth(a, ts_u2f((u32)(above >> 32)), b, texel, args->pyramid.n);
	u64 key = ((u64)ts_f2u(ts_put(moved)) << 32) | (u32)above;
	return key < own ? key : own;
}

/* map over the texels of the nodes of a level */
TS_FN void ts_k_view_map_fuse_item(const ts_view_map_fuse_args *args, u64 i)
{
	u32 n_texels = 2u * args->pyramid.n * args->pyramid.n;
	u32 node = args->first + (u32)(i / n_texels);
	u32 texel = (u32)(i % n_texels);
	u32 parent = args->views[node].parent;
	u64 of_parent = (u64)parent * n_texels + texel;
	u64 above = parent != TS_NONE ? ((u64)args->depths[of_parent] << 32) | args->nodes[of_parent] : TS_EMPTY;
	u64 key = ts_k_fused(args, node, above, texel);
	args->depths[(u64)node * n_texels + texel] = (u32)(key >> 32);
	args->nodes[(u64)node * n_texels + texel] = (u32)key;
}

#define TS_QUERY_NODES 12u /* from the root to leaves 11 levels below it */

/* view_map.fused_depth and view_map.fused_node of one texel of a node, by a walk from the root. */
TS_FN u64 ts_k_fuse_query(const ts_view_map_fuse_args *args, u32 node, u32 texel)
{
	u32 path[TS_QUERY_NODES];
	u32 n = 0u;
	u64 key = TS_EMPTY;
	for (; node != TS_NONE && n < TS_QUERY_NODES; node = args->views[node].parent) path[n++] = node;
	while (n-- > 0u) key = ts_k_fused(args, path[n], key, texel);
	return key;
}

#endif
