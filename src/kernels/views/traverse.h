/* The concurrent traversal of two octrees, of the scene and of views (MegaViews section 3.2; METHODS 13). A pair is
 * scene << 32 | views, two ids of nodes. In the queue of a step a pair that is culled or too near is struck out when it
 * is decided, and a pair that is split when its children are in the next queue; the pairs that are left are rendered. A
 * decision depends only on its pair, so no pair is reached twice, and any piece of a queue may be processed to its end
 * before the rest. */
#ifndef TS_KERNELS_VIEWS_TRAVERSE_H
#define TS_KERNELS_VIEWS_TRAVERSE_H
#include "kernels/base/args.h"
#include "kernels/base/morton.h"
#include "kernels/views/pair.h"

/* Values in place of a pair; no pair has them, since no node has the id 2^32 - 1. */
#define TS_STRUCK 0xfffffffffffffffdUL /* the least of these values */
#define TS_STRUCK_CULLED 0xfffffffffffffffdUL
#define TS_STRUCK_NEAR 0xfffffffffffffffeUL
#define TS_STRUCK_SPLIT 0xffffffffffffffffUL

#define TS_STEPS 23u /* from two roots to leaves 11 levels below them */
#define TS_TALLY_PAIRS 1024u

/* Two tallies behind those of ts_k_traverse_tally_item, for a traversal without queues: the number of all pairs, and
 * that of the longest step. */
#define TS_TALLY_ALL 6u
#define TS_TALLY_LONGEST 7u
#define TS_TALLIES_AT_ONCE 8u

#define TS_ROWS_ts_traverse_args(ARG) \
	ARG(IN, ts_node, nodes, octree_node) \
	ARG(IN, ts_node, views, view_octree_node) \
	ARG(IN, ts_cone, cones, view_octree_cone) \
	ARG(WORK, u64, queue, queue)    /* of this step */ \
	ARG(WORK, u64, next, queue)     /* of the next step */ \
	ARG(WORK, u32, offset, counts)  /* children, later rendered pairs, before each: counts, then their prefix sums */ \
	ARG(WORK, u64, rendered, kept)  /* the rendered pairs of the queue */ \
	ARG(TALLY_OPT, i64, tallies, 0) /* pairs culled, near, rendered, wider, of several views; views */ \
	ARG(VALUE, u64, n_pairs, none) \
	ARG(VALUE, ts_aperture, phi, none) \
	ARG(VALUE, u32, n, none)          /* texels per side of a map */ \
	ARG(VALUE, u64, first, none)      /* of the pairs with which the traversal begins */ \
	ARG(VALUE, u32, first_node, none) /* of the nodes of the scene in those pairs */ \
	ARG(VALUE, u32, n_nodes, none)    /* 1, the root, or all leaves */ \
	ARG(VALUE, f32, apart, none)      /* radii; nearer leaves are not rendered */ \
	ARG(VALUE, u32, last, none)       /* nodes from this level on count as leaves */ \
	ARG(VALUE, u32, to_last, none)    /* not 0: only pairs of leaves are rendered */ \
	ARG(VALUE, f32, cutoff, none)     /* world units; pairs farther apart are culled; 0: none */
TS_ARGS(ts_traverse_args);

TS_FN u64 ts_k_pair(u32 node, u32 views) { return ((u64)node << 32) | views; }
TS_FN u32 ts_k_pair_node(u64 pair) { return (u32)(pair >> 32); }
TS_FN u32 ts_k_pair_views(u64 pair) { return (u32)pair; }

TS_FN ts_ball ts_k_pair_ball(const ts_traverse_args *args, TS_GLOBAL const ts_node *node)
{
	ts_ball r = ts_k_node_ball(node);
	r.leaf = r.leaf || node->level >= args->last;
	return r;
}

TS_FN u32 ts_k_pair_fate(const ts_traverse_args *args, u64 pair)
{
	/* Load the two balls, and the cone of the views. */
	ts_ball s = ts_k_pair_ball(args, &args->nodes[ts_k_pair_node(pair)]);
	ts_ball v = ts_k_pair_ball(args, &args->views[ts_k_pair_views(pair)]);
	ts_cone_k cone = ts_k_load_cone(&args->cones[ts_k_pair_views(pair)]);
	/* Cull what no view can see (MegaViews figure 4), and what lies beyond the cut-off (MegaViews 5.1). */
	if (ts_k_pair_is_culled(&s, &v, &cone, &args->phi)) return TS_PAIR_CULL;
	if (args->cutoff > 0.0f && ts_k_pair_gap(&s, &v) > args->cutoff) return TS_PAIR_CULL;
	/* Render a pair that looks the same from all its views (MegaViews figure 6). */
	if (args->to_last == 0u && ts_k_pair_is_equivalent(&s, &v, args->n)) return TS_PAIR_RENDER;
	/* Decide two leaves, which cannot be split: drop a leaf that would shadow the views beside it, render others. */
	if (ts_k_pair_is_near(&s, &v, args->apart)) return TS_PAIR_NEAR;
	if (s.leaf && v.leaf) return TS_PAIR_RENDER;
	/* Split all other pairs (MegaViews figure 8). */
	return ts_k_pair_splits_view(&s, &v) ? TS_PAIR_SPLIT_VIEW : TS_PAIR_SPLIT_SCENE;
}

