/* The views that may light each part of the scene: for every node of the scene at one level a list of the nodes of
 * views at that level that are not culled, by the traversal of traverse.h (MegaViews section 5.1; METHODS 14). With the
 * prefix sums of their views one random number picks a view. */
#ifndef TS_KERNELS_VIEWS_VPL_GATHER_PAIRS_H
#define TS_KERNELS_VIEWS_VPL_GATHER_PAIRS_H
#include "kernels/base/args.h"
#include "kernels/views/traverse.h"

#define TS_ROWS_ts_vpl_gather_pairs_args(ARG) \
	ARG(WORK_IN, u64, pairs, queue) /* the pairs that are left of a queue */ \
	ARG(IN, ts_cone, cones, view_octree_cone) \
	ARG(SUM, u32, offset, vpl_gather_pair_offset) /* [k + 1]: count, start, then end of list k */ \
	ARG(OUT, u32, nodes, vpl_gather_pair_node) \
	ARG(OUT, u32, views, vpl_gather_pair_views) \
	ARG(VALUE, u32, first, none) /* node of list 0 */
TS_ARGS(ts_vpl_gather_pairs_args);

/* scatter over pairs: counts of the lists */
TS_FN void ts_k_vpl_gather_pairs_count_item(const ts_vpl_gather_pairs_args *args, u64 i)
{
	u64 pair = args->pairs[i];
	if (pair < TS_STRUCK) (void)ts_next_u32(&args->offset[ts_k_pair_node(pair) - args->first + 1u]);
}

/* scatter over pairs: the lists, in the order of arrival, until leaf_sort sorts them */
TS_FN void ts_k_vpl_gather_pairs_list_item(const ts_vpl_gather_pairs_args *args, u64 i)
{
	u64 pair = args->pairs[i];
	if (pair >= TS_STRUCK) return;
	args->nodes[ts_next_u32(&args->offset[ts_k_pair_node(pair) - args->first + 1u])] = ts_k_pair_views(pair);
}

/* map over lists, which are done */
TS_FN void ts_k_vpl_gather_pairs_sum_item(const ts_vpl_gather_pairs_args *args, u64 i)
{
	u32 sum = 0u;
	for (u32 k = args->offset[i]; k < args->offset[i + 1u]; k++) {
		sum += args->cones[args->nodes[k]].views;
		args->views[k] = sum;
	}
}

#endif
