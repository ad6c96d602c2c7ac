/* The surface in each node of the scene's octree: in a leaf the mean of its triangles, each at its point nearest to the
 * leaf's middle, with a footprint of the leaf's side; in an inner node the mean of its children (MegaViews section
 * 3.1). Sums are in the order of triangles and of octants. */
#ifndef TS_KERNELS_VIEWS_OCTREE_SURFACE_H
#define TS_KERNELS_VIEWS_OCTREE_SURFACE_H
#include "kernels/base/args.h"
#include "kernels/views/voxel.h"

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

/* Sums of surfaces, and their number. */
typedef struct {
	ts_v3 base, normal, emissive;
	f32 metallic, roughness, occlusion;
	u32 n;
} ts_surface_sum;

TS_FN ts_surface_sum ts_k_surface_sum(void)
{
	ts_surface_sum r;
	r.base = ts_v3_make(0.0f, 0.0f, 0.0f);
	r.normal = r.base;
	r.emissive = r.base;
	r.metallic = 0.0f;
	r.roughness = 0.0f;
	r.occlusion = 0.0f;
	r.n = 0u;
	return r;
}

/* Adds a surface. Unlit materials emit their base colour and reflect nothing. */
TS_FN void ts_k_surface_sum_add(ts_surface_sum *sum, const ts_surface *s)
{
	bool unlit = (s->flags & TS_UNLIT) != 0u;
	ts_v3 black = ts_v3_make(0.0f, 0.0f, 0.0f);
	sum->base = ts_add(sum->base, unlit ? black : s->base);
	sum->normal = ts_add(sum->normal, s->n);
	sum->emissive = ts_add(sum->emissive, unlit ? s->base : s->emissive);
	sum->metallic = sum->metallic + (unlit ? 1.0f : s->metallic);
	sum->roughness = sum->roughness + (unlit ? 1.0f : s->roughness);
	sum->occlusion = sum->occlusion + s->occlusion;
	sum->n++;
}

TS_FN void ts_k_surface_sum_add_node(ts_surface_sum *sum, TS_GLOBAL const ts_node_surface *node)
{
	sum->base = ts_add(sum->base, ts_load3(node->base));
	sum->normal = ts_add(sum->normal, ts_load3(node->normal));
	sum->emissive = ts_add(sum->emissive, ts_load3(node->emissive));
	sum->metallic = sum->metallic + node->metallic;
	sum->roughness = sum->roughness + node->roughness;
	sum->occlusion = sum->occlusion + node->occlusion;
	sum->n++;
}

TS_FN f32 ts_k_surface_count(const ts_surface_sum *sum) { return (f32)(sum->n != 0u ? sum->n : 1u); }

TS_FN ts_v3 ts_k_share_of(ts_v3 sum, f32 n) { return ts_v3_make(sum.x / n, sum.y / n, sum.z / n); }

TS_FN void ts_k_surface_sum_store(TS_GLOBAL ts_node_surface *node, const ts_surface_sum *sum)
{
	f32 n = ts_k_surface_count(sum);
	ts_store3(node->base, ts_k_share_of(sum->base, n));
	ts_store3(node->normal, ts_k_share_of(sum->normal, n));
	ts_store3(node->emissive, ts_k_share_of(sum->emissive, n));
	node->metallic = ts_put(sum->metallic / n);
	node->roughness = ts_put(sum->roughness / n);
	node->occlusion = ts_put(sum->occlusion / n);
}

TS_FN ts_surface ts_k_surface_near(const ts_arrays *scene, u32 triangle, ts_v3 p, f32 footprint)
{
	ts_corners t = ts_k_corners(scene, triangle);
	return ts_k_surface(scene, triangle, ts_k_nearest_weights(&t, p), footprint);
}

/* Sums the triangles of a leaf, except those of a reflector; with TS_NONE all. */
TS_FN ts_surface_sum ts_k_leaf_sum(const ts_octree_surface_args *args, u64 leaf, u32 reflector)
{
	ts_surface_sum sum = ts_k_surface_sum();
	f32 side = ts_k_voxel_side(args->root, args->levels);
	ts_v3 middle = ts_load3(args->nodes[args->first + leaf].centre);
	for (u32 k = args->offset[leaf]; k < args->offset[leaf + 1u]; k++) {
		u32 triangle = args->triangles[k];
		if (reflector != TS_NONE && ts_k_reflector_of(&args->scene, triangle) == reflector) continue;
		ts_surface s = ts_k_surface_near(&args->scene, triangle, middle, side);
		ts_k_surface_sum_add(&sum, &s);
	}
	return sum;
}

/* map over leaves */
TS_FN void ts_k_leaf_surface_item(const ts_octree_surface_args *args, u64 i)
{
	ts_surface_sum sum = ts_k_leaf_sum(args, i, TS_NONE);
	ts_k_surface_sum_store(&args->surfaces[args->first + i], &sum);
}

/* map over nodes of a level whose children are done */
TS_FN void ts_k_inner_surface_item(const ts_octree_surface_args *args, u64 i)
{
	TS_GLOBAL const ts_node *node = &args->nodes[args->first + i];
	u32 n = ts_k_count_bits(node->children);
	ts_surface_sum sum = ts_k_surface_sum();
	for (u32 k = 0u; k < n; k++) ts_k_surface_sum_add_node(&sum, &args->surfaces[node->child + k]);
	ts_k_surface_sum_store(&args->surfaces[args->first + i], &sum);
}

#endif
