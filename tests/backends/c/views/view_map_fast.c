/* Maps at once have the texels and the counts of those whose pairs are in queues, by the kernels: of octrees of views
 * and of views alone, with and without a hierarchy of the scene, by the middles of texels and by points, on any number
 * of threads and by vectors of any width; and what is not done at once is refused. */
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/views/view_map.h"
#include "tests/kernels/views/tree.h"
#include "tests/whole.h"

enum { FEW = 120, ALONE = 60, MOST_PAIRS = 1 << 21, MOST_TEXELS = 1 << 22, REFLECTORS = 4 };

static tree scene, views;
static ts_cone cones[NODES];
static u64 queues[2][MOST_PAIRS], *maps[2];
static u32 offset[MOST_PAIRS + 1], reflectors[NODES], leaves[REFLECTORS];

typedef struct {
	ts_traverse_args how;
	ts_view_map_args to;
	u64 n_starts, n_texels;
	i64 tallies[TS_TALLIES_AT_ONCE];
} traversal;

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

/* Views without a parent: in the root cube, or in the middles of nodes. */
static void scatter_views(u32 n)
{
	views.n = n;
	for (u32 i = 0; i < n; i++) {
		ts_v3 side = ts_v3_make(scene.root.side, scene.root.side, scene.root.side);
		ts_v3 place = ts_add(ts_load3(scene.root.lower), ts_mul(uniform3(0, 1), side));
		if (below(8) == 0) place = ts_load3(scene.nodes[below(scene.n)].centre);
		views.nodes[i] = (ts_node){.radius = 0, .child = TS_NONE, .parent = TS_NONE};
		ts_store3(views.nodes[i].centre, place);
	}
}

static void random_cones(void)
{
	static const f32 extremes[] = {1, -1, 0, 0.5f, 0.99999988f};
	for (u32 i = 0; i < views.n; i++) {
		ts_store3(cones[i].axis, direction());
		cones[i].cosine = below(3) == 0 ? extremes[below(5)] : ts_put(uniform(-0.2f, 1));
		cones[i].views = 1 + below(3);
	}
}

static void random_reflectors(u32 first_leaf)
{
	for (u32 i = 0; i < scene.n; i++) reflectors[i] = below(2) == 0 ? TS_NONE : below(REFLECTORS);
	for (u32 i = 0; i < REFLECTORS; i++) leaves[i] = first_leaf + below(views.n - first_leaf);
}

static ts_pyramid random_pyramid(void)
{
	static const f32 fills[] = {0.0625f, 0.57735f, 0.75f, 1};
	ts_pyramid r = {.n = 1u << below(11), .levels = 1, .point = below(2), .fill = fills[below(4)]};
	if (below(3) == 0) r.n = 16;
	while ((u64)r.n * r.n * 3 * views.n > MOST_TEXELS) r.n /= 2;
	if (r.point != 0 && below(2) == 0) r.fill = 0;
	while (below(2) == 0 && r.n >> r.levels > 0) r.levels++;
	if (below(2) == 0) r.levels = 1;
	return r;
}

static traversal random_traversal(void)
{
	static const ts_aperture fields[] = {{0, 1}, {-1, 0}, {0.5f, 0.86602540f}};
	u32 levels = below(MOST + 1);
	ts_root root = {.side = ldexpf(uniform(1, 2), (i32)below(40) - 20)};
	ts_store3(root.lower, ts_scale(uniform3(-2, 2), root.side));
	random_tree(&scene, levels, root);
	random_tree(&views, levels, root);
	bool alone = below(3) == 0, single = below(3) == 0;
	if (alone) scatter_views(1 + below(ALONE));
	if (below(2) == 0) tree_shake(&scene);
	random_cones();
	random_reflectors(alone ? 0 : views.level[levels]);
	traversal r = {.to = {.nodes = scene.nodes, .views = views.nodes, .pyramid = random_pyramid()}};
	r.to.own = below(3) == 0 ? (ts_own_args){reflectors, leaves} : (ts_own_args){NULL, NULL};
	r.how = (ts_traverse_args){.nodes = scene.nodes,
	                           .views = views.nodes,
	                           .cones = cones,
	                           .phi = fields[below(3)],
	                           .n = r.to.pyramid.n,
	                           .first_node = single ? scene.level[levels] : 0,
	                           .n_nodes = single ? scene.n_leaves : 1,
	                           .apart = (f32)below(4),
	                           .last = TS_NONE};
	r.n_starts = (u64)r.how.n_nodes * (alone ? views.n : 1);
	r.n_texels = (u64)ts_k_pyramid_texels(&r.to.pyramid) * views.n;
	return r;
}

