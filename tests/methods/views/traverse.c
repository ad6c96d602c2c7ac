/* The traversal of two octrees: the pairs that a recursion renders, whatever the queues' memory; maps of those
 * pairs, and whole maps. */
#include "backends/kernels.h"
#include "methods/views/traverse.h"
#include "methods/views/views.h"
#include "tests/methods/views/grove.h"

static ts_params params_of(u32 n)
{
	ts_params params = small_params(64, 64);
	params.reflectors_count = 0;
	params.view_map_px = n;
	params.view_map_texel = TS_TEXEL_POINT;
	params.view_map_multipixel = TS_MULTIPIXEL_OFF;
	return params;
}

static ts_scene *scene;

static int open_scene(void **state)
{
	(void)state;
	ts_params params = params_of(16);
	scene = small_scene(&params);
	return 0;
}

static int close_scene(void **state)
{
	(void)state;
	ts_scene_free(scene);
	return 0;
}

#define grown_test(f) cmocka_unit_test_setup(f, grove_restart)

/* The recursion of METHODS 13, by the tested parts of pair.h. */
typedef struct {
	const grove *g;
	const ts_params *params;
	u64 *rendered, n, room;
	i64 pairs, culled, near, wide, served;
} recursion;

static void add(recursion *r, u32 s, u32 v)
{
	if (r->n == r->room) {
		r->room = 2 * r->room + 1024;
		r->rendered = realloc(r->rendered, r->room * sizeof *r->rendered);
		assert_non_null(r->rendered);
	}
	r->rendered[r->n++] = (u64)s << 32 | v;
	r->served += r->g->cones[v].views;
}

static void visit(recursion *r, u32 s, u32 v)
{
	const ts_node *node = &r->g->scene.nodes[s], *view = &r->g->views.nodes[v];
	ts_ball a = ts_k_node_ball(node), b = ts_k_node_ball(view);
	ts_cone_k cone = ts_k_load_cone(&r->g->cones[v]);
	bool all = r->params->view_map_field == TS_VIEW_FIELD_ALL;
	ts_aperture phi = {.cosine = all ? -1 : 0, .sine = all ? 0 : 1};
	r->pairs++;
	if (ts_k_pair_is_culled(&a, &b, &cone, &phi)) {
		r->culled++;
	} else if (ts_k_pair_is_equivalent(&a, &b, r->params->view_map_px)) {
		add(r, s, v);
	} else if (a.leaf && b.leaf) {
		bool near = ts_k_pair_is_near(&a, &b, r->params->view_map_apart);
		r->near += near;
		r->wide += !near;
		if (!near) add(r, s, v);
	} else if (ts_k_pair_splits_view(&a, &b)) {
		for (u32 k = 0, child = view->child; k < 8; k++) {
			if ((view->children >> k & 1) != 0) visit(r, s, child++);
		}
	} else {
		for (u32 k = 0, child = node->child; k < 8; k++) {
			if ((node->children >> k & 1) != 0) visit(r, child++, v);
		}
	}
}

static u64 *sorted(const u64 *keys, u64 n)
{
	u64 *copy = malloc((n + 1) * sizeof *copy);
	assert_non_null(copy);
	memcpy(copy, keys, n * sizeof *copy);
	qsort(copy, n, sizeof *copy, grove_order);
	return copy;
}

static void assert_same_pairs(const ts_run *run, const recursion *r)
{
	u64 n = ts_frame_n(&run->frame, TS_B_traverse_rendered);
	u64 *a = sorted(ts_frame_data(&run->frame, TS_B_traverse_rendered), n), *b = sorted(r->rendered, r->n);
	assert_int_equal(n, r->n);
	assert_memory_equal(a, b, n * sizeof *a);
	for (u64 i = 1; i < n; i++) assert_true(a[i] != a[i - 1]);
	free(a);
	free(b);
}

static void assert_same_counters(const ts_run *run, const recursion *r)
{
	i64 split = r->pairs - r->culled - r->near - (i64)r->n;
	assert_true(r->pairs > 100 && split > 0);
	assert_int_equal(ts_run_counter(run, "pairs"), r->pairs);
	assert_int_equal(ts_run_counter(run, "pairs culled"), r->culled);
	assert_int_equal(ts_run_counter(run, "pairs too near"), r->near);
	assert_int_equal(ts_run_counter(run, "pairs rendered"), (i64)r->n);
	assert_int_equal(ts_run_counter(run, "pairs wider than a texel"), r->wide);
	assert_int_equal(ts_run_counter(run, "views served"), r->served);
}

