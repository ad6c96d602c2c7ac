/* Lists of pairs at once have the entries of those that a traversal leaves, in order; and what is not done at once is
 * refused. */
#include "backends/fast.h"
#include "kernels/base/sort.h"
#include "kernels/views/vpl_gather_pairs.h"
#include "tests/kernels/views/tree.h"
#include "tests/whole.h"

enum { LISTS = LEAVES + 2, FEW = 1500, MOST_PAIRS = FEW * FEW };

static tree scene, views;
static ts_cone cones[NODES];
static u32 counts[2][LISTS], lists[2][MOST_PAIRS];

/* Leaves here and there, or all on one side. */
static void random_tree(tree *t, u32 levels, ts_root root)
{
	u32 n = 1 + below(FEW), most = 1 + below(1u << (3 * levels));
	tree_begin(t, levels);
	t->root = root;
	for (u32 i = 0; i < n; i++) {
		u64 code = below(most);
		t->mask[ts_k_mask_word(levels, code)] |= ts_k_mask_bit(code);
	}
	tree_finish(t);
}

static void random_cones(u32 n)
{
	static const f32 extremes[] = {1, -1, 0, 0.5f, 0.99999988f};
	for (u32 i = 0; i < n; i++) {
		ts_store3(cones[i].axis, direction());
		cones[i].cosine = below(3) == 0 ? extremes[below(5)] : ts_put(uniform(-0.2f, 1));
	}
}

/* Views without a parent, anywhere in the root cube: where nodes of the scene are, or not. */
static void scatter_views(u32 n)
{
	views.n = n;
	for (u32 i = 0; i < n; i++) {
		ts_v3 side = ts_v3_make(scene.root.side, scene.root.side, scene.root.side);
		ts_v3 place = ts_add(ts_load3(scene.root.lower), ts_mul(uniform3(0, 1), side));
		views.nodes[i] = (ts_node){.radius = 0, .child = TS_NONE, .parent = TS_NONE};
		ts_store3(views.nodes[i].centre, place);
	}
}

typedef struct {
	ts_traverse_args how;
	u64 n_starts;
	u32 n_lists;
} traversal;

static traversal random_traversal(void)
{
	static const ts_aperture fields[] = {{0, 1}, {-1, 0}, {0.5f, 0.86602540f}};
	u32 levels = below(MOST + 1), last = below(2) == 0 ? levels : below(levels + 1);
	ts_root root = {.side = ldexpf(uniform(1, 2), (i32)below(40) - 20)};
	ts_store3(root.lower, ts_scale(uniform3(-2, 2), root.side));
	random_tree(&scene, levels, root);
	random_tree(&views, levels, root);
	if (below(2) == 0) tree_shake(&scene);
	bool alone = last == 0 && below(2) == 0;
	if (alone) scatter_views(below(300));
	random_cones(views.n);
	traversal r = {.n_starts = alone ? views.n : 1, .n_lists = scene.level[last + 1] - scene.level[last]};
	r.how = (ts_traverse_args){.nodes = scene.nodes,
	                           .views = views.nodes,
	                           .cones = cones,
	                           .phi = fields[below(3)],
	                           .n = 16,
	                           .n_nodes = 1,
	                           .last = last,
	                           .to_last = 1};
	return r;
}

static void visit(const ts_traverse_args *how, u64 pair, const ts_vpl_gather_pairs_args *to, bool counted)
{
	const ts_node *s = &how->nodes[ts_k_pair_node(pair)], *v = &how->views[ts_k_pair_views(pair)];
	ts_vpl_gather_pairs_args args = *to;
	args.pairs = &pair;
	switch (ts_k_pair_fate(how, pair)) {
	case TS_PAIR_RENDER:
		if (counted) ts_k_vpl_gather_pairs_count_item(&args, 0);
		if (!counted) ts_k_vpl_gather_pairs_list_item(&args, 0);
		break;
	case TS_PAIR_SPLIT_SCENE:
		for (u32 k = 0; k < ts_k_count_bits(s->children); k++) {
			visit(how, ts_k_pair(s->child + k, ts_k_pair_views(pair)), to, counted);
		}
		break;
	case TS_PAIR_SPLIT_VIEW:
		for (u32 k = 0; k < ts_k_count_bits(v->children); k++) {
			visit(how, ts_k_pair(ts_k_pair_node(pair), v->child + k), to, counted);
		}
		break;
	default: break;
	}
}

