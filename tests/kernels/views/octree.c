/* Octrees of any mask: nodes by level and Morton code, linked both ways, with the boxes that they stand for; and the
 * cones of views, against looking at every view in every node. */
#include <string.h>
#include "../../../src/kernels/base/sort.h"
#include "../../../src/kernels/views/octree.h"
#include "../../../src/kernels/views/view_octree_cone.h"
#include "../../../src/kernels/views/view_octree.h"
#include "../seeded.h"

enum { MOST = 4, N_WORLDS = 300, LEAVES = 1 << (3 * MOST), NODES = LEAVES * 2, WORDS = 100, VIEWS = 500 };

/* Of one octree, room for any of MOST levels. */
typedef struct {
	u32 levels, n_words, n, n_leaves;
	ts_root root;
	u64 mask[WORDS];
	u32 before[WORDS + 1], level[MOST + 2];
	ts_node nodes[NODES];
} tree;

static void sum(u32 *counts, u32 n)
{
	u32 total = 0;
	for (u32 i = 0; i <= n; i++) {
		u32 count = counts[i];
		counts[i] = total;
		total += i < n ? count : 0;
	}
}

static void begin(tree *t, u32 levels)
{
	memset(t, 0, sizeof *t);
	t->levels = levels;
	t->n_words = (u32)ts_k_mask_first(levels + 1);
	t->root.side = uniform(0.1f, 100);
	ts_store3(t->root.lower, uniform3(-50, 50));
}

