/* Octrees of any mask: nodes by level and Morton code, linked both ways, with the boxes that they stand for; ordered
 * bits. */
#include "tests/kernels/views/tree.h"

enum { N_WORLDS = 300 };

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
static void nodes_are_those_that_a_walk_counts(void **state)
{
	(void)state;
	static tree t;
	static bool leaf[LEAVES];
	static u32 id[MOST + 1][LEAVES];
	for (u32 world = 0; world < N_WORLDS; world++) {
		tree_begin(&t, 1 + world % MOST);
		fill(&t, leaf, world / MOST);
		tree_finish(&t);
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

/* Ordered bits: the order of the numbers, and back. */
static void ordered_bits_keep_the_order(void **state)
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
		seeded_test(nodes_are_those_that_a_walk_counts),
		seeded_test(ordered_bits_keep_the_order),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