static void pairs_are_those_of_a_recursion(void **state)
{
	(void)state;
	i64 culled = 0, near = 0, wide = 0, narrow = 0;
	for (u32 i = 0; i < 40; i++) {
		ts_params params = params_of(4u << grove_below(5));
		params.view_map_field = grove_below(4) == 0;
		params.view_map_apart = (f32)grove_below(4);
		grove g;
		u32 levels = 1 + grove_below(5), view_levels = 1 + grove_below(5), n = 1 + grove_below(600);
		grove_plant(&g, levels, view_levels, n, grove_noise, 1 + grove_below(100), grove_noise);
		recursion r = {.g = &g, .params = &params};
		bool alone = i % 4 == 3; /* the views' octree: each leaf of the scene by itself */
		u32 first_leaf = g.scene.before[levels], end = alone ? g.scene.before[levels + 1] : 1;
		if (alone) params.traverse_hierarchies = TS_HIERARCHIES_VIEWS;
		params.octree_levels = levels;
		for (u32 s = alone ? first_leaf : 0; s < end; s++) visit(&r, s, 0);
		ts_run run;
		grove_begin(&run, scene, &params, 1 + grove_below(4), &g);
		ts_frame_borrow(&run.frame, TS_B_octree_level, g.scene.before, levels + 2);
		grove_stage(&run, "traverse");
		assert_same_pairs(&run, &r);
		if (r.pairs > 100) assert_same_counters(&run, &r);
		culled += r.culled;
		near += r.near;
		wide += r.wide;
		narrow += (i64)r.n - r.wide;
		ts_run_end(&run);
		grove_free(&g);
		free(r.rendered);
	}
	assert_true(culled > 1000 && near > 1000 && wide > 1000 && narrow > 1000);
}

/* More leaves that begin than queues have room for. */
static void more_starts_than_room_end_well(void **state)
{
	(void)state;
	enum { LEVELS = 6 };
	ts_params params = params_of(16);
	TS_PARAM_SET(&params, traverse_hierarchies, TS_HIERARCHIES_VIEWS);
	TS_PARAM_SET(&params, traverse_queue_mb, 1);
	TS_PARAM_SET(&params, octree_levels, LEVELS);
	grove g;
	ts_run run;
	grove_plant(&g, LEVELS, 1, 60000, grove_noise, 3, grove_noise);
	recursion r = {.g = &g, .params = &params};
	u32 first = g.scene.before[LEVELS], end = g.scene.before[LEVELS + 1];
	assert_true(end - first > ts_traverse_room(&params) + 100);
	for (u32 s = first; s < end; s++) visit(&r, s, 0);
	grove_begin(&run, scene, &params, 2, &g);
	ts_frame_borrow(&run.frame, TS_B_octree_level, g.scene.before, LEVELS + 2);
	grove_stage(&run, "traverse");
	assert_same_pairs(&run, &r);
	ts_run_end(&run);
	grove_free(&g);
	free(r.rendered);
}

/* The order of the kept pairs, too, is the same whatever the memory; and so are maps without keeping them. */
static void memory_changes_no_pair_and_no_map(void **state)
{
	(void)state;
	static const struct {
		u32 queue_mb, threads;
		bool traced;
	} ways[] = {
		{1, 1, true}, {1, 2, false}, {2, 3, true}, {1024, 3, true}, {1024, 2, false},
	};
	ts_params params = params_of(16);
	grove g;
	grove_plant(&g, 5, 5, 10000, grove_surface, 250, grove_surface);
	grove_outcome one = grove_run(&g, scene, &params, 1, NULL, true);
	assert_true(one.n_pairs > 50000);
	for (u32 i = 0; i < sizeof ways / sizeof *ways; i++) {
		params.traverse_queue_mb = ways[i].queue_mb;
		grove_outcome other = grove_run(&g, scene, &params, ways[i].threads, NULL, ways[i].traced);
		assert_true(ways[i].queue_mb > 1 || (u64)one.longest > 4 * ts_traverse_room(&params));
		assert_int_equal(other.longest, one.longest);
		grove_assert_same(&one, &other);
		grove_outcome_free(&other);
	}
	grove_outcome_free(&one);
	grove_free(&g);
}

/* The nearest node of each texel's pairs, the first of equals; nothing elsewhere. */
static void each_texel_holds_its_nearest_node(void **state)
{
	(void)state;
	ts_params params = params_of(8);
	grove g;
	grove_plant(&g, 5, 4, 20000, grove_surface, 300, grove_surface);
	grove_outcome r = grove_run(&g, scene, &params, 2, NULL, true);
	u64 *expected = malloc(r.n_maps * sizeof *expected);
	assert_non_null(expected);
	memset(expected, 0xff, r.n_maps * sizeof *expected);
	assert_int_equal(r.n_maps, (u64)g.views.before[5] * 128);
	for (u64 i = 0; i < r.n_pairs; i++) {
		u32 s = (u32)(r.pairs[i] >> 32), v = (u32)r.pairs[i];
		ts_v3 way = ts_sub(ts_load3(g.scene.nodes[s].centre), ts_load3(g.views.nodes[v].centre));
		u64 *texel = &expected[v * 128 + ts_k_paraboloid_texel(way, 8)], key = (u64)ts_f2u(ts_length(way)) << 32 | s;
		*texel = key < *texel ? key : *texel;
	}
	assert_memory_equal(r.maps, expected, r.n_maps * sizeof *expected);
	free(expected);
	grove_outcome_free(&r);
	grove_free(&g);
}

