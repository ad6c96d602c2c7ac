/* The nodes of an octree from the masks of its levels. Ids number the set bits, so nodes are sorted by level and Morton
 * code (METHODS 12). */
#ifndef TS_KERNELS_VIEWS_OCTREE_H
#define TS_KERNELS_VIEWS_OCTREE_H
#include "kernels/base/args.h"
#include "kernels/views/mask.h"
#include "kernels/views/octree_root.h"

#define TS_ROWS_ts_octree_args(ARG) \
	ARG(IN, ts_root, root, octree_root) \
	ARG(IN, u64, mask, voxel_mask) \
	ARG(IN, u32, before, voxel_before) \
	ARG(OUT, u32, level, octree_level) /* nodes before each level */ \
	ARG(OUT, ts_node, nodes, octree_node) \
	ARG(VALUE, u32, levels, none)
TS_ARGS(ts_octree_args);

/* map over levels, and one more item for the number of all nodes */
TS_FN void ts_k_octree_level_item(const ts_octree_args *args, u64 i)
{
	args->level[i] = args->before[ts_k_mask_first((u32)i)];
}

/* Sets the bounding sphere of a voxel: its centre and half its diagonal. */
TS_FN void ts_k_octree_ball(TS_GLOBAL ts_node *node, TS_GLOBAL const ts_root *root, u32 level, u64 code)
{
	ts_store3(node->centre, ts_k_voxel_middle(root, level, ts_k_unmorton(code)));
	node->radius = ts_put(ts_k_voxel_side(root, level) * TS_HALF_ROOT_3);
}

TS_FN void ts_k_octree_links(const ts_octree_args *args, TS_GLOBAL ts_node *node, u32 level, u64 code)
{
	node->level = level;
	node->parent = level == 0u ? TS_NONE : ts_k_mask_id(args->mask, args->before, level - 1u, code >> 3);
	node->child = TS_NONE;
	node->children = 0u;
	if (level == args->levels) return;
	u64 octants = args->mask[ts_k_mask_word(level + 1u, code << 3)] >> ((code << 3) & 63u);
	node->child = ts_k_mask_id(args->mask, args->before, level + 1u, code << 3);
	node->children = (u32)octants & 255u;
}

/* emit over words of the mask */
TS_FN void ts_k_octree_item(const ts_octree_args *args, u64 i)
{
	/* Find the level of the word's voxels, and the Morton code of the first. */
	u64 bits = args->mask[i];
	u32 level = 0u;
	TS_GLOBAL ts_node *node = args->nodes + args->before[i];
	while (level < args->levels && ts_k_mask_first(level + 1u) <= i) level++;
	u64 code = (i - ts_k_mask_first(level)) << 6;
	/* Write a node for each set bit, in the order of the bits, by which nodes are numbered. */
	for (; bits != 0u; bits >>= 1, code++) {
		if ((bits & 1u) == 0u) continue;
		ts_k_octree_ball(node, args->root, level, code);
		ts_k_octree_links(args, node, level, code);
		node++;
	}
}

#endif
