/* Code that the octrees of the scene and of the views share: masks, nodes and the lists of the leaves. */
#ifndef TS_METHODS_VIEWS_OCTREE_H
#define TS_METHODS_VIEWS_OCTREE_H
#include "kernels/base/sort.h"
#include "kernels/views/octree.h"
#include "kernels/views/voxel.h"
#include "methods/views/views.h"

/* The buffers of an octree, the launches that make them, and its counters. */
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

/* The arrays of the scene that the voxels of triangles do not need. */
#define TS_BUT_LIT TS_BUT(scene.lights), TS_BUT(scene.objects)
/* Arguments of the kernel that visits the voxels, without pointers (voxel.c). */
ts_voxel_args ts_voxel_values(const ts_run *run);

/* Makes the levels of the mask above the leaves, and the ids. */
ts_status ts_octree_ids(ts_run *run, const ts_octree *octree);
/* Makes the nodes, and sets their number. */
ts_status ts_octree_nodes(ts_run *run, const ts_octree *octree);
/* Sorts the entries of each leaf. While lists were written, the begin of a list was stored one place later than its
 * leaf, and has moved to its place; the additional element is cut off. */
ts_status ts_octree_sort(ts_run *run, const ts_octree *octree);
/* The first node of a level; of level levels + 1 the number of nodes. */
u32 ts_octree_first(const ts_run *run, const ts_octree *octree, u32 level);
/* Launches over the nodes of the scene's octree, level by level from the leaves up; `first`, in the arguments, is the
 * first node of each level. */
ts_status ts_octree_rise(ts_run *run, const ts_launch *leaves, const ts_launch *nodes, const void *args, u32 *first);

#endif
