/* What the octrees of the scene and of the views share: masks, nodes and the lists of the leaves. */
#ifndef TS_STAGES_OCTREE_H
#define TS_STAGES_OCTREE_H
#include "../../kernels/base/sort.h"
#include "../../kernels/views/octree.h"
#include "../../kernels/views/voxel.h"
#include "views.h"

/* The buffers of one of them, what is launched to make them, and its counters. */
typedef struct {
	ts_buffer_id mask, before, level, node, offset, entries;
	ts_dim n_nodes;
	ts_launch raised, counted; /* of the mask: levels above the leaves, ids */
	ts_launch levels, nodes, sorted;
	const char *name_nodes, *name_leaves, *name_bytes;
} ts_octree;
extern const ts_octree ts_scene_octree, ts_view_octree;

#define TS_OCTREE(mask_, before_, level_, node_, offset_, entries_, n_nodes_, of) \
	{ \
		TS_B_##mask_, TS_B_##before_, TS_B_##level_, TS_B_##node_, TS_B_##offset_, TS_B_##entries_, TS_DIM_##n_nodes_, \
			TS_LAUNCH(mask_up, TS_OUT(mask, mask_), TS_BUT(before)), \
			TS_LAUNCH(mask_count, TS_IN(mask, mask_), TS_OUT(before, before_)), \
			TS_LAUNCH(octree_level, TS_IN(mask, mask_), TS_IN(before, before_), TS_OUT(level, level_), TS_BUT(nodes)), \
			TS_LAUNCH(octree, TS_IN(mask, mask_), TS_IN(before, before_), TS_OUT(nodes, node_), TS_BUT(level)), \
			TS_LAUNCH(leaf_sort, TS_IN(offset, offset_), TS_OUT(entries, entries_)), of " nodes", of " leaves", \
			of " octree bytes" \
	}

/* What the voxels of triangles do not take of the scene. */
#define TS_BUT_LIT TS_BUT(scene.lights), TS_BUT(scene.objects)
/* Arguments of the kernel that visits them, but pointers (voxel.c). */
ts_voxel_args ts_voxel_values(const ts_run *run);

/* The levels above the leaves, whose mask is made, and the ids. */
ts_status ts_octree_ids(ts_run *run, const ts_octree *octree);
/* The nodes, and their number. */
ts_status ts_octree_nodes(ts_run *run, const ts_octree *octree);
/* The entries of each leaf in order. Where lists begin stood one later than their leaf while they were written, and
 * has moved to its place: what was one longer is cut. */
ts_status ts_octree_sort(ts_run *run, const ts_octree *octree);
/* The first node of a level; of level levels + 1 the number of nodes. */
u32 ts_octree_first(const ts_run *run, const ts_octree *octree, u32 level);
/* Runs over the nodes of the scene's octree from the leaves up, a level a launch; `first`, in the arguments, is the
 * first node of each. */
ts_status ts_octree_rise(ts_run *run, const ts_launch *leaves, const ts_launch *nodes, const void *args, u32 *first);

#endif