static ts_vpl_gather_pairs_args lists_of(const traversal *t, u32 way)
{
	memset(counts[way], 0, sizeof counts[way]);
	return (ts_vpl_gather_pairs_args){
		.cones = cones, .offset = counts[way], .nodes = lists[way], .first = scene.level[t->how.last]};
}

static void assert_same(const traversal *t, const char *what, const void *a, const void *b, size_t bytes, u32 start)
{
	if (memcmp(a, b, bytes) == 0) return;
	fail_msg("random %u: %s differ: %u levels, of gathering %u, %llu views at the start, phi %g, %g", start, what,
	         scene.levels, t->how.last, (unsigned long long)t->n_starts, (double)t->how.phi.cosine,
	         (double)t->how.phi.sine);
}

static u32 compare(const traversal *t, u32 threads, u32 start)
{
	ts_vpl_gather_pairs_args plain = lists_of(t, 0), fast = lists_of(t, 1);
	for (u64 i = 0; i < t->n_starts; i++) visit(&t->how, ts_k_pair(0, (u32)i), &plain, true);
	assert_true(ts_c_at_once_vpl_gather_pairs_count(&t->how, &fast, t->n_starts, threads));
	assert_same(t, "counts", counts[0], counts[1], sizeof counts[0], start);
	for (u32 way = 0; way < 2; way++) prefix_sums(counts[way], t->n_lists + 1);
	u32 n = counts[0][t->n_lists + 1];
	assert_true(n <= MOST_PAIRS);
	for (u64 i = 0; i < t->n_starts; i++) visit(&t->how, ts_k_pair(0, (u32)i), &plain, false);
	assert_true(ts_c_at_once_vpl_gather_pairs_list(&t->how, &fast, t->n_starts, threads));
	assert_same(t, "ends", counts[0], counts[1], sizeof counts[0], start);
	ts_sort_args sort = {.offset = counts[0], .entries = lists[0]};
	for (u32 i = 0; i < t->n_lists; i++) ts_k_leaf_sort_item(&sort, i);
	assert_same(t, "lists", lists[0], lists[1], n * sizeof lists[0][0], start);
	return n;
}

static void pairs_at_once_equal_a_traversal(void **state)
{
	(void)state;
	u64 n_pairs = 0, n_all = 0;
	n_random = 0;
	for (u32 i = 0; i < whole_or(300, 100); i++) {
		u32 start = n_random, threads = 1 + below(7);
		traversal t = random_traversal();
		n_pairs += compare(&t, threads, start);
		n_all +=
			(u64)t.n_lists * (t.n_starts == 1 ? views.level[t.how.last + 1] - views.level[t.how.last] : t.n_starts);
	}
	/* Compilers draw the numbers of a call in different orders: some worlds have few pairs, others nearly all. */
	assert_true(n_pairs > n_all / 8 && n_pairs < n_all - n_all / 32);
}

/* What the lists do not take, and nodes of which the views' are not split first. */
static void what_lists_do_not_take_is_refused(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < whole_or(300, 100); i++) {
		traversal t = random_traversal();
		ts_vpl_gather_pairs_args args = lists_of(&t, 1);
		u32 how = below(6), last = t.how.last;
		if (how == 0) t.how.cutoff = 1;
		if (how == 1) t.how.to_last = 0;
		if (how == 2) t.how.apart = 3;
		if (how == 3) t.how.n_nodes = 2;
		if (how >= 4 && last == 0) continue;
		if (how >= 4) views.nodes[views.level[last]].radius *= 1.00000012f;
		if (how == 5) scene.nodes[scene.level[last]].radius *= 1.00000012f;
		if (t.n_starts > 0) assert_false(ts_c_at_once_vpl_gather_pairs_count(&t.how, &args, t.n_starts, 2));
		for (u32 k = 0; k < LISTS; k++) assert_int_equal(counts[1][k], 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(pairs_at_once_equal_a_traversal),
	                                   cmocka_unit_test(what_lists_do_not_take_is_refused)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
