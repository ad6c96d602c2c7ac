/* Colour in the maps of views (MegaViews section 3.1, "each node stores scene attributes: color (or material),
 * position, and a surface normal"; METHODS 14): deferred shading of the node that each texel of a fused map shows, in
 * full light, seen from the middle of the view's leaf. */
#ifndef TS_KERNELS_VIEWS_VIEW_MAP_COLOUR_H
#define TS_KERNELS_VIEWS_VIEW_MAP_COLOUR_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/views/octree_surface.h"

#define TS_ROWS_ts_view_map_colour_args(ARG) \
	ARG(INNER, ts_octree_surface_args, of, none) /* whose surfaces are read */ \
	ARG(IN, ts_node, views, view_octree_node) \
	ARG(IN, u32, leaves, view_octree_leaf) \
	ARG(IN, u32, shown, view_map_fused_node) \
	ARG(OUT, f32, colours, view_map_colour) \
	ARG(VALUE, u32, n, none) /* texels per side of a map */
TS_ARGS(ts_view_map_colour_args);

/* Whether a leaf has a triangle of the reflector. */
TS_FN bool ts_k_leaf_has(const ts_octree_surface_args *args, u64 leaf, u32 reflector)
{
	bool has = false;
	for (u32 k = args->offset[leaf]; k < args->offset[leaf + 1u]; k++) {
		has = has || ts_k_reflector_of(&args->scene, args->triangles[k]) == reflector;
	}
	return has;
}

/* The surface in a node, without the view's own reflector where that shares a leaf with other objects. */
TS_FN ts_surface_sum ts_k_node_sum(const ts_octree_surface_args *args, u32 node, u32 reflector)
{
	ts_surface_sum sum = ts_k_surface_sum();
	bool leaf = args->nodes[node].children == 0u;
	if (leaf && ts_k_leaf_has(args, node - args->first, reflector)) {
		return ts_k_leaf_sum(args, node - args->first, reflector);
	}
	ts_k_surface_sum_add_node(&sum, &args->surfaces[node]);
	return sum;
}

/* The surface in the middle of a node. A mean normal has no side, so it turns to the viewer. */
TS_FN ts_surface ts_k_node_surface(ts_v3 middle, const ts_surface_sum *sum)
{
	/* Place the surface, and turn it by the mean normal. */
	ts_surface r;
	f32 n = ts_k_surface_count(sum);
	r.p = middle;
	r.n = ts_normalize(sum->normal);
	r.face = r.n;
	/* Average the material over the surfels of the sum. */
	r.base = ts_k_share_of(sum->base, n);
	r.emissive = ts_k_share_of(sum->emissive, n);
	r.metallic = sum->metallic / n;
	r.roughness = sum->roughness / n;
	r.occlusion = sum->occlusion / n;
	r.flags = TS_DOUBLE_SIDED;
	return r;
}

/* map over texels of the views' maps: view i is from the middle of the cube of reflector i */
TS_FN void ts_k_view_map_colour_item(const ts_view_map_colour_args *args, u64 i)
{
	u64 n_texels = 2u * args->n * args->n;
	u32 reflector = (u32)(i / n_texels);
	u32 leaf = args->leaves[reflector];
	u32 node = args->shown[(u64)leaf * n_texels + i % n_texels];
	ts_v3 radiance = ts_k_background();
	if (node != TS_NONE) {
		ts_surface_sum sum = ts_k_node_sum(&args->of, node, reflector);
		ts_surface s = ts_k_node_surface(ts_load3(args->of.nodes[node].centre), &sum);
		ts_v3 towards = ts_normalize(ts_sub(ts_load3(args->views[leaf].centre), s.p));
		radiance = ts_k_shade(&args->of.scene, &s, towards);
	}
	ts_store3(args->colours + i * 3u, radiance);
}

#endif
