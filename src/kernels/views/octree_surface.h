/* What is in each node of the scene's octree: in a leaf the mean of its triangles, each seen at its point nearest to
 * the middle, a leaf's side wide; in an inner node the mean of its children (MegaViews section 3.1). Sums go by the
 * order of triangles and of octants. */
#ifndef TS_KERNELS_OCTREE_SURFACE_H
#define TS_KERNELS_OCTREE_SURFACE_H
#include "../base/args.h"
#include "../base/closest.h"
#include "../base/hit.h"
#include "../base/morton.h"
#include "../raster/rsm.h"

#define TS_ROWS_ts_octree_surface_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_root, root, octree_root) \
	ARG(IN, ts_node, nodes, octree_node) \
	ARG(IN, u32, offset, octree_offset) \
	ARG(IN, u32, triangles, octree_triangle) \
	ARG(OUT, ts_node_surface, surfaces, octree_surface) \
	ARG(VALUE, u32, levels, none) \
	ARG(VALUE, u32, first, none) /* node of item 0 */
TS_ARGS(ts_octree_surface_args);

TS_FN void ts_k_node_surface_store(TS_GLOBAL ts_node_surface *node, ts_v3 albedo, ts_v3 normal, u32 n)
{
	f32 share = (f32)(n != 0u ? n : 1u);
	ts_store3(node->albedo, ts_v3_make(albedo.x / share, albedo.y / share, albedo.z / share));
	ts_store3(node->normal, ts_v3_make(normal.x / share, normal.y / share, normal.z / share));
	node->pad0 = 0u;
	node->pad1 = 0u;
}

TS_FN ts_surface ts_k_surface_near(const ts_arrays *scene, u32 triangle, ts_v3 p, f32 footprint)
{
	ts_corners t = ts_k_corners(scene, triangle);
	ts_v3 nearest = ts_k_closest_on_triangle(p, t.a, t.b, t.c);
	return ts_k_surface(scene, triangle, ts_k_hit_barycentrics(nearest, &t), footprint);
}

/* map over leaves */
TS_FN void ts_k_leaf_surface_item(const ts_octree_surface_args *args, u64 i)
{
	u32 from = args->offset[i];
	u32 to = args->offset[i + 1u];
	ts_v3 albedo = ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_v3 normal = albedo;
	f32 side = args->root->side / (f32)(1 << args->levels);
	ts_v3 middle = ts_load3(args->nodes[args->first + i].centre);
	for (u32 k = from; k < to; k++) {
		ts_surface s = ts_k_surface_near(&args->scene, args->triangles[k], middle, side);
		albedo = ts_add(albedo, ts_k_albedo(&s));
		normal = ts_add(normal, s.n);
	}
	ts_k_node_surface_store(&args->surfaces[args->first + i], albedo, normal, to - from);
}

/* map over nodes of a level whose children are done */
TS_FN void ts_k_inner_surface_item(const ts_octree_surface_args *args, u64 i)
{
	TS_GLOBAL const ts_node *node = &args->nodes[args->first + i];
	u32 n = ts_k_count_bits(node->children);
	ts_v3 albedo = ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_v3 normal = albedo;
	for (u32 k = 0u; k < n; k++) {
		TS_GLOBAL const ts_node_surface *child = &args->surfaces[node->child + k];
		albedo = ts_add(albedo, ts_load3(child->albedo));
		normal = ts_add(normal, ts_load3(child->normal));
	}
	ts_k_node_surface_store(&args->surfaces[args->first + i], albedo, normal, n);
}

#endif
