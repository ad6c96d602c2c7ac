/* An octree of few levels, whose leaves a test sets in its mask. */
#ifndef TS_TESTS_KERNELS_VIEWS_TREE_H
#define TS_TESTS_KERNELS_VIEWS_TREE_H
#include <string.h>
#include "kernels/views/octree.h"
#include "tests/kernels/seeded.h"
#include "tests/kernels/sums.h"

enum { MOST = 4, LEAVES = 1 << (3 * MOST), NODES = LEAVES * 2, WORDS = 100 };

/* Room for any of MOST levels. */
typedef struct {
	u32 levels, n_words, n, n_leaves;
	ts_root root;
	u64 mask[WORDS];
	u32 before[WORDS + 1], level[MOST + 2];
	ts_node nodes[NODES];
} tree;

/* No leaves, anywhere. */
static inline void tree_begin(tree *t, u32 levels)
{
	memset(t, 0, sizeof *t);
	t->levels = levels;
	t->n_words = (u32)ts_k_mask_first(levels + 1);
	t->root.side = uniform(0.1f, 100);
	ts_store3(t->root.lower, uniform3(-50, 50));
}

/* The nodes of the mask of leaves. */
static inline void tree_finish(tree *t)
{
	ts_mask_args up = {.mask = t->mask, .before = t->before};
	for (up.level = t->levels; up.level-- > 0;) {
		u64 words = ts_k_mask_first(up.level + 1) - ts_k_mask_first(up.level);
		for (u64 i = words; i-- > 0;) ts_k_mask_up_item(&up, i);
	}
	for (u64 i = 0; i < t->n_words; i++) ts_k_mask_count_item(&up, i);
	prefix_sums(t->before, t->n_words);
	ts_octree_args args = {.root = &t->root,
	                       .mask = t->mask,
	                       .before = t->before,
	                       .level = t->level,
	                       .nodes = t->nodes,
	                       .levels = t->levels};
	for (u64 i = 0; i < t->levels + 2; i++) ts_k_octree_level_item(&args, i);
	for (u64 i = t->n_words; i-- > 0;) ts_k_octree_item(&args, i);
	t->n = t->level[t->levels + 1];
	t->n_leaves = t->n - t->level[t->levels];
	assert_true(t->n <= NODES);
}

/* Nodes that their parents do not hold, so that no step of a traversal answers for another. */
static inline void tree_shake(tree *t)
{
	for (u32 i = 0; i < t->n; i++) {
		ts_node *node = &t->nodes[i];
		ts_store3(node->centre, ts_mad(ts_load3(node->centre), direction(), uniform(0, 4) * node->radius));
	}
}

#endif
