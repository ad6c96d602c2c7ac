/* Margins of vpl_gather.h, for ports that round otherwise (PORTING 7): how near the light of a pixel was to another
 * answer. This second pass takes lists and maps as given and changes no decision. A pixel may fall into another node,
 * and so take another list; each of its lights may fall into another texel, or be seen or not. A light that appears or
 * disappears where a cosine is 0 changes nothing, since it is 0 there. */
#ifndef TS_KERNELS_VIEWS_VPL_GATHER_MARGIN_H
#define TS_KERNELS_VIEWS_VPL_GATHER_MARGIN_H
#include "kernels/base/args.h"
#include "kernels/views/view_map_margin.h"
#include "kernels/views/vpl_gather.h"

#define TS_MARGIN_SLOPE \
	0.00000762939453125f /* share of the bias that rounding may change: up to 16 steps of a cosine */

#define TS_ROWS_ts_vpl_gather_margin_args(ARG) \
	ARG(INNER, ts_vpl_gather_args, of, none) \
	ARG(OUT, f32, margin, vpl_gather_margin)
TS_ARGS(ts_vpl_gather_margin_args);

/* The margin of a coordinate against the nearest side of a node of the lists' level, in 2^-20 of the root cube; there
 * are no nodes outside the root. */
TS_FN f32 ts_k_side_margin(const ts_vpl_gather_args *args, f32 coordinate, f32 lower)
{
	f32 nodes = (f32)(1u << args->level);
	f32 half_step = 0.5f / (f32)((u32)TS_VOXEL << args->levels);
	f32 share = (coordinate - lower) / args->root->side;
	f32 at = (share + half_step) * nodes;
	i32 side = ts_floor_i32(at + 0.5f);
	if (side <= 0 || side >= (i32)(1u << args->level)) return TS_MARGIN_NOWHERE;
	return ts_abs(at - (f32)side) / (nodes * TS_MARGIN_ROUNDING);
}

TS_FN f32 ts_k_list_margin(const ts_vpl_gather_args *args, ts_v3 p)
{
	f32 x = ts_k_side_margin(args, p.x, args->root->lower[0]);
	f32 y = ts_k_side_margin(args, p.y, args->root->lower[1]);
	f32 z = ts_k_side_margin(args, p.z, args->root->lower[2]);
	return ts_min(x, ts_min(y, z));
}

/* An answer, and its distance from the other answer, in steps of rounding. */
typedef struct {
	bool reaches;
	f32 margin;
} ts_answer;

/* Whether the node that a texel of a light's map shows is too far to block. */
TS_FN ts_answer ts_k_vpl_depth_answer(const ts_vpl_gather_args *args, u32 view, u64 shown, u32 texel, ts_v3 p, ts_v3 n)
{
	ts_v3 way = ts_sub(p, ts_load3(args->lights[view].position));
	f32 slack = ts_k_vpl_slack(args, way, n);
	f32 reach = ts_k_vpl_reach(args, view, shown, texel, p, n);
	f32 d = ts_length(way);
	f32 far = (d + (reach - slack)) + ts_length(p);
	f32 step = far * TS_MARGIN_ROUNDING + slack * TS_MARGIN_SLOPE;
	ts_answer r;
	r.reaches = d <= reach;
	r.margin = ts_abs(d - reach) / step;
	return r;
}

/* Whether the shown node is too near the tangent plane to block. */
TS_FN ts_answer ts_k_vpl_plane_answer(const ts_vpl_gather_args *args, u32 shown, ts_v3 p, ts_v3 n)
{
	TS_GLOBAL const ts_node *node = &args->scene[shown];
	f32 height = ts_k_node_height(node, p, n);
	f32 clear = ts_k_vpl_clear(args, node);
	f32 far = (ts_length(ts_load3(node->centre)) + ts_length(p)) + clear;
	ts_answer r;
	r.reaches = args->by_plane != 0u && height <= clear;
	r.margin = args->by_plane != 0u ? ts_abs(height - clear) / (far * TS_MARGIN_ROUNDING) : TS_MARGIN_NOWHERE;
	return r;
}