static void begin_maps(traversal *t, u32 way)
{
	memset(maps[way], 0xff, t->n_texels * sizeof *maps[way]);
	memset(t->tallies, 0, sizeof t->tallies);
	t->to.texels = maps[way];
	t->how.tallies = t->tallies;
}

/* By queues, a step after the other. */
static void by_queues(traversal *t)
{
	ts_traverse_args how = t->how;
	how.offset = offset;
	how.queue = queues[0];
	for (u64 i = 0; i < t->n_starts; i++) ts_k_traverse_start_item(&how, i);
	for (u64 step = 0, n = t->n_starts; n > 0; step++) {
		how.queue = queues[step % 2];
		how.next = queues[(step + 1) % 2];
		how.n_pairs = n;
		for (u64 i = 0; i < n; i++) ts_k_traverse_count_item(&how, i);
		prefix_sums(offset, (u32)n);
		u32 children = offset[n];
		assert_true(children <= MOST_PAIRS);
		for (u64 i = 0; i < n; i++) ts_k_traverse_item(&how, i);
		for (u64 i = 0; i * TS_TALLY_PAIRS < n; i++) ts_k_traverse_tally_item(&how, i);
		t->tallies[TS_TALLY_ALL] += (i64)n;
		if ((i64)n > t->tallies[TS_TALLY_LONGEST]) t->tallies[TS_TALLY_LONGEST] = (i64)n;
		t->to.pairs = how.queue;
		for (u64 i = 0; i < n; i++) ts_k_view_map_item(&t->to, i);
		n = children;
	}
}

/* Some level of views has a node for every second thread. */
static bool has_views_for(const traversal *t, u32 threads)
{
	u64 n_roots = t->n_starts / t->how.n_nodes;
	u64 n = n_roots == 1 && views.nodes[0].children != 0 ? views.n_leaves : n_roots;
	return threads == 1 || 2 * n >= threads;
}

static void assert_same(const traversal *plain, const traversal *fast, u32 threads, u32 start)
{
	const ts_pyramid *p = &plain->to.pyramid;
	const char *differ = NULL;
	if (memcmp(maps[0], maps[1], plain->n_texels * sizeof *maps[0]) != 0) differ = "maps";
	if (memcmp(plain->tallies, fast->tallies, sizeof plain->tallies) != 0) differ = "tallies";
	if (differ == NULL) return;
	fail_msg("random %u: %s differ: %u levels, %llu pairs at the start, maps of %u, %u levels, point %u, fill %g, %u "
	         "threads",
	         start, differ, scene.levels, (unsigned long long)plain->n_starts, p->n, p->levels, p->point,
	         (double)p->fill, threads);
}

/* Returns whether it was done at once. */
static bool compare(const traversal *plain, u32 threads, unsigned lanes, u32 start)
{
	traversal fast = *plain;
	begin_maps(&fast, 1);
	ts_most_lanes = lanes;
	bool done = ts_c_at_once_view_map(&fast.how, &fast.to, fast.n_starts, threads);
	ts_most_lanes = 16;
	assert_int_equal(done, has_views_for(plain, threads));
	if (done) assert_same(plain, &fast, threads, start);
	return done;
}

