/* What the octrees of the scene and of the views share: masks, nodes and the lists of the leaves. */
#ifndef TS_STAGES_OCTREE_H
#define TS_STAGES_OCTREE_H
#include "stages.h"

/* The buffers of one of them. */
typedef struct {
	ts_buffer_id mask, before, level, node, offset, entries;
	const char *nodes, *leaves, *bytes; /* counters */
} ts_octree;
extern const ts_octree ts_scene_octree, ts_view_octree;

/* The mask of all levels, empty; NULL without memory. */
u64 *ts_octree_mask(ts_run *run, const ts_octree *octree);
/* The levels above the leaves, and the ids. */
ts_status ts_octree_ids(ts_run *run, const ts_octree *octree);
/* The nodes, and the offsets of the leaves' lists as zeros, one more than there will be: counts stand one later than their
 * leaf. */
ts_status ts_octree_nodes(ts_run *run, const ts_octree *octree);
/* Counts to sums: where each leaf begins now stands one later, and has moved to its place when as many entries were written
 * there as were counted. Makes the entries. */
ts_status ts_octree_lists(ts_run *run, const ts_octree *octree);
/* The entries of each leaf in order. */
ts_status ts_octree_sort(ts_run *run, const ts_octree *octree);
/* The first node of a level; of level levels + 1 the number of nodes. */
u32 ts_octree_first(const ts_run *run, const ts_octree *octree, u32 level);

#endif
