/* The octree of views and their cones, against looking at every view in every node; of single views sums of directions
 * along an axis are exact, and no cosine is above 1; views alone are nodes of their own. */
#include "kernels/base/sort.h"
#include "kernels/views/view_octree.h"
#include "kernels/views/view_octree_alone.h"
#include "kernels/views/view_octree_cone.h"
#include "tests/kernels/views/tree.h"

enum { N_WORLDS = 300, VIEWS = 500, N_VIEWS = 20000 };

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
	tree_finish(t);
	args.first_leaf = t->level[t->levels];
	memset(v->offset, 0, sizeof v->offset);
	for (u64 i = v->n; i-- > 0;) ts_k_view_octree_leaf_item(&args, i);
	prefix_sums(v->offset, t->n_leaves + 1);
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

static void cones_hold_all_views_of_their_nodes(void **state)
{
	(void)state;
	static tree t;
	static views v;
	u32 n_opposite = 0;
	for (u32 world = 0; world < N_WORLDS; world++) {
		tree_begin(&t, 1 + world % MOST);
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

/* The cone of a leaf with that view alone. */
static ts_cone cone_of(ts_v3 direction, u64 sum[3])
{
	ts_vpl view = {.bounce = 1};
	ts_cone cone;
	ts_node node = {.parent = TS_NONE};
	u32 offset[2] = {0, 1}, entry = 0, leaf = 0, least = TS_NONE;
	ts_cone_args args = {&view, &node, offset, &entry, &leaf, sum, &least, &cone, 0};
	ts_store3(view.normal, direction);
	ts_k_cone_leaf_item(&args, 0);
	ts_k_cone_least_item(&args, 0);
	ts_k_cone_item(&args, 0);
	return cone;
}

static void directions_along_an_axis_sum_exactly(void **state)
{
	(void)state;
	for (u32 i = 0; i < 6; i++) {
		u64 sum[3];
		f32 d[3] = {0, 0, 0};
		d[i / 2] = i % 2 == 0 ? 1 : -1;
		ts_cone cone = cone_of(ts_load3(d), sum);
		for (u32 k = 0; k < 3; k++) {
			assert_true((i64)sum[k] == (i64)d[k] * (1 << 30));
			assert_true(cone.axis[k] == d[k]);
		}
		assert_true(cone.cosine == 1);
	}
}

/* Some products of a direction with itself are rounded to more than 1. */
static void no_cosine_is_above_one(void **state)
{
	(void)state;
	u32 n_above = 0;
	for (u32 i = 0; i < N_VIEWS; i++) {
		u64 sum[3];
		ts_v3 d = direction();
		ts_cone cone = cone_of(d, sum);
		n_above += ts_dot(d, ts_load3(cone.axis)) > 1;
		assert_true(cone.cosine <= 1 && cone.cosine > 1 - 4e-7f);
	}
	assert_true(n_above > N_VIEWS / 100);
}

/* Each where its view is, without extent, a root and a leaf, and seen by its own direction only. */
static void views_alone_are_nodes_of_their_own(void **state)
{
	(void)state;
	enum { N = 100 };
	static ts_vpl lights[N];
	ts_node nodes[N];
	ts_cone cones[N];
	u32 entries[N], leaves[N];
	ts_view_octree_alone_args args = {lights, nodes, cones, entries, leaves};
	for (u32 i = 0; i < N; i++) {
		ts_store3(lights[i].position, uniform3(-50, 50));
		ts_store3(lights[i].normal, direction());
	}
	for (u64 i = N; i-- > 0;) ts_k_view_octree_alone_item(&args, i);
	for (u32 i = 0; i < N; i++) {
		assert_memory_equal(nodes[i].centre, lights[i].position, sizeof nodes[i].centre);
		assert_memory_equal(cones[i].axis, lights[i].normal, sizeof cones[i].axis);
		assert_true(nodes[i].radius == 0 && nodes[i].children == 0 && nodes[i].level == 0);
		assert_true(nodes[i].child == TS_NONE && nodes[i].parent == TS_NONE);
		assert_true(cones[i].cosine == 1 && cones[i].first == i && cones[i].views == 1);
		assert_true(entries[i] == i && leaves[i] == i);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(cones_hold_all_views_of_their_nodes),
		seeded_test(directions_along_an_axis_sum_exactly),
		seeded_test(no_cosine_is_above_one),
		seeded_test(views_alone_are_nodes_of_their_own),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