/* Whether the place is lit: by either of the two answers. */
TS_FN ts_answer ts_k_vpl_answer(const ts_vpl_gather_args *args, u32 view, u32 texel, ts_v3 p, ts_v3 n)
{
	/* Let the light through where the texel shows nothing. */
	u64 shown = ts_k_vpl_shown(args, view, texel);
	ts_answer r;
	r.reaches = true;
	r.margin = TS_MARGIN_NOWHERE;
	if ((u32)shown == TS_NONE) return r;
	/* Combine both answers: one that lights is enough. The greater margin counts if both do, the less if neither. */
	ts_answer a = ts_k_vpl_depth_answer(args, view, shown, texel, p, n);
	ts_answer b = ts_k_vpl_plane_answer(args, (u32)shown, p, n);
	f32 alike = a.reaches ? ts_max(a.margin, b.margin) : ts_min(a.margin, b.margin);
	r.reaches = a.reaches || b.reaches;
	r.margin = a.reaches == b.reaches ? alike : a.reaches ? a.margin : b.margin;
	return r;
}

/* The margin over the texel into which a light's way falls and the texels beyond its nearest edges. */
TS_FN f32 ts_k_vpl_reach_margin(const ts_vpl_gather_args *args, u32 view, ts_v3 p, ts_v3 n)
{
	/* Find the texel into which the way falls, and the nearest edges. */
	ts_v3 way = ts_sub(p, ts_load3(args->lights[view].position));
	ts_v2 at = ts_k_paraboloid_at(way, args->n);
	ts_beside x = ts_k_beside(at.x);
	ts_beside y = ts_k_beside(at.y);
	/* Ask this texel whether the light reaches p. */
	ts_answer own = ts_k_vpl_answer(args, view, ts_k_paraboloid_texel(way, args->n), p, n);
	f32 least = own.margin;
	for (u32 k = 1u; k < 4u; k++) {
		/* Find how near the way is to another texel; to reach the one across the corner, both edges must be passed. */
		f32 of_x = (k & 1u) != 0u ? ts_k_place_margin(way.y, &x, args->n) : 0.0f;
		f32 of_y = (k & 2u) != 0u ? ts_k_place_margin(way.z, &y, args->n) : 0.0f;
		f32 turns = ts_max(of_x, of_y);
		if (turns > TS_MARGIN_REACH) continue;
		/* Ask the other texel, too: if it answers otherwise, passing the edge is enough; if not, its answer must turn
		 * as well. */
		u32 texel =
			ts_k_paraboloid_index(way, (k & 1u) != 0u ? x.next : x.own, (k & 2u) != 0u ? y.next : y.own, args->n);
		ts_answer other = ts_k_vpl_answer(args, view, texel, p, n);
		least = ts_min(least, other.reaches != own.reaches ? turns : ts_max(turns, other.margin));
	}
	return least;
}

TS_FN f32 ts_k_vpl_light_margin(const ts_vpl_gather_args *args, u32 view, ts_v3 p, ts_v3 n)
{
	TS_GLOBAL const ts_vpl *light = &args->lights[view];
	ts_v3 way = ts_sub(p, ts_load3(light->position));
	f32 form = ts_k_vpl_form(way, ts_load3(light->normal), n, args->near * ts_k_leaf_side(args));
	return form > 0.0f && args->shadows != 0u ? ts_k_vpl_reach_margin(args, view, p, n) : TS_MARGIN_NOWHERE;
}

/* map over pixels, as ts_k_vpl_gather_item */
TS_FN void ts_k_vpl_gather_margin_item(const ts_vpl_gather_margin_args *args, u64 i)
{
	/* Begin far from another answer; the sky stays there. */
	const ts_vpl_gather_args *of = &args->of;
	TS_GLOBAL const ts_gpixel *pixel = &of->pixels[i];
	f32 least = TS_MARGIN_NOWHERE;
	if (pixel->depth != TS_SKY) {
		/* Find the list of the pixel, the number of its lights, and how near another list is. */
		ts_v3 p = ts_load3(pixel->position);
		ts_view_list list = ts_k_pixel_list(of, p);
		u32 draws = list.views == 0u ? 0u : ts_k_list_draws(of, &list);
		least = ts_k_list_margin(of, p);
		/* Take the least margin of the lights that the pixel draws. */
		for (u32 k = 0u; k < draws; k++) {
			u32 view = ts_k_drawn_view(of, &list, (u32)i, k);
			least = ts_min(least, ts_k_vpl_light_margin(of, view, p, ts_load3(pixel->normal)));
		}
	}
	args->margin[i] = ts_put(least);
}

#endif
