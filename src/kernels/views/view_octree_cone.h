/* The cones of the view octree (MegaViews section 3.1, figure 3; METHODS 12): the axis of a node is along the sum of
 * the directions of the views below it, the angle is the greatest between the axis and one of the directions. Sums are
 * integers in units of 2^-30, of fewer than 2^32 views, so below 2^62. The least cosine is a minimum of ordered bits
 * (octree_root.h). */
#ifndef TS_KERNELS_VIEWS_VIEW_OCTREE_CONE_H
#define TS_KERNELS_VIEWS_VIEW_OCTREE_CONE_H
#include "kernels/base/args.h"
#include "kernels/views/mask.h"
#include "kernels/views/octree_root.h"

#define TS_ROWS_ts_cone_args(ARG) \
	ARG(IN, ts_vpl, views, vpl_light) \
	ARG(IN, ts_node, nodes, view_octree_node) \
	ARG(IN, u32, offset, view_octree_offset) \
	ARG(IN, u32, entries, view_octree_view) \
	ARG(IN, u32, leaf, view_octree_leaf) \
	ARG(OUT, u64, sums, view_octree_cone_sum) \
	ARG(MIN, u32, least, view_octree_cone_least) \
	ARG(OUT, ts_cone, cones, view_octree_cone) \
	ARG(VALUE, u32, first, none) /* node of item 0 */
TS_ARGS(ts_cone_args);

TS_FN void ts_k_cone_store(const ts_cone_args *args, u64 node, const u64 *sum, u32 first, u32 n)
{
	TS_GLOBAL ts_cone *cone = &args->cones[node];
	ts_v3 axis = ts_normalize(ts_v3_make((f32)(i64)sum[0], (f32)(i64)sum[1], (f32)(i64)sum[2]));
	bool any = ts_length(axis) > 0.0f;
	ts_store3(cone->axis, any ? axis : ts_v3_make(0.0f, 0.0f, 1.0f));
	cone->cosine = 0.0f;
	cone->first = first;
	cone->views = n;
	cone->pad[0] = 0u;
	cone->pad[1] = 0u;
	for (u32 k = 0u; k < 3u; k++) args->sums[node * 3u + k] = sum[k];
}

/* map over leaves */
TS_FN void ts_k_cone_leaf_item(const ts_cone_args *args, u64 i)
{
	u32 from = args->offset[i];
	u32 to = args->offset[i + 1u];
	u64 sum[3];
	for (u32 k = 0u; k < 3u; k++) sum[k] = 0u;
	for (u32 v = from; v < to; v++) {
		TS_GLOBAL const f32 *direction = args->views[args->entries[v]].normal;
		for (u32 k = 0u; k < 3u; k++) sum[k] += (u64)(i64)ts_fix(direction[k], 30, 31);
	}
	ts_k_cone_store(args, args->first + i, sum, from, to - from);
}

/* map over nodes of a level whose children are done */
TS_FN void ts_k_cone_inner_item(const ts_cone_args *args, u64 i)
{
	TS_GLOBAL const ts_node *node = &args->nodes[args->first + i];
	u64 sum[3];
	u32 n = 0u;
	for (u32 k = 0u; k < 3u; k++) sum[k] = 0u;
	for (u32 c = 0u; c < ts_k_count_bits(node->children); c++) {
		u64 child = node->child + c;
		for (u32 k = 0u; k < 3u; k++) sum[k] += args->sums[child * 3u + k];
		n += args->cones[child].views;
	}
	ts_k_cone_store(args, args->first + i, sum, args->cones[node->child].first, n);
}

/* scatter over views: into the nodes above each */
TS_FN void ts_k_cone_least_item(const ts_cone_args *args, u64 i)
{
	ts_v3 direction = ts_load3(args->views[i].normal);
	for (u32 node = args->leaf[i]; node != TS_NONE; node = args->nodes[node].parent) {
		f32 cosine = ts_put(ts_dot(direction, ts_load3(args->cones[node].axis)));
		ts_min_u32(&args->least[node], ts_k_ordered(ts_clamp(cosine, -1.0f, 1.0f)));
	}
}

/* map over nodes */
TS_FN void ts_k_cone_item(const ts_cone_args *args, u64 i)
{
	args->cones[i].cosine = ts_put(ts_k_of_ordered(args->least[i]));
}

#endif