/* map over the pairs with which the traversal begins: nodes of views without a parent, which have the first ids, each
 * with the scene's root, or with all leaves where there is no hierarchy of the scene */
TS_FN void ts_k_traverse_start_item(const ts_traverse_args *args, u64 i)
{
	u64 k = args->first + i;
	args->queue[i] = ts_k_pair(args->first_node + (u32)(k % args->n_nodes), (u32)(k / args->n_nodes));
}

/* map over pairs: decides each; running it twice gives the same, as where the children of a whole queue find no room
 * and a part of the queue is decided again */
TS_FN void ts_k_traverse_count_item(const ts_traverse_args *args, u64 i)
{
	/* Leave out pairs that an earlier run struck out; they have no children. */
	u64 pair = args->queue[i];
	args->offset[i] = 0u;
	if (pair >= TS_STRUCK) return;
	/* Decide the pair (MegaViews 3.2); strike it out if no view shows it. */
	u32 fate = ts_k_pair_fate(args, pair);
	if (fate == TS_PAIR_CULL) args->queue[i] = TS_STRUCK_CULLED;
	if (fate == TS_PAIR_NEAR) args->queue[i] = TS_STRUCK_NEAR;
	/* Count the pairs that take the place of a split pair. */
	if (fate == TS_PAIR_SPLIT_SCENE) args->offset[i] = ts_k_count_bits(args->nodes[ts_k_pair_node(pair)].children);
	if (fate == TS_PAIR_SPLIT_VIEW) args->offset[i] = ts_k_count_bits(args->views[ts_k_pair_views(pair)].children);
}

/* emit over pairs: the children of split pairs */
TS_FN void ts_k_traverse_item(const ts_traverse_args *args, u64 i)
{
	/* Leave out pairs that are not split. */
	u32 at = args->offset[i];
	u32 n = args->offset[i + 1u] - at;
	if (n == 0u) return;
	/* Decide again which of the two nodes is split (MegaViews figure 8). */
	u32 s = ts_k_pair_node(args->queue[i]);
	u32 v = ts_k_pair_views(args->queue[i]);
	ts_ball node = ts_k_pair_ball(args, &args->nodes[s]);
	ts_ball view = ts_k_pair_ball(args, &args->views[v]);
	bool splits_view = ts_k_pair_splits_view(&node, &view);
	/* Put a pair for each child into the next queue. */
	for (u32 k = 0u; k < n; k++) {
		args->next[at + k] =
			splits_view ? ts_k_pair(s, args->views[v].child + k) : ts_k_pair(args->nodes[s].child + k, v);
	}
	/* Strike out the pair; pairs that are left in the queue are rendered. */
	args->queue[i] = TS_STRUCK_SPLIT;
}

/* Whether a rendered pair is wider than a texel: two leaves, which cannot be split further, that are not equivalent. */
TS_FN bool ts_k_pair_is_wide(const ts_traverse_args *args, u64 pair)
{
	ts_ball s = ts_k_pair_ball(args, &args->nodes[ts_k_pair_node(pair)]);
	ts_ball v = ts_k_pair_ball(args, &args->views[ts_k_pair_views(pair)]);
	return s.leaf && v.leaf && !ts_k_pair_is_equivalent(&s, &v, args->n);
}

/* map over groups of TS_TALLY_PAIRS pairs */
TS_FN void ts_k_traverse_tally_item(const ts_traverse_args *args, u64 i)
{
	/* Count in variables of the item, so that each tally is added to once per group. */
	u64 end = (i + 1u) * TS_TALLY_PAIRS;
	i64 culled = 0, near = 0, rendered = 0, wide = 0, several = 0, served = 0;
	for (u64 k = i * TS_TALLY_PAIRS; k < end && k < args->n_pairs; k++) {
		/* Count pairs that were struck out, by cause. */
		u64 pair = args->queue[k];
		culled += pair == TS_STRUCK_CULLED ? 1 : 0;
		near += pair == TS_STRUCK_NEAR ? 1 : 0;
		if (pair >= TS_STRUCK) continue;
		/* Count rendered pairs, among them those wider than a texel, and of these those that several views share
		 * (MegaViews 3.2); sum the views that share a pair. */
		rendered++;
		u32 views = args->cones[ts_k_pair_views(pair)].views;
		bool is_wide = ts_k_pair_is_wide(args, pair);
		wide += is_wide ? 1 : 0;
		several += is_wide && views > 1u ? 1 : 0;
		served += (i64)views;
	}
	/* Add to the tallies; sums of integers do not depend on the order. */
	ts_add_i64(&args->tallies[0], culled);
	ts_add_i64(&args->tallies[1], near);
	ts_add_i64(&args->tallies[2], rendered);
	ts_add_i64(&args->tallies[3], wide);
	ts_add_i64(&args->tallies[4], several);
	ts_add_i64(&args->tallies[5], served);
}

/* map over pairs: 1 where a pair is left */
TS_FN void ts_k_render_count_item(const ts_traverse_args *args, u64 i)
{
	args->offset[i] = args->queue[i] < TS_STRUCK ? 1u : 0u;
}

/* emit over pairs: the pairs that are left */
TS_FN void ts_k_render_item(const ts_traverse_args *args, u64 i)
{
	if (args->offset[i + 1u] != args->offset[i]) args->rendered[args->offset[i]] = args->queue[i];
}

#endif
