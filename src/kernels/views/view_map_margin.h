/* How near what maps show was to another answer, for ports that round otherwise (PORTING 7): a second pass over the
 * pairs that map.h got its own from, which changes nothing that was decided of the octrees that it was given. Where the
 * fate of a pair turns, it and all pairs below it may come or go, in texels that its ball may cover in the maps of its
 * views. Where the texel of a rendered pair turns, it may leave one for another. What comes behind what a texel shows
 * changes nothing. */
#ifndef TS_KERNELS_VIEW_MAP_MARGIN_H
#define TS_KERNELS_VIEW_MAP_MARGIN_H
#include "../base/args.h"
#include "view_map.h"
#include "../raster/shadow_test_margin.h"

#define TS_MARGIN_SINE 0.0000002384185791015625f /* by its sine: what rounding changes in the sine of a cone */
#define TS_MARGIN_LEAST_SINE 0.00048828125f

#define TS_ROWS_ts_view_map_margin_args(ARG) \
	ARG(INNER, ts_traverse_args, of, none) /* how pairs are decided */ \
	ARG(WORK_IN, u64, pairs, queue)        /* not yet decided; NULL: each of n_nodes from `first` on with each view */ \
	ARG(IN, u64, texels, view_map_depth_node) \
	ARG(MIN, u32, margin, view_map_margin) /* f32 bits */ \
	ARG(VALUE, ts_pyramid, pyramid, none) \
	ARG(VALUE, u32, first, none) \
	ARG(VALUE, u32, n_nodes, none)
TS_ARGS(ts_view_map_margin_args);

/* Of fs and what it must pass, in 8 ulps of the distance and what rounding changes in the sine of the cone. */
TS_FN f32 ts_k_cull_side_margin(const ts_ball *s, const ts_ball *v, const ts_cone_k *cone, const ts_aperture *phi)
{
	f32 c = ts_max(cone->cosine - TS_CULL_COSINE, -1.0f);
	f32 square = c * c;
	f32 sine = ts_max(ts_sqrt(ts_flush(ts_max(1.0f - square, 0.0f))), TS_MARGIN_LEAST_SINE);
	f32 d = ts_length(ts_sub(s->p, v->p));
	f32 step = d * (TS_MARGIN_ROUNDING + TS_MARGIN_SINE / sine);
	f32 apart = ts_abs(ts_k_pair_outside(s, v, cone, phi) - ts_k_pair_reach(s, v));
	return step > 0.0f ? apart / step : TS_MARGIN_NOWHERE;
}

/* Of the size and a texel, in 16 ulps of it. Radii are compared exactly, and a ball about the view is never small. */
TS_FN f32 ts_k_equivalent_margin(const ts_ball *s, const ts_ball *v, u32 n)
{
	f32 size = ts_k_pair_size(s, v, n);
	if (size < 0.0f || v->r > s->r) return TS_MARGIN_NOWHERE;
	return ts_abs(size - 1.0f) / (2.0f * TS_MARGIN_ROUNDING);
}

/* Of the distance of two leaves and that at which they touch, in 8 ulps. */
TS_FN f32 ts_k_touch_margin(const ts_ball *s, const ts_ball *v)
{
	f32 d = ts_length(ts_sub(s->p, v->p));
	if (!s->leaf || !v->leaf) return TS_MARGIN_NOWHERE;
	return ts_abs(d - ts_k_pair_touch_reach(s, v)) / (ts_k_pair_touch_reach(s, v) * TS_MARGIN_ROUNDING);
}

/* The least of the tests that a pair came by. Which of the two is split depends on no rounding. */
TS_FN f32 ts_k_fate_margin(const ts_traverse_args *args, u64 pair, u32 fate)
{
	ts_ball s = ts_k_pair_ball(args, &args->nodes[ts_k_pair_node(pair)]);
	ts_ball v = ts_k_pair_ball(args, &args->views[ts_k_pair_views(pair)]);
	ts_cone_k cone = ts_k_load_cone(&args->cones[ts_k_pair_views(pair)]);
	f32 least = ts_k_cull_side_margin(&s, &v, &cone, &args->phi);
	if (fate == TS_PAIR_CULL) return least;
	least = ts_min(least, ts_k_equivalent_margin(&s, &v, args->n));
	return args->touching == 0u ? ts_min(least, ts_k_touch_margin(&s, &v)) : least;
}

/* Texels of an axis that a circle of the disc may reach. */
typedef struct {
	i32 from, to;
} ts_reach;

