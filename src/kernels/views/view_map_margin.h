/* Margins of view_map.h, for ports that round otherwise (PORTING 7): how near the texels of maps were to another
 * answer. This second pass over the pairs takes the octrees as given and changes no decision. A test "turns" if a port
 * decides it otherwise. If the fate of a pair turns, the pair and all pairs below it may appear or disappear, in the
 * texels that its ball may cover in the maps of its views. If the test of a texel turns, a rendered pair may leave that
 * texel or come to it. A pair behind the one that a texel shows changes nothing. */
#ifndef TS_KERNELS_VIEWS_VIEW_MAP_MARGIN_H
#define TS_KERNELS_VIEWS_VIEW_MAP_MARGIN_H
#include "kernels/base/args.h"
#include "kernels/raster/shadow_map_margin.h"
#include "kernels/views/view_map.h"

#define TS_MARGIN_SINE 0.0000002384185791015625f /* the rounding error of a cone's sine, times that sine */
#define TS_MARGIN_LEAST_SINE 0.00048828125f

#define TS_ROWS_ts_view_map_margin_args(ARG) \
	ARG(INNER, ts_traverse_args, of, none) /* by which pairs are decided */ \
	ARG(WORK_IN, u64, pairs, queue)        /* not yet decided; NULL: each of n_nodes from `first` on with each view */ \
	ARG(IN, u64, texels, view_map_depth_node) \
	ARG(MIN, u32, margin, view_map_margin) /* f32 bits */ \
	ARG(INNER, ts_own_args, own, none) \
	ARG(VALUE, ts_pyramid, pyramid, none) \
	ARG(VALUE, u32, first, none) \
	ARG(VALUE, u32, n_nodes, none)
TS_ARGS(ts_view_map_margin_args);

/* The margin of fs against its bound, in 8 ulps of the distance plus the rounding error of the sine of the cone. */
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

/* The margin of the size against a texel, in 16 ulps of a texel. Radii are compared exactly, and a ball around the view
 * is never small. */
TS_FN f32 ts_k_equivalent_margin(const ts_ball *s, const ts_ball *v, u32 n)
{
	f32 size = ts_k_pair_size(s, v, n);
	if (size < 0.0f || v->r > s->r) return TS_MARGIN_NOWHERE;
	return ts_abs(size - 1.0f) / (2.0f * TS_MARGIN_ROUNDING);
}

/* The margin of the distance of two leaves against that up to which they are not rendered, in 8 ulps. */
TS_FN f32 ts_k_near_margin(const ts_ball *s, const ts_ball *v, f32 apart)
{
	f32 d = ts_length(ts_sub(s->p, v->p));
	f32 reach = apart * s->r;
	if (!s->leaf || !v->leaf || !(reach > 0.0f)) return TS_MARGIN_NOWHERE;
	return ts_abs(d - reach) / (reach * TS_MARGIN_ROUNDING);
}

/* The least margin of the tests that decided a pair. Which of the two nodes is split depends on no rounding. */
TS_FN f32 ts_k_fate_margin(const ts_traverse_args *args, u64 pair, u32 fate)
{
	ts_ball s = ts_k_pair_ball(args, &args->nodes[ts_k_pair_node(pair)]);
	ts_ball v = ts_k_pair_ball(args, &args->views[ts_k_pair_views(pair)]);
	ts_cone_k cone = ts_k_load_cone(&args->cones[ts_k_pair_views(pair)]);
	f32 least = ts_k_cull_side_margin(&s, &v, &cone, &args->phi);
	if (fate == TS_PAIR_CULL) return least;
	least = ts_min(least, ts_k_equivalent_margin(&s, &v, args->n));
	return ts_min(least, ts_k_near_margin(&s, &v, args->apart));
}

