/* Light that pixels gather from virtual point lights (MegaViews section 5.1; METHODS 14). A pixel takes `draws` random
 * views of the list of its node, with repetition, or all of them. A light with a direction is a small Lambertian patch,
 * E = flux cos cos / (pi d^2); a light without a direction sends the same to all sides, E = flux cos / (4 pi d^2). d is
 * bounded from below, so that a near light is no bright spot. Shadows are those of the fused map of the light's
 * leaf, moved to the light; where maps are not fused, the maps from the root down are looked up. */
#ifndef TS_KERNELS_VIEWS_VPL_GATHER_H
#define TS_KERNELS_VIEWS_VPL_GATHER_H
#include "kernels/base/args.h"
#include "kernels/raster/gpixel.h"
#include "kernels/views/mask.h"
#include "kernels/views/octree_root.h"
#include "kernels/views/view_map_fuse.h"
#include "kernels/views/vpl.h"

#define TS_ROWS_ts_vpl_gather_args(ARG) \
	ARG(IN, ts_gpixel, pixels, gbuffer_pixel) \
	ARG(IN, ts_root, root, octree_root) \
	ARG(IN, u64, mask, voxel_mask) \
	ARG(IN, u32, before, voxel_before) \
	ARG(IN, u32, offset, vpl_gather_pair_offset) \
	ARG(IN, u32, list, vpl_gather_pair_node) \
	ARG(IN, u32, sums, vpl_gather_pair_views) \
	ARG(IN, ts_cone, cones, view_octree_cone) \
	ARG(IN, u32, views, view_octree_view) \
	ARG(IN, u32, leaves, view_octree_leaf) \
	ARG(IN, ts_node, nodes, view_octree_node) \
	ARG(IN, ts_vpl, lights, vpl_light) \
	ARG(IN, u32, depths, view_map_fused_depth) /* NULL: maps are not fused */ \
	ARG(IN, u32, shown, view_map_fused_node) \
	ARG(INNER, ts_view_map_fuse_args, unfused, none) /* in place of the fused maps */ \
	ARG(IN, ts_node, scene, octree_node) \
	ARG(OUT, f32, irradiance, vpl_gather_irradiance) \
	ARG(TALLY, i64, n_astray, 0) /* pixels in no node of the level */ \
	ARG(VALUE, u32, levels, none) \
	ARG(VALUE, u32, level, none) /* of the lists */ \
	ARG(VALUE, u32, first, none) /* node of list 0 */ \
	ARG(VALUE, u32, n_lights, none) \
	ARG(VALUE, u32, draws, none) /* 0: every light of the list */ \
	ARG(VALUE, u32, seed, none) \
	ARG(VALUE, u32, n, none) /* texels per side of a map */ \
	ARG(VALUE, u32, shadows, none) \
	ARG(VALUE, f32, near, none) /* sides of a leaf */ \
	ARG(VALUE, f32, bias, none) /* diagonals of a leaf */ \
	ARG(VALUE, f32, bias_px, none) \
	ARG(VALUE, f32, bias_slope, none) /* texels of a map */ \
	ARG(VALUE, u32, by_plane, none)   /* not 0: only nodes above the tangent plane block */ \
	ARG(VALUE, f32, bias_plane, none) /* radii of a node */
TS_ARGS(ts_vpl_gather_args);

TS_FN f32 ts_k_leaf_side(const ts_vpl_gather_args *args) { return args->root->side / (f32)(1u << args->levels); }
TS_FN f32 ts_k_leaf_diagonal(const ts_vpl_gather_args *args) { return ts_k_leaf_side(args) * TS_ROOT_3; }

/* The entries from `from` up to `to`, which is not included, and the number of their views; both TS_NONE: all views. */
typedef struct {
	u32 from, to, views;
} ts_view_list;

/* The node of the lists' level that contains p; TS_NONE: there is none. */
TS_FN u32 ts_k_list_node(const ts_vpl_gather_args *args, ts_v3 p)
{
	u64 code = ts_k_morton(ts_k_voxel_of(args->root, args->levels, p)) >> (3u * (args->levels - args->level));
	bool there = (args->mask[ts_k_mask_word(args->level, code)] & ts_k_mask_bit(code)) != 0u;
	return there ? ts_k_mask_id(args->mask, args->before, args->level, code) : TS_NONE;
}

