/* The octree of the views, which are virtual point lights: every view is in the leaf voxel that contains it (METHODS
 * 12). */
#ifndef TS_KERNELS_VIEWS_VIEW_OCTREE_H
#define TS_KERNELS_VIEWS_VIEW_OCTREE_H
#include "kernels/base/args.h"
#include "kernels/views/mask.h"
#include "kernels/views/octree_root.h"

#define TS_ROWS_ts_view_octree_args(ARG) \
	ARG(IN, ts_root, root, octree_root) \
	ARG(IN, ts_vpl, views, vpl_light) \
	ARG(SUM, u64, mask, view_octree_voxel_mask) \
	ARG(IN, u64, bits, view_octree_voxel_mask) /* the finished mask */ \
	ARG(IN, u32, before, view_octree_voxel_before) \
	ARG(OUT, u32, leaf, view_octree_leaf) \
	ARG(SUM, u32, offset, view_octree_offset) /* [k + 1]: count, start, then end of list k */ \
	ARG(OUT, u32, entries, view_octree_view) \
	ARG(VALUE, u32, levels, none) \
	ARG(VALUE, u32, first_leaf, none) /* a node */
TS_ARGS(ts_view_octree_args);

TS_FN u64 ts_k_view_code(const ts_view_octree_args *args, u64 i)
{
	return ts_k_morton(ts_k_voxel_of(args->root, args->levels, ts_load3(args->views[i].position)));
}

/* scatter over views: into the mask */
TS_FN void ts_k_view_octree_voxel_item(const ts_view_octree_args *args, u64 i)
{
	u64 code = ts_k_view_code(args, i);
	ts_or_u64(&args->mask[ts_k_mask_word(args->levels, code)], ts_k_mask_bit(code));
}

/* scatter over views: counts of the leaves */
TS_FN void ts_k_view_octree_leaf_item(const ts_view_octree_args *args, u64 i)
{
	u32 leaf = ts_k_mask_id(args->bits, args->before, args->levels, ts_k_view_code(args, i));
	args->leaf[i] = leaf;
	(void)ts_next_u32(&args->offset[leaf - args->first_leaf + 1u]);
}

/* scatter over views: lists of the leaves, in the order of arrival, until leaf_sort sorts them */
TS_FN void ts_k_view_octree_list_item(const ts_view_octree_args *args, u64 i)
{
	args->entries[ts_next_u32(&args->offset[args->leaf[i] - args->first_leaf + 1u])] = (u32)i;
}

#endif