/* A walk from the root finds what the fused maps hold; of the two fusions, one takes the nearest, the other its own. */
static void walks_from_the_root_find_fused_depth(void **state)
{
	(void)state;
	ts_params params = params_of(8), paper = params;
	paper.view_map_fusion = TS_FUSION_PAPER;
	grove g;
	grove_plant(&g, 5, 6, 20000, grove_surface, 300, grove_surface);
	grove_outcome least = grove_run(&g, scene, &params, 2, NULL, false),
				  own = grove_run(&g, scene, &paper, 2, NULL, false);
	ts_view_map_fuse_args args = {
		.views = g.views.nodes, .texels = least.maps, .pyramid = {8, 1, .point = 1}, .nearest = 1};
	ts_view_map_fuse_args own_args = args;
	own_args.nearest = 0;
	u64 n_moved = 0, n_nearer = 0;
	for (u64 i = 0; i < least.n_depths; i++) {
		u32 map = (u32)(least.maps[i] >> 32);
		assert_true(ts_k_fuse_query(&args, (u32)(i / 128), (u32)(i % 128)) == grove_fused(&least, i));
		assert_true(ts_k_fuse_query(&own_args, (u32)(i / 128), (u32)(i % 128)) == grove_fused(&own, i));
		assert_true(least.depths[i] <= map && least.depths[i] <= own.depths[i]);
		assert_true(map == TS_NONE || own.depths[i] == map);
		assert_true(i >= 128 || least.depths[i] == map);
		n_moved += map == TS_NONE && least.depths[i] != TS_NONE;
		n_nearer += least.depths[i] < own.depths[i];
	}
	assert_true(n_moved > least.n_depths / 10 && n_nearer > 100);
	grove_outcome_free(&least);
	grove_outcome_free(&own);
	grove_free(&g);
}

/* Moved depth is the distance of the same point from the other place. */
static void moved_depth_is_of_the_same_point(void **state)
{
	(void)state;
	for (u32 i = 0; i < 20000; i++) {
		u32 n = 4u << grove_below(7), texel = grove_below(2 * n * n);
		ts_v3 a = grove_noise().p, b = grove_noise().p, d = ts_k_paraboloid_direction(texel, n);
		double t = 3 * grove_uniform(), x = a.x + t * d.x - b.x, y = a.y + t * d.y - b.y, z = a.z + t * d.z - b.z;
		double expected = sqrt(x * x + y * y + z * z);
		assert_true(fabs((double)ts_k_moved_depth(a, (f32)t, b, texel, n) - expected) < 1e-6);
		assert_true(fabs((double)ts_k_moved_depth(a, (f32)t, a, texel, n) - t) < 1e-6);
	}
}

/* Filled one by one or by a pyramid, wide leaves leave no holes about them, and the maps of both ways are the same. */
static void wide_leaves_fill_all_their_texels(void **state)
{
	(void)state;
	ts_params params = params_of(64), texels = params, mips = params, small = params_of(16);
	texels.view_map_multipixel = TS_MULTIPIXEL_TEXELS;
	mips.view_map_multipixel = small.view_map_multipixel = TS_MULTIPIXEL_AUTO;
	assert_true(ts_view_pyramid(&small, &(ts_plan){.views.px = 16}).fill == 0);
	grove g;
	grove_plant(&g, 5, 5, 60000, grove_surface, 60, grove_floor);
	grove_outcome off = grove_run(&g, scene, &params, 2, NULL, false),
				  on = grove_run(&g, scene, &texels, 2, NULL, false), by = grove_run(&g, scene, &mips, 2, NULL, false);
	assert_int_equal(on.n_depths, off.n_depths);
	assert_int_equal(by.n_depths, off.n_depths);
	assert_int_equal(by.n_maps * 4096, off.n_maps * 5461);
	u64 n_off = 0, n_on = 0, n_farther = 0, n_differ = 0;
	for (u64 i = 0; i < on.n_depths; i++) {
		n_off += off.depths[i] != TS_NONE;
		n_on += on.depths[i] != TS_NONE;
		n_farther += on.depths[i] > off.depths[i];
		n_differ += grove_fused(&on, i) != grove_fused(&by, i);
	}
	assert_int_equal(n_farther, 0);
	assert_int_equal(n_differ, 0);
	assert_true(n_on > n_off + n_off / 20);
	grove_outcome_free(&off);
	grove_outcome_free(&on);
	grove_outcome_free(&by);
	grove_free(&g);
}