TS_FN ts_view_list ts_k_pixel_list(const ts_vpl_gather_args *args, ts_v3 p)
{
	/* Begin with all views, which a pixel outside the nodes asks. */
	u32 node = ts_k_list_node(args, p);
	ts_view_list r;
	r.from = TS_NONE;
	r.to = TS_NONE;
	r.views = args->n_lights;
	if (node == TS_NONE) return r;
	/* Take the list of the node, and the number of views that it holds. */
	u32 list = node - args->first;
	r.from = args->offset[list];
	r.to = args->offset[list + 1u];
	r.views = r.from < r.to ? args->sums[r.to - 1u] : 0u;
	return r;
}

/* The view of a list with `rank` others before it, by binary search in the prefix sums of the list's nodes. */
TS_FN u32 ts_k_list_view(const ts_vpl_gather_args *args, const ts_view_list *list, u32 rank)
{
	if (list->from == TS_NONE) return rank;
	u32 low = list->from;
	u32 high = list->to - 1u;
	while (low < high) {
		u32 middle = low + (high - low) / 2u;
		bool before = args->sums[middle] <= rank;
		low = before ? middle + 1u : low;
		high = before ? high : middle;
	}
	u32 first = low > list->from ? args->sums[low - 1u] : 0u;
	return args->views[args->cones[args->list[low]].first + (rank - first)];
}

#define TS_LEAST_FACING_VPL 0.0625f /* limits the slope, and so the bias */

/* Depth bias: `bias` diagonals of a leaf, plus bias_px + bias_slope times the slope of the receiver texels of the map,
 * each (d + |x|) 2 / N wide. */
TS_FN f32 ts_k_vpl_slack(const ts_vpl_gather_args *args, ts_v3 way, ts_v3 n)
{
	f32 d = ts_length(way);
	f32 texel = (d + ts_abs(way.x)) * (2.0f / (f32)args->n);
	f32 across = ts_abs(ts_dot(way, n));
	f32 aside = ts_length(ts_cross(way, n));
	f32 slope = aside / ts_max(across, d * TS_LEAST_FACING_VPL);
	f32 texels = args->bias_slope * slope;
	texels = texels + args->bias_px;
	f32 leaf = args->bias * ts_k_leaf_diagonal(args);
	f32 wide = texel * texels;
	return wide + leaf;
}

/* The entry of a texel of the map of a light's leaf, distance << 32 | node of the scene; node TS_NONE: nothing. */
TS_FN u64 ts_k_vpl_shown(const ts_vpl_gather_args *args, u32 view, u32 texel)
{
	u32 leaf = args->leaves[view];
	if (args->depths == NULL) return ts_k_fuse_query(&args->unfused, leaf, texel);
	u64 at = (u64)leaf * (2u * args->n * args->n) + texel;
	return ((u64)args->depths[at] << 32) | args->shown[at];
}

/* The distance up to which a light reaches in the direction of p: the distance from the light of the node that a texel
 * of its leaf's map shows, plus the bias. */
TS_FN f32 ts_k_vpl_reach(const ts_vpl_gather_args *args, u32 view, u64 shown, u32 texel, ts_v3 p, ts_v3 n)
{
	ts_v3 centre = ts_load3(args->nodes[args->leaves[view]].centre);
	ts_v3 light = ts_load3(args->lights[view].position);
	f32 depth = ts_u2f((u32)(shown >> 32));
	return ts_k_moved_depth(centre, depth, light, texel, args->n) + ts_k_vpl_slack(args, ts_sub(p, light), n);
}

/* Height of the middle of a node above the tangent plane of p. */
TS_FN f32 ts_k_node_height(TS_GLOBAL const ts_node *node, ts_v3 p, ts_v3 n)
{
	return ts_dot(ts_sub(ts_load3(node->centre), p), n);
}

/* Height above a tangent plane up to which a node may be of the receiver's own surface. */
TS_FN f32 ts_k_vpl_clear(const ts_vpl_gather_args *args, TS_GLOBAL const ts_node *node)
{
	return args->bias_plane * node->radius;
}

