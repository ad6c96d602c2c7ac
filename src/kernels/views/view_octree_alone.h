/* Views without a hierarchy, as ManyLoDs renders them (MegaViews section 4.1; METHODS 13): every virtual point light is
 * a root and a leaf by itself, of radius 0. Brute force renders maps of these views from every leaf of the scene,
 * without the scene's hierarchy. */
#ifndef TS_KERNELS_VIEWS_VIEW_OCTREE_ALONE_H
#define TS_KERNELS_VIEWS_VIEW_OCTREE_ALONE_H
#include "kernels/base/args.h"
#include "kernels/views/view_map.h"

#define TS_ROWS_ts_view_octree_alone_args(ARG) \
	ARG(IN, ts_vpl, lights, vpl_light) \
	ARG(OUT, ts_node, nodes, view_octree_node) \
	ARG(OUT, ts_cone, cones, view_octree_cone) \
	ARG(OUT, u32, views, view_octree_view) \
	ARG(OUT, u32, leaves, view_octree_leaf)
TS_ARGS(ts_view_octree_alone_args);

/* map over virtual point lights */
TS_FN void ts_k_view_octree_alone_item(const ts_view_octree_alone_args *args, u64 i)
{
	/* Make the light a node of its own, a root and a leaf, as small as a point. */
	TS_GLOBAL ts_node *node = &args->nodes[i];
	TS_GLOBAL ts_cone *cone = &args->cones[i];
	ts_store3(node->centre, ts_load3(args->lights[i].position));
	node->radius = 0.0f;
	node->child = TS_NONE;
	node->children = 0u;
	node->parent = TS_NONE;
	node->level = 0u;
	/* Give it a cone of the one direction (MegaViews 3.1). */
	ts_store3(cone->axis, ts_load3(args->lights[i].normal));
	cone->cosine = 1.0f;
	cone->first = (u32)i;
	cone->views = 1u;
	cone->pad[0] = 0u;
	cone->pad[1] = 0u;
	/* List the light as the only view of its leaf. */
	args->views[i] = (u32)i;
	args->leaves[i] = (u32)i;
}

#define TS_ROWS_ts_view_map_all_args(ARG) \
	ARG(INNER, ts_traverse_args, of, none) \
	ARG(INNER, ts_view_map_args, to, none) \
	ARG(TALLY, i64, n_rendered, 0) \
	ARG(VALUE, u32, first, none) \
	ARG(VALUE, u32, n_leaves, none) /* of the scene */
TS_ARGS(ts_view_map_all_args);

/* scatter over all leaves of the scene for each view: renders those that the view may see */
TS_FN void ts_k_view_map_all_item(const ts_view_map_all_args *args, u64 i)
{
	u64 pair = ts_k_pair(args->first + (u32)(i % args->n_leaves), (u32)(i / args->n_leaves));
	if (ts_k_pair_fate(&args->of, pair) != TS_PAIR_RENDER) return;
	ts_add_i64(args->n_rendered, 1);
	ts_k_map_pair(&args->to, pair);
}

#endif