TS_FN ts_reach ts_k_circle_reach(f32 middle, f32 radius, u32 n)
{
	ts_reach r;
	r.from = ts_floor_i32(ts_clamp(ts_k_paraboloid_place(middle - radius, n), 0.0f, (f32)n));
	r.to = ts_floor_i32(ts_clamp(ts_k_paraboloid_place(middle + radius, n), -1.0f, (f32)n - 1.0f)) + 1;
	return r;
}

/* Texels of one of two maps that a ball may be in, but those that show what is nearer: the image of a ball is a
 * circle about the middle (y, z) / (x + c), c^2 = d^2 - r^2, of radius r / (x + c); or its outside, if the ball
 * covers the map's back. */
TS_FN void ts_k_ball_margin_map(const ts_view_map_margin_args *args, u64 first, ts_v3 vs, f32 r, u32 level, bool back,
                                f32 margin)
{
	u32 n = args->pyramid.n >> level;
	f32 d = ts_length(vs);
	f32 nearest = d - r;
	f32 square = nearest * (d + r);
	f32 sum = (back ? -vs.x : vs.x) + ts_sqrt(ts_flush(ts_max(square, 0.0f)));
	ts_reach x;
	x.from = 0;
	x.to = (i32)n;
	ts_reach y = x;
	if (nearest > 0.0f && sum > d * TS_MARGIN_LEAST_SINE) {
		x = ts_k_circle_reach(vs.y / sum, r / sum, n);
		y = ts_k_circle_reach(vs.z / sum, r / sum, n);
	}
	f32 rounding = d * TS_MARGIN_ROUNDING;
	u32 least = ts_f2u(ts_put(ts_max(nearest - rounding, 0.0f)));
	u64 map = first + ts_k_pyramid_first(&args->pyramid, level) + (back ? (u64)n * n : 0u);
	for (i32 j = y.from; j < y.to; j++) {
		for (i32 i = x.from; i < x.to; i++) {
			u64 texel = map + (u64)j * n + (u64)i;
			if ((u32)(args->texels[texel] >> 32) >= least) ts_k_least_bits(&args->margin[texel], margin);
		}
	}
}

TS_FN void ts_k_ball_margin(const ts_view_map_margin_args *args, u32 node, u32 view, f32 margin)
{
	TS_GLOBAL const ts_node *s = &args->of.nodes[node];
	ts_v3 vs = ts_sub(ts_load3(s->centre), ts_load3(args->of.views[view].centre));
	u64 first = (u64)view * ts_k_pyramid_texels(&args->pyramid);
	for (u32 level = 0u; level < args->pyramid.levels; level++) {
		ts_k_ball_margin_map(args, first, vs, s->radius, level, false, margin);
		ts_k_ball_margin_map(args, first, vs, s->radius, level, true, margin);
	}
}

/* A node and the nodes below it, level by level: those of a level stand beside each other. */
TS_FN void ts_k_fate_margin_spread(const ts_view_map_margin_args *args, u64 pair, f32 margin)
{
	TS_GLOBAL const ts_node *views = args->of.views;
	u32 from = ts_k_pair_views(pair);
	u32 to = from + 1u;
	while (from < to) {
		for (u32 v = from; v < to; v++) ts_k_ball_margin(args, ts_k_pair_node(pair), v, margin);
		bool leaves = views[from].children == 0u;
		to = leaves ? from : views[to - 1u].child + ts_k_count_bits(views[to - 1u].children);
		from = leaves ? from : views[from].child;
	}
}

/* Of a place along an axis and the nearest edge of a texel, in 2^-20 of the map; no rounding makes the middle
 * another. */
TS_FN f32 ts_k_place_margin(f32 component, const ts_beside *beside, u32 n)
{
	f32 texels = beside->distance * 0.00390625f;
	return component == 0.0f ? TS_MARGIN_NOWHERE : texels / ((f32)n * TS_MARGIN_ROUNDING);
}

/* The level of the pyramid whose width is the nearest to the ball's, beside its own; of the sine only 1 is not
 * rounded. */
typedef struct {
	u32 own, next;
	f32 margin;
} ts_level_beside;

TS_FN ts_level_beside ts_k_level_beside(const ts_pyramid *pyramid, ts_v3 vs, f32 d, f32 radius)
{
	f32 sine = d > radius ? radius / d : 1.0f;
	f32 size = ts_k_paraboloid_size(d > 0.0f ? ts_abs(vs.x) / d : 0.0f, sine, pyramid->n);
	f32 square = sine * sine;
	f32 left = sine < 1.0f ? 1.0f - square : 1.0f;
	ts_level_beside r;
	r.own = ts_k_map_level(pyramid, vs, d, radius);
	f32 wide = (f32)(1u << r.own);
	bool up = size > wide * 0.75f;
	r.next = up ? r.own + 1u : r.own - 1u;
	if (r.next >= pyramid->levels) r.next = r.own;
	f32 apart = ts_abs(size - (up ? wide : wide * 0.5f)) / size;
	r.margin = (apart * left) / (2.0f * TS_MARGIN_ROUNDING);
	return r;
}