static void maps_at_once_equal_those_of_queues(void **state)
{
	(void)state;
	i64 sums[TS_TALLIES_AT_ONCE] = {0};
	u32 n_done = 0, n_owned = 0;
	n_random = 0;
	for (u32 i = 0; i < whole_or(1500, 300); i++) {
		u32 start = n_random;
		traversal t = random_traversal();
		begin_maps(&t, 0);
		by_queues(&t);
		for (unsigned lanes = 4; lanes <= 16; lanes *= 2) {
			n_done += compare(&t, 1, lanes, start);
			n_done += compare(&t, 3, lanes, start);
		}
		for (u32 k = 0; k < TS_TALLIES_AT_ONCE; k++) sums[k] += t.tallies[k];
		n_owned += t.to.own.reflectors != NULL ? 1 : 0;
	}
	for (u32 k = 0; k < TS_TALLIES_AT_ONCE; k++) assert_true(sums[k] > 1000);
	assert_true(n_done > 600 && n_owned > 20);
}

/* What the traversal for maps never asks; maps that are no power of two; fewer views than threads. */
static void what_maps_do_not_ask_is_refused(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < 100; i++) {
		traversal t = random_traversal();
		u32 how = below(6), threads = 1;
		begin_maps(&t, 1);
		if (how == 0) t.how.cutoff = 1;
		if (how == 1) t.how.to_last = 1;
		if (how == 2) t.how.last = scene.levels;
		if (how == 3) t.how.n = t.to.pyramid.n = 3;
		if (how == 4) t.how.n *= 2;
		if (how == 5) threads = 2 * views.n + 1;
		assert_false(ts_c_at_once_view_map(&t.how, &t.to, t.n_starts, threads));
		for (u64 k = 0; k < t.n_texels; k++) assert_true(maps[1][k] == TS_EMPTY);
		for (u32 k = 0; k < TS_TALLIES_AT_ONCE; k++) assert_int_equal(t.tallies[k], 0);
	}
}

/* Octrees of which no traversal has so many steps, and none at all. */
static void octrees_of_too_many_steps_are_refused(void **state)
{
	(void)state;
	enum { DEEP = 13 };
	static ts_node chain[DEEP];
	static const ts_cone all[DEEP];
	for (u32 i = 0; i < DEEP; i++) {
		u32 child = i + 1 < DEEP ? i + 1 : TS_NONE;
		chain[i] = (ts_node){.radius = ldexpf(1, -(i32)i), .child = child, .children = child != TS_NONE, .level = i};
		chain[i].parent = i > 0 ? i - 1 : TS_NONE;
	}
	traversal t = {.n_starts = 1, .n_texels = 32};
	t.to = (ts_view_map_args){.nodes = chain, .views = chain, .pyramid = {.n = 4, .levels = 1, .point = 1}};
	t.how = (ts_traverse_args){.nodes = chain, .views = chain, .cones = all, .n = 4, .n_nodes = 1, .last = TS_NONE};
	begin_maps(&t, 1);
	assert_false(ts_c_at_once_view_map(&t.how, &t.to, 1, 1));
	assert_true(ts_c_at_once_view_map(&t.how, &t.to, 0, 1));
	assert_int_equal(t.tallies[TS_TALLY_ALL], 0);
	chain[DEEP - 2].children = 0;
	assert_true(ts_c_at_once_view_map(&t.how, &t.to, 1, 1));
	assert_int_equal(t.tallies[TS_TALLY_ALL], TS_STEPS);
	assert_int_equal(t.tallies[TS_TALLY_LONGEST], 1);
}

static int begin(void **state)
{
	(void)state;
	for (u32 way = 0; way < 2; way++) {
		maps[way] = malloc(MOST_TEXELS * sizeof *maps[way]);
		assert_non_null(maps[way]);
	}
	return 0;
}

static int end(void **state)
{
	(void)state;
	for (u32 way = 0; way < 2; way++) free(maps[way]);
	return 0;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(maps_at_once_equal_those_of_queues),
		cmocka_unit_test(what_maps_do_not_ask_is_refused),
		cmocka_unit_test(octrees_of_too_many_steps_are_refused),
	};
	return cmocka_run_group_tests(tests, begin, end);
}