/* Where every leaf is wider than a texel, views alone show just what brute force does. */
static void views_alone_show_what_brute_force_does(void **state)
{
	(void)state;
	ts_params params = params_of(256);
	ts_vpl lights[40];
	grove g;
	ts_run run;
	grove_plant(&g, 3, 3, 3000, grove_noise, 40, grove_noise);
	grove_begin_alone(&run, scene, &params, &g, lights, 40);
	grove_stage(&run, "view_map");
	u64 n, n_all;
	i64 rendered = ts_run_counter(&run, "pairs rendered");
	u64 *maps = grove_copy(&run, TS_B_view_map_depth_node, &n);
	assert_int_equal(ts_run_counter(&run, "pairs wider than a texel"), rendered);
	assert_int_equal(ts_run_counter(&run, "views served"), rendered);
	grove_stage(&run, "view_map.all");
	u64 *all = grove_copy(&run, TS_B_view_map_depth_node, &n_all);
	assert_int_equal(n, n_all);
	assert_memory_equal(maps, all, n * sizeof *maps);
	assert_int_equal(ts_run_counter(&run, "pairs rendered"), 2 * rendered);
	grove_stage(&run, "view_map.fuse");
	const u32 *depths = ts_frame_data(&run.frame, TS_B_view_map_fused_depth);
	const u32 *shown = ts_frame_data(&run.frame, TS_B_view_map_fused_node);
	u64 n_wrong = 0;
	for (u64 i = 0; i < n; i++) n_wrong += depths[i] != maps[i] >> 32 || shown[i] != (u32)maps[i];
	assert_int_equal(n_wrong, 0);
	free(maps);
	free(all);
	ts_run_end(&run);
	grove_free(&g);
}

static void wrong_maps_and_circles_are_refused(void **state)
{
	(void)state;
	ts_params params = params_of(24);
	grove g;
	ts_run run;
	grove_plant(&g, 2, 2, 10, grove_noise, 10, grove_noise);
	grove_begin(&run, scene, &params, 1, &g);
	assert_int_equal(ts_run_stage(&run, ts_stage_find("traverse")), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "maps of 24 texels: a power of two"));
	run.plan.views.px = 16;
	g.scene.nodes[g.scene.before[2]].child = 0; /* a circle */
	g.scene.nodes[g.scene.before[2]].children = 1;
	assert_int_equal(ts_run_stage(&run, ts_stage_find("traverse")), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "more than 23 steps"));
	ts_run_end(&run);
	grove_free(&g);
}

/* The octrees of the scene and its virtual point lights, as the stages before make them. */
static void stages_traverse_the_octrees_of_a_scene(void **state)
{
	(void)state;
	static const char *const stages[] = {
		"eye.view", "pose",         "lamp", "rsm.view",          "rsm",         "rsm.patch",        "octree.root",
		"voxel",    "octree",       "vpl",  "view_octree.voxel", "view_octree", "view_octree.cone", "traverse",
		"view_map", "view_map.fuse"};
	ts_params params = params_of(16);
	params.octree_levels = 5;
	ts_run run;
	ts_run_begin(&run, scene, &params, 2);
	ts_pipeline_plan(ts_pipeline_find("indirect", "megaviews"), &run, NULL, NULL);
	for (u32 i = 0; i < sizeof stages / sizeof *stages; i++) grove_stage(&run, stages[i]);
	for (u32 i = 13; i < 16; i++) small_assert_claims(&run, ts_stage_find(stages[i]));
	grove g = {.scene.nodes = ts_frame_data(&run.frame, TS_B_octree_node),
	           .views.nodes = ts_frame_data(&run.frame, TS_B_view_octree_node),
	           .cones = ts_frame_data(&run.frame, TS_B_view_octree_cone)};
	recursion r = {.g = &g, .params = &params};
	visit(&r, 0, 0);
	assert_same_pairs(&run, &r);
	assert_same_counters(&run, &r);
	free(r.rendered);
	ts_run_end(&run);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		grown_test(pairs_are_those_of_a_recursion),       grown_test(more_starts_than_room_end_well),
		grown_test(memory_changes_no_pair_and_no_map),    grown_test(each_texel_holds_its_nearest_node),
		grown_test(walks_from_the_root_find_fused_depth), grown_test(moved_depth_is_of_the_same_point),
		grown_test(wide_leaves_fill_all_their_texels),    grown_test(views_alone_show_what_brute_force_does),
		grown_test(wrong_maps_and_circles_are_refused),   grown_test(stages_traverse_the_octrees_of_a_scene),
	};
	return cmocka_run_group_tests(tests, open_scene, close_scene);
}