/* Where a pair of the distance d is in a map, and how near it is to be rendered, or not to be. */
typedef struct {
	u64 own;
	u32 node;
	f32 d, fate;
	bool rendered;
} ts_placed;

/* A pair may come to a texel where rounding turns that much: not behind what the texel shows, or so near behind that
 * this turns, too. And it leaves its own. */
TS_FN void ts_k_come_margin(const ts_view_map_margin_args *args, const ts_placed *pair, u64 there, f32 turns)
{
	u64 key = args->texels[there];
	f32 behind = key != TS_EMPTY ? pair->d - ts_u2f((u32)(key >> 32)) : 0.0f;
	f32 tie = behind > 0.0f ? behind / (pair->d * TS_MARGIN_ROUNDING) : 0.0f;
	f32 comes = ts_max(ts_max(turns, tie), pair->rendered ? 0.0f : pair->fate);
	bool shown = args->texels[pair->own] != TS_EMPTY && (u32)args->texels[pair->own] == pair->node;
	bool stays = shown && there == pair->own;
	if (shown) ts_k_least_bits(&args->margin[pair->own], stays ? pair->fate : turns);
	if (!stays) ts_k_least_bits(&args->margin[there], comes);
}

/* A pair in its texel and in those that rounding may give it. */
TS_FN void ts_k_placed_margin(const ts_view_map_margin_args *args, u64 pair, f32 fate_margin, bool rendered)
{
	TS_GLOBAL const ts_node *node = &args->of.nodes[ts_k_pair_node(pair)];
	u32 n = args->pyramid.n;
	u64 first = (u64)ts_k_pair_views(pair) * ts_k_pyramid_texels(&args->pyramid);
	ts_v3 vs = ts_sub(ts_load3(node->centre), ts_load3(args->of.views[ts_k_pair_views(pair)].centre));
	ts_v2 at = ts_k_paraboloid_at(vs, n);
	ts_beside x = ts_k_beside(at.x);
	ts_beside y = ts_k_beside(at.y);
	ts_placed r;
	r.node = ts_k_pair_node(pair);
	r.d = ts_length(vs);
	r.fate = fate_margin;
	r.rendered = rendered;
	ts_level_beside l = ts_k_level_beside(&args->pyramid, vs, r.d, node->radius);
	for (u32 k = 0u; k < 8u; k++) {
		f32 of_x = (k & 1u) != 0u ? ts_k_place_margin(vs.y, &x, n) : 0.0f;
		f32 of_y = (k & 2u) != 0u ? ts_k_place_margin(vs.z, &y, n) : 0.0f;
		f32 turns = ts_max(ts_max(of_x, of_y), (k & 4u) != 0u ? l.margin : 0.0f);
		u32 texel = ts_k_paraboloid_index(vs, (k & 1u) != 0u ? x.next : x.own, (k & 2u) != 0u ? y.next : y.own, n);
		u64 there = first + ts_k_pyramid_above(&args->pyramid, texel, (k & 4u) != 0u ? l.next : l.own);
		if (k == 0u) r.own = there;
		if (turns <= TS_MARGIN_REACH && (k == 0u || there != r.own)) ts_k_come_margin(args, &r, there, turns);
	}
}

/* scatter over pairs, before they are decided. Two leaves have no pairs below them. */
TS_FN void ts_k_view_map_margin_item(const ts_view_map_margin_args *args, u64 i)
{
	u64 pair = ts_k_pair(args->first + (u32)(i % args->n_nodes), (u32)(i / args->n_nodes));
	if (args->pairs != NULL) pair = args->pairs[i];
	u32 fate = ts_k_pair_fate(&args->of, pair);
	f32 margin = ts_k_fate_margin(&args->of, pair, fate);
	bool leaf = args->of.nodes[ts_k_pair_node(pair)].children == 0u;
	bool leaves = leaf && args->of.views[ts_k_pair_views(pair)].children == 0u;
	bool turns = margin <= TS_MARGIN_REACH;
	if (turns && !leaves) ts_k_fate_margin_spread(args, pair, margin);
	if (fate == TS_PAIR_RENDER || (turns && leaves)) ts_k_placed_margin(args, pair, margin, fate == TS_PAIR_RENDER);
}

#endif