/* Lowers the margin of the texels of one of two maps in which a ball may be, except those that show a nearer node. */
TS_FN void ts_k_ball_margin_map(const ts_view_map_margin_args *args, u64 first, ts_v3 vs, f32 r, u32 level, bool back,
                                f32 margin)
{
	/* Find the least depth that the ball may have; what is nearer hides it, however the pair is decided. */
	u32 n = args->pyramid.n >> level;
	f32 d = ts_length(vs);
	f32 rounding = d * TS_MARGIN_ROUNDING;
	u32 least = ts_f2u(ts_put(ts_max((d - r) - rounding, 0.0f)));
	/* Find the texels of this level, in the front or the back map, in which the ball may be. */
	u64 map = first + ts_k_pyramid_first(&args->pyramid, level) + (back ? (u64)n * n : 0u);
	ts_cap cap = ts_k_cap(vs, r, back);
	ts_cap_box box = ts_k_cap_box(&cap, n);
	/* Lower the margin of those that do not show a nearer node. */
	for (i32 j = box.y.from; j < box.y.to; j++) {
		for (i32 i = box.x.from; i < box.x.to; i++) {
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

/* Spreads a margin to a node and the nodes below it, level by level; the nodes of a level follow each other. */
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

/* The margin of a place along an axis against the nearest edge of a texel, in 2^-20 of the map. Rounding does not move
 * the middle of the map. */
TS_FN f32 ts_k_place_margin(f32 component, const ts_beside *beside, u32 n)
{
	f32 texels = beside->distance * 0.00390625f;
	return component == 0.0f ? TS_MARGIN_NOWHERE : texels / ((f32)n * TS_MARGIN_ROUNDING);
}

/* A pair at the distance d, and the margin of being rendered or not. */
typedef struct {
	u32 node;
	f32 d, fate;
	bool rendered;
	f32 width; /* of the ball that is filled, in texels; more than 1 where every ball is filled */
} ts_placed;

/* Lowers the margin of a texel for a pair that is in the texel or not, and whose test there turns within `turns`. The
 * pair that the texel shows may leave. Another pair may come, if it is not behind the shown one, or so little that
 * their order may turn, too. */
TS_FN void ts_k_place_turns(const ts_view_map_margin_args *args, const ts_placed *pair, u64 texel, bool is_there,
                            f32 turns)
{
	u64 key = args->texels[texel];
	bool shown = key != TS_EMPTY && (u32)key == pair->node;
	f32 behind = key != TS_EMPTY ? pair->d - ts_u2f((u32)(key >> 32)) : 0.0f;
	f32 tie = behind > 0.0f ? behind / (pair->d * TS_MARGIN_ROUNDING) : 0.0f;
	f32 comes = ts_max(ts_max(is_there ? 0.0f : turns, tie), pair->rendered ? 0.0f : pair->fate);
	f32 margin = shown ? ts_min(turns, pair->fate) : comes;
	if (margin <= TS_MARGIN_REACH) ts_k_least_bits(&args->margin[texel], margin);
}

/* Margins in the texel of the pair's middle, and in those into which rounding may move the middle. */
TS_FN void ts_k_middle_margin(const ts_view_map_margin_args *args, const ts_placed *pair, u64 first, ts_v3 vs)
{
	/* Find the texel of the middle, and the margins against its nearest edge along each axis. */
	u32 n = args->pyramid.n;
	ts_v2 at = ts_k_paraboloid_at(vs, n);
	ts_beside x = ts_k_beside(at.x);
	ts_beside y = ts_k_beside(at.y);
	f32 of_x = ts_k_place_margin(vs.y, &x, n);
	f32 of_y = ts_k_place_margin(vs.z, &y, n);
	u32 own = ts_k_paraboloid_index(vs, x.own, y.own, n);
	/* Judge the texels beyond these edges: to reach the one across the corner, both edges must be passed, so the
	 * greater margin counts. */
	f32 leaves = TS_MARGIN_NOWHERE;
	for (u32 k = 1u; k < 4u; k++) {
		f32 turns = ts_max((k & 1u) != 0u ? of_x : 0.0f, (k & 2u) != 0u ? of_y : 0.0f);
		u32 texel = ts_k_paraboloid_index(vs, (k & 1u) != 0u ? x.next : x.own, (k & 2u) != 0u ? y.next : y.own, n);
		/* Leave out texels beyond the border, which are clamped to the own texel. */
		if (texel == own) continue;
		leaves = ts_min(leaves, turns);
		ts_k_place_turns(args, pair, first + texel, false, turns);
	}
	/* Judge the own texel, which the pair leaves across the nearest edge. */
	ts_k_place_turns(args, pair, first + own, true, leaves);
}

/* The margin of `inside` against 0, in steps of its error: 8 ulps of the distance, divided by the cosine of the ball's
 * angular radius. */
TS_FN f32 ts_k_cap_margin(const ts_cap *cap, f32 d, f32 inside)
{
	f32 edge = ts_max(0.5f * (cap->b - cap->c), d * TS_MARGIN_LEAST_SINE);
	f32 unit = cap->rounding * (d / edge);
	return unit > 0.0f ? ts_abs(inside) / unit : TS_MARGIN_NOWHERE;
}

/* The margin of the test whether a ball is filled: of its width against one texel, in 16 ulps. */
TS_FN f32 ts_k_width_margin(const ts_placed *pair) { return ts_abs(pair->width - 1.0f) / (2.0f * TS_MARGIN_ROUNDING); }

/* Margins in a texel that a wide ball fills, unless a coarser texel that contains it is filled. */
TS_FN void ts_k_texel_margin(const ts_view_map_margin_args *args, const ts_placed *pair, const ts_cap *cap, u64 texel,
                             u32 level, u32 column, u32 row)
{
	/* Evaluate the cap in the texel, and in the coarser texel that contains it, if there is one. */
	bool last = level + 1u == args->pyramid.levels;
	f32 inside = ts_k_cap_inside(cap, args->pyramid.n, level, column, row);
	f32 above = last ? -1.0f : ts_k_cap_inside(cap, args->pyramid.n, level + 1u, column >> 1u, row >> 1u);
	/* Find the margins of these two tests where they matter: of the texel if the coarser one is not filled, of the
	 * coarser one if the texel is inside. */
	f32 of_inside = above < 0.0f ? ts_k_cap_margin(cap, pair->d, inside) : TS_MARGIN_NOWHERE;
	f32 of_above = !last && inside >= 0.0f ? ts_k_cap_margin(cap, pair->d, above) : TS_MARGIN_NOWHERE;
	/* Take the least of both and of the test whether the view is in the ball. */
	f32 turns = ts_min(ts_min(of_inside, of_above), ts_abs(pair->d - cap->radius) / (cap->radius * TS_MARGIN_ROUNDING));
	/* Add the test of the width: a texel that is not filled needs all tests that keep the ball out to change. */
	bool covered = inside >= 0.0f && above < 0.0f;
	bool wide = pair->width > 1.0f;
	f32 of_width = ts_k_width_margin(pair);
	f32 comes = ts_max(covered ? 0.0f : turns, wide ? 0.0f : of_width);
	bool is_there = covered && wide;
	/* Judge the texel, unless the node is shown there as a point, which ts_k_middle_margin judges. */
	bool of_middle = args->texels[texel] != TS_EMPTY && (u32)args->texels[texel] == pair->node && !is_there;
	if (!of_middle) ts_k_place_turns(args, pair, texel, is_there, is_there ? ts_min(turns, of_width) : comes);
}

TS_FN void ts_k_fill_margin(const ts_view_map_margin_args *args, const ts_placed *pair, u64 first, ts_v3 vs, f32 radius,
                            bool back)
{
	ts_cap cap = ts_k_cap(vs, radius, back);
	ts_cap_box box = ts_k_cap_box(&cap, args->pyramid.n);
	if (box.x.from >= box.x.to || box.y.from >= box.y.to) return;
	for (u32 level = 0u; level < args->pyramid.levels; level++) {
		u32 side = args->pyramid.n >> level;
		u64 map = first + ts_k_pyramid_first(&args->pyramid, level) + (back ? (u64)side * side : 0u);
		for (u32 row = (u32)box.y.from >> level; row <= ((u32)box.y.to - 1u) >> level; row++) {
			for (u32 column = (u32)box.x.from >> level; column <= ((u32)box.x.to - 1u) >> level; column++) {
				ts_k_texel_margin(args, pair, &cap, map + (u64)row * side + column, level, column, row);
			}
		}
	}
}

/* Margins of a pair in the texels that it is in, and in those to which rounding may move it. */
TS_FN void ts_k_placed_margin(const ts_view_map_margin_args *args, u64 pair, f32 fate_margin, bool rendered)
{
	/* Find the map of the pair, and the way from its middle to the node. */
	TS_GLOBAL const ts_node *node = &args->of.nodes[ts_k_pair_node(pair)];
	u64 first = (u64)ts_k_pair_views(pair) * ts_k_pyramid_texels(&args->pyramid);
	ts_v3 vs = ts_sub(ts_load3(node->centre), ts_load3(args->of.views[ts_k_pair_views(pair)].centre));
	/* Describe the pair; a ball counts as wide where every ball is filled. */
	ts_placed placed;
	placed.node = ts_k_pair_node(pair);
	placed.d = ts_length(vs);
	placed.fate = fate_margin;
	placed.rendered = rendered;
	f32 radius = node->radius * args->pyramid.fill;
	placed.width = 2.0f * (f32)args->pyramid.n;
	/* Judge the texel of the middle, if points are rendered; leave out a ball whose width is far below a texel. */
	if (args->pyramid.point != 0u) {
		ts_k_middle_margin(args, &placed, first, vs);
		placed.width = ts_k_map_width(&args->pyramid, vs, radius);
		bool narrow = !(placed.width > 1.0f) && ts_k_width_margin(&placed) > TS_MARGIN_REACH;
		if (!(radius > 0.0f) || narrow) return;
	}
	/* Judge the texels of the ball in both maps. */
	ts_k_fill_margin(args, &placed, first, vs, radius, false);
	ts_k_fill_margin(args, &placed, first, vs, radius, true);
}

/* scatter over pairs, before they are decided. Two leaves have no pairs below them. */
TS_FN void ts_k_view_map_margin_item(const ts_view_map_margin_args *args, u64 i)
{
	/* Take the pair from the queue, or by its number if there is none. */
	u64 pair = ts_k_pair(args->first + (u32)(i % args->n_nodes), (u32)(i / args->n_nodes));
	if (args->pairs != NULL) pair = args->pairs[i];
	/* Decide the pair again, and find the margin of the decision. */
	u32 fate = ts_k_pair_fate(&args->of, pair);
	f32 margin = ts_k_fate_margin(&args->of, pair, fate);
	/* Lower the margins of all pairs below, if the decision is near; below two leaves there are none. */
	bool leaf = args->of.nodes[ts_k_pair_node(pair)].children == 0u;
	bool leaves = leaf && args->of.views[ts_k_pair_views(pair)].children == 0u;
	bool turns = margin <= TS_MARGIN_REACH;
	if (turns && !leaves) ts_k_fate_margin_spread(args, pair, margin);
	/* Leave out the view's own reflector, which is not rendered. */
	if (ts_k_pair_is_own(&args->own, args->of.views, pair)) return;
	/* Judge the texels of a pair that is rendered, or would be if its fate turned. */
	if (fate == TS_PAIR_RENDER || (turns && leaves)) ts_k_placed_margin(args, pair, margin, fate == TS_PAIR_RENDER);
}

#endif