static void finish(tree *t)
{
	ts_mask_args up = {.mask = t->mask, .before = t->before};
	for (up.level = t->levels; up.level-- > 0;) {
		u64 words = ts_k_mask_first(up.level + 1) - ts_k_mask_first(up.level);
		for (u64 i = words; i-- > 0;) ts_k_mask_up_item(&up, i);
	}
	for (u64 i = 0; i < t->n_words; i++) ts_k_mask_count_item(&up, i);
	sum(t->before, t->n_words);
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

/* Leaves of one in `sparse` codes, or a single one, or none. */
static void fill(tree *t, bool *leaf, u32 kind)
{
	u32 sparse = kind % 5 == 0 ? 1 : kind % 5 == 1 ? 2 : kind % 5 == 2 ? 20 : 400, n = 1u << (3 * t->levels);
	for (u32 code = 0; code < n; code++) leaf[code] = kind % 5 == 4 ? code == kind / 5 * 37 % n : below(sparse) == 0;
	if (kind % 25 == 24) memset(leaf, 0, n);
	for (u32 code = 0; code < n; code++) {
		if (leaf[code]) t->mask[ts_k_mask_word(t->levels, code)] |= ts_k_mask_bit(code);
	}
}

/* Any leaf at or below the voxel. */
static bool is_used(const tree *t, const bool *leaf, u32 level, u32 code)
{
	u32 each = 1u << (3 * (t->levels - level));
	for (u32 k = 0; k < each; k++) {
		if (leaf[code * each + k]) return true;
	}
	return false;
}

/* The box of a voxel from the bits of its code, in double precision. */
static void check_box(const tree *t, const ts_node *node, u32 level, u32 code)
{
	double side = (double)t->root.side / (1 << level);
	for (u32 axis = 0; axis < 3; axis++) {
		u32 place = 0;
		for (u32 b = 0; b < level; b++) place |= (code >> (3 * b + axis) & 1) << b;
		double right = (double)t->root.lower[axis] + (place + 0.5) * side;
		assert_near(node->centre[axis], right, 1e-5 * ((double)t->root.side + 50));
	}
	double radius = sqrt(3) / 2 * side;
	assert_near(node->radius, radius, 1e-7 * radius);
}

/* Node by node, as a walk over all voxels of all levels counts them. */
static void test_nodes(void **state)
{
	(void)state;
	static tree t;
	static bool leaf[LEAVES];
	static u32 id[MOST + 1][LEAVES];
	for (u32 world = 0; world < N_WORLDS; world++) {
		begin(&t, 1 + world % MOST);
		fill(&t, leaf, world / MOST);
		finish(&t);
		u32 n = 0;
		for (u32 level = 0; level <= t.levels; level++) {
			assert_int_equal(t.level[level], n);
			for (u32 code = 0; code < 1u << (3 * level); code++) {
				id[level][code] = is_used(&t, leaf, level, code) ? n++ : TS_NONE;
			}
		}
		assert_int_equal(t.n, n);
		for (u32 level = 0; level <= t.levels; level++) {
			for (u32 code = 0; code < 1u << (3 * level); code++) {
				if (id[level][code] == TS_NONE) continue;
				const ts_node *node = &t.nodes[id[level][code]];
				check_box(&t, node, level, code);
				assert_int_equal(node->level, level);
				assert_int_equal(node->parent, level != 0 ? id[level - 1][code / 8] : TS_NONE);
				u32 next = node->child;
				for (u32 o = 0; o < 8; o++) {
					u32 child = level < t.levels ? id[level + 1][8 * code + o] : TS_NONE;
					assert_int_equal(node->children >> o & 1, child != TS_NONE);
					if (child != TS_NONE) assert_int_equal(child, next++);
				}
				assert_int_equal(node->children == 0, level == t.levels);
				assert_int_equal(node->child == TS_NONE, level == t.levels);
			}
		}
	}
}

typedef struct {
	ts_vpl views[VIEWS];
	u32 n, leaf[VIEWS], entries[VIEWS], offset[LEAVES + 2], least[NODES];
	u64 sums[3 * NODES];
	ts_cone cones[NODES];
} views;

/* Directions of any sort, all alike, or of two that cancel. */
static void fill_views(views *v, const ts_root *root, u32 kind)
{
	v->n = kind % 10 == 9 ? 0 : 1 + below(VIEWS);
	ts_v3 pole = direction(), nook = uniform3(0, 1);
	for (u32 i = 0; i < v->n; i++) {
		ts_v3 at = kind % 3 == 0 ? uniform3(0, 1) : kind % 3 == 1 ? nook : uniform3(0, 0.2f);
		ts_v3 d = kind % 4 == 0 ? direction() : kind % 4 == 1 ? pole : i % 2 == 0 ? pole : ts_neg(pole);
		if (kind % 4 == 2) d = ts_normalize(ts_mad(pole, direction(), 0.3f));
		ts_store3(v->views[i].position, ts_mad(ts_load3(root->lower), at, root->side));
		ts_store3(v->views[i].normal, d);
	}
}

static void make_tree(tree *t, views *v)
{
	ts_view_octree_args args = {.root = &t->root,
	                            .views = v->views,
	                            .mask = t->mask,
	                            .bits = t->mask,
	                            .before = t->before,
	                            .leaf = v->leaf,
	                            .offset = v->offset,
	                            .entries = v->entries,
	                            .levels = t->levels};
	for (u64 i = v->n; i-- > 0;) ts_k_view_octree_voxel_item(&args, i);
	finish(t);
	args.first_leaf = t->level[t->levels];
	memset(v->offset, 0, sizeof v->offset);
	for (u64 i = v->n; i-- > 0;) ts_k_view_octree_leaf_item(&args, i);
	sum(v->offset, t->n_leaves + 1);
	for (u64 i = v->n; i-- > 0;) ts_k_view_octree_list_item(&args, i);
	ts_sort_args sort = {.offset = v->offset, .entries = v->entries};
	for (u64 i = 0; i < t->n_leaves; i++) ts_k_leaf_sort_item(&sort, i);
}

static void make_cones(const tree *t, views *v)
{
	ts_cone_args args = {.views = v->views,
	                     .nodes = t->nodes,
	                     .offset = v->offset,
	                     .entries = v->entries,
	                     .leaf = v->leaf,
	                     .sums = v->sums,
	                     .least = v->least,
	                     .cones = v->cones,
	                     .first = t->level[t->levels]};
	for (u64 i = 0; i < t->n_leaves; i++) ts_k_cone_leaf_item(&args, i);
	for (u32 level = t->levels; level-- > 0;) {
		args.first = t->level[level];
		for (u64 i = 0; i < t->level[level + 1] - args.first; i++) ts_k_cone_inner_item(&args, i);
	}
	memset(v->least, 0xff, sizeof v->least);
	for (u64 i = v->n; i-- > 0;) ts_k_cone_least_item(&args, i);
	for (u64 i = 0; i < t->n; i++) ts_k_cone_item(&args, i);
}

/* A voxel of its level holds the place; where rounding decides, it may lie a little outside. */
static bool holds(const ts_node *node, const f32 *p, double slack)
{
	double half = (double)node->radius / sqrt(3) + slack;
	for (u32 k = 0; k < 3; k++) {
		if (fabs((double)p[k] - (double)node->centre[k]) > half) return false;
	}
	return true;
}

/* The views of a node: all in its list, in its box, each once; its axis and angle are theirs. */
static void check_cone(const tree *t, const views *v, u32 node)
{
	const ts_cone *cone = &v->cones[node];
	double3 all = {0, 0, 0};
	double least = 2;
	assert_true(cone->views > 0 && cone->first + cone->views <= v->n);
	for (u32 k = cone->first; k < cone->first + cone->views; k++) {
		const ts_vpl *view = &v->views[v->entries[k]];
		u32 above = v->leaf[v->entries[k]];
		assert_true(holds(&t->nodes[node], view->position, (double)t->root.side / 512));
		while (above != node && above != TS_NONE) above = t->nodes[above].parent;
		assert_int_equal(above, node);
		all = d3_add(all, d3_of(ts_load3(view->normal)));
		double cosine = d3_dot(d3_of(ts_load3(view->normal)), d3_of(ts_load3(cone->axis)));
		least = cosine < least ? cosine : least;
	}
	assert_near(cone->cosine, least < -1 ? -1 : least > 1 ? 1 : least, 3e-7);
	assert_near(d3_length(d3_of(ts_load3(cone->axis))), 1, 1e-6);
	if (d3_length(all) > 1e-3) assert_true(d3_dot(d3_of(ts_load3(cone->axis)), d3_unit(all)) > 1 - 1e-6);
}

static void test_cones(void **state)
{
	(void)state;
	static tree t;
	static views v;
	u32 n_opposite = 0;
	for (u32 world = 0; world < N_WORLDS; world++) {
		begin(&t, 1 + world % MOST);
		fill_views(&v, &t.root, world / MOST);
		make_tree(&t, &v);
		make_cones(&t, &v);
		assert_int_equal(v.offset[t.n_leaves], v.n);
		for (u32 node = 0; node < t.n; node++) check_cone(&t, &v, node);
		if (t.n > 0) assert_int_equal(v.cones[0].views, v.n);
		for (u32 leaf = 0; leaf < t.n_leaves; leaf++) {
			for (u32 k = v.offset[leaf] + 1; k < v.offset[leaf + 1]; k++) assert_true(v.entries[k - 1] < v.entries[k]);
		}
		bool cancels = t.n > 0 && v.sums[0] == 0 && v.sums[1] == 0 && v.sums[2] == 0;
		if (cancels) assert_true(v.cones[0].axis[2] == 1);
		n_opposite += cancels;
	}
	assert_true(n_opposite > 5);
}

/* Ordered bits: the order of the numbers, and back. */
static void test_ordered(void **state)
{
	(void)state;
	for (u32 i = 0; i < 100000; i++) {
		f32 a = uniform(-1, 1) * (f32)exp2((double)uniform(-60, 60)), b = i % 2 == 0 ? -a : uniform(-1, 1);
		assert_int_equal(a < b, ts_k_ordered(a) < ts_k_ordered(b));
		assert_true(same_bits(ts_k_of_ordered(ts_k_ordered(a)), a));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(test_nodes),
		seeded_test(test_cones),
		seeded_test(test_ordered),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