/* Whether the node that a texel of the leaf's map shows leaves the way from the light to p free. */
TS_FN bool ts_k_vpl_reaches(const ts_vpl_gather_args *args, u32 view, u32 texel, ts_v3 p, ts_v3 n)
{
	u64 shown = ts_k_vpl_shown(args, view, texel);
	if ((u32)shown == TS_NONE) return true;
	f32 d = ts_length(ts_sub(p, ts_load3(args->lights[view].position)));
	if (d <= ts_k_vpl_reach(args, view, shown, texel, p, n)) return true;
	TS_GLOBAL const ts_node *node = &args->scene[(u32)shown];
	return args->by_plane != 0u && ts_k_node_height(node, p, n) <= ts_k_vpl_clear(args, node);
}

/* The emitted flux per solid angle, times pi over the flux: the cosine; a quarter for a light without a direction. */
TS_FN f32 ts_k_vpl_leaves(ts_v3 direction, ts_v3 from)
{
	bool all = from.x == 0.0f && from.y == 0.0f && from.z == 0.0f;
	return all ? 0.25f : ts_dot(direction, from);
}

/* Form factor: emitted cosine times received cosine over pi max(d, near)^2. */
TS_FN f32 ts_k_vpl_form(ts_v3 way, ts_v3 from, ts_v3 n, f32 near)
{
	ts_v3 direction = ts_normalize(way);
	f32 leaves = ts_k_vpl_leaves(direction, from);
	f32 arrives = -ts_dot(direction, n);
	if (!(leaves > 0.0f) || !(arrives > 0.0f)) return 0.0f;
	f32 least = near * near;
	f32 square = ts_max(ts_dot(way, way), least);
	f32 cosines = leaves * arrives;
	f32 projected = cosines * TS_PER_PI;
	return ts_flush(projected / square);
}

TS_FN ts_v3 ts_k_vpl_light(const ts_vpl_gather_args *args, u32 view, ts_v3 p, ts_v3 n)
{
	TS_GLOBAL const ts_vpl *light = &args->lights[view];
	ts_v3 way = ts_sub(p, ts_load3(light->position));
	f32 form = ts_k_vpl_form(way, ts_load3(light->normal), n, args->near * ts_k_leaf_side(args));
	bool lit = form > 0.0f;
	if (lit && args->shadows != 0u) lit = ts_k_vpl_reaches(args, view, ts_k_paraboloid_texel(way, args->n), p, n);
	return ts_scale(ts_load3(light->flux), lit ? form : 0.0f);
}

/* Number of lights that a pixel takes from a list. */
TS_FN u32 ts_k_list_draws(const ts_vpl_gather_args *args, const ts_view_list *list)
{
	return args->draws != 0u ? args->draws : list->views;
}

/* The view of draw k of a pixel. */
TS_FN u32 ts_k_drawn_view(const ts_vpl_gather_args *args, const ts_view_list *list, u32 pixel, u32 k)
{
	u32 chance = ts_random(pixel * args->draws + k, TS_STREAM_VPL, args->seed);
	u32 rank = args->draws != 0u ? (u32)(((u64)chance * list->views) >> 32) : k;
	return ts_k_list_view(args, list, rank);
}

TS_FN ts_v3 ts_k_vpl_sum(const ts_vpl_gather_args *args, const ts_view_list *list, u32 pixel, ts_v3 p, ts_v3 n)
{
	u32 draws = ts_k_list_draws(args, list);
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	if (list->views == 0u) return sum;
	for (u32 k = 0u; k < draws; k++) {
		sum = ts_add(sum, ts_k_vpl_light(args, ts_k_drawn_view(args, list, pixel, k), p, n));
	}
	f32 share = (f32)list->views / (f32)draws;
	return ts_scale(sum, share);
}

/* map over pixels */
TS_FN void ts_k_vpl_gather_item(const ts_vpl_gather_args *args, u64 i)
{
	TS_GLOBAL const ts_gpixel *pixel = &args->pixels[i];
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	if (pixel->depth != TS_SKY) {
		ts_v3 p = ts_load3(pixel->position);
		ts_view_list list = ts_k_pixel_list(args, p);
		if (list.from == TS_NONE) ts_add_i64(args->n_astray, 1);
		sum = ts_k_vpl_sum(args, &list, (u32)i, p, ts_load3(pixel->normal));
	}
	ts_store3(args->irradiance + i * 3u, sum);
}

#endif
