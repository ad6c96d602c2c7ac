/* Which views may light what: for every node of the scene of one level a list of the nodes of views of that level that
 * culling leaves, by the same traversal (MegaViews section 5.1; METHODS 14). With the sums of their views one random
 * number names a view. */
#ifndef TS_KERNELS_VPL_PAIRS_H
#define TS_KERNELS_VPL_PAIRS_H
#include "traverse.h"

typedef struct {
	TS_GLOBAL const u64 *pairs;     /* what is left of a queue */
	TS_GLOBAL const ts_cone *cones; /* view_cone.node */
	TS_GLOBAL u32 *offset;          /* of vpl_pairs.offset, one later */
	TS_GLOBAL u32 *nodes;           /* vpl_pairs.node */
	TS_GLOBAL u32 *views;           /* vpl_pairs.views */
	u32 first;                      /* node of list 0 */
} ts_vpl_pairs_args;

/* scatter over pairs: counts of the lists */
TS_FN void ts_k_vpl_pairs_count_item(const ts_vpl_pairs_args *args, u64 i)
{
	u64 pair = args->pairs[i];
	if (pair < TS_STRUCK) (void)ts_next_u32(&args->offset[ts_k_pair_node(pair) - args->first + 1u]);
}

/* scatter over pairs: the lists */
TS_FN void ts_k_vpl_pairs_list_item(const ts_vpl_pairs_args *args, u64 i)
{
	u64 pair = args->pairs[i];
	if (pair >= TS_STRUCK) return;
	args->nodes[ts_next_u32(&args->offset[ts_k_pair_node(pair) - args->first + 1u])] = ts_k_pair_views(pair);
}

/* map over lists, which are done */
TS_FN void ts_k_vpl_pairs_sum_item(const ts_vpl_pairs_args *args, u64 i)
{
	u32 sum = 0u;
	for (u32 k = args->offset[i]; k < args->offset[i + 1u]; k++) {
		sum += args->cones[args->nodes[k]].views;
		args->views[k] = sum;
	}
}

#endif
