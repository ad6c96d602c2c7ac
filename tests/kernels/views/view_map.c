/* Pairs in dual-paraboloid maps against brute force in double precision (METHODS 13): all nodes of a small lattice from
 * views on it, so that distances are exact, some are equal, and no place is so near the edge of a texel that rounding
 * decides; nodes that fill all texels that they cover, by either rule; and what a map shows, moved from parents to
 * children. */
#include <string.h>
#include "kernels/views/view_map_fuse.h"
#include "kernels/views/view_octree_alone.h"
#include "tests/kernels/seeded.h"

enum { REACH = 9, SIDE = 2 * REACH + 1, N_NODES = SIDE * SIDE * SIDE, N_VIEWS = 3, N_PAIRS = N_NODES * N_VIEWS };
enum { MOST = 16, TEXELS = 2 * MOST * MOST, PYRAMID = TEXELS * 3 / 2 };

typedef struct {
	ts_node nodes[N_NODES], views[N_VIEWS];
	ts_cone cones[N_VIEWS];
	u64 texels[N_VIEWS * PYRAMID], pairs[N_PAIRS], expected[N_VIEWS * PYRAMID];
	ts_view_map_args args;
} world;

static ts_v3 place(u32 i)
{
	ts_v3 at = ts_v3_make((f32)(i % SIDE), (f32)(i / SIDE % SIDE), (f32)(i / (SIDE * SIDE)));
	return ts_scale(ts_sub(at, ts_v3_make(REACH, REACH, REACH)), 0.125f);
}

/* Nodes in an order that has nothing to do with their distance; a view in the middle, at a corner, and at the side. */
static void begin(world *w, u32 n, u32 levels)
{
	static const u32 seen_from[N_VIEWS] = {N_NODES / 2, 0, 3000};
	memset(w, 0, sizeof *w);
	for (u32 i = 0; i < N_NODES; i++) ts_store3(w->nodes[i].centre, place((i * 2741 + 77) % N_NODES));
	for (u32 v = 0; v < N_VIEWS; v++) ts_store3(w->views[v].centre, place(seen_from[v]));
	for (u32 i = 0; i < N_PAIRS; i++) w->pairs[i] = ts_k_pair(i / N_VIEWS, i % N_VIEWS);
	w->args = (ts_view_map_args){.nodes = w->nodes,
	                             .views = w->views,
	                             .pairs = w->pairs,
	                             .texels = w->texels,
	                             .pyramid = {n, levels, .point = 1}};
	memset(w->texels, 0xff, sizeof w->texels);
	memset(w->expected, 0xff, sizeof w->expected);
}

static double3 centre(const ts_node *node) { return d3_of(ts_load3(node->centre)); }

static double3 way(const world *w, u64 pair)
{
	return d3_sub(centre(&w->nodes[pair >> 32]), centre(&w->views[(u32)pair]));
}

/* Where a direction is in a map of n texels a side. */
typedef struct {
	u32 half, row, column;
} spot;

static u32 across(double u, u32 n) { return u < 1 ? (u32)((u / 2 + 0.5) * n) : n - 1; }

static spot spot_of(double3 d, u32 n)
{
	double sum = d3_length(d) + fabs(d.x);
	if (sum == 0) return (spot){0, n / 2, n / 2};
	return (spot){d.x < 0, across(d.z / sum, n), across(d.y / sum, n)};
}

static u32 texel_of(double3 d, u32 n)
{
	spot at = spot_of(d, n);
	return (at.half * n + at.row) * n + at.column;
}

static u64 key_of(double3 d, u64 pair) { return (u64)ts_f2u((f32)d3_length(d)) << 32 | pair >> 32; }

/* Each pair alone: its key is in one texel of its view's map, and nothing is anywhere else. */
static void each_pair_writes_one_texel(void **state)
{
	(void)state;
	static world w;
	for (u32 n = 2; n <= MOST; n *= 2) {
		begin(&w, n, 1);
		for (u32 i = 0; i < N_PAIRS; i++) {
			double3 d = way(&w, w.pairs[i]);
			u64 *texel = &w.texels[(u32)w.pairs[i] * 2 * n * n + texel_of(d, n)];
			ts_k_view_map_item(&w.args, i);
			assert_true(*texel == key_of(d, w.pairs[i]));
			*texel = TS_EMPTY;
			if (i % 7 == 0) assert_memory_equal(w.texels, w.expected, sizeof w.texels);
		}
		assert_memory_equal(w.texels, w.expected, sizeof w.texels);
	}
}

/* The nearest of all pairs, whose nodes are in order: of equally near ones the first. Returns how many were as near as
 * what was there. */
static u32 expect(world *w, u32 n)
{
	u32 n_ties = 0;
	for (u32 i = 0; i < N_PAIRS; i++) {
		u64 pair = w->pairs[i];
		if (pair >= TS_STRUCK) continue;
		double3 d = way(w, pair);
		u64 *there = &w->expected[(u32)pair * 2 * n * n + texel_of(d, n)];
		u64 other = *there << 32 | (u32)pair;
		double nearer = *there != TS_EMPTY ? d3_dot(way(w, other), way(w, other)) - d3_dot(d, d) : 1;
		if (nearer > 0) *there = key_of(d, pair);
		n_ties += nearer == 0;
	}
	return n_ties;
}

/* The square of the least |u| in a texel: if it is more than 1, no direction leads there. */
static double nearest_corner(u32 texel, u32 n)
{
	double u = fmax(0, fabs(2 * (texel % n + 0.5) / n - 1) - 1.0 / n);
	double v = fmax(0, fabs(2 * (texel / n % n + 0.5) / n - 1) - 1.0 / n);
	return u * u + v * v;
}

/* Of pairs in any order, some of them struck out, and all that are near, so that more are equally far. */
static void the_nearest_pair_of_each_texel_wins(void **state)
{
	(void)state;
	static world w;
	u32 n_ties = 0;
	for (u32 n = 2; n <= MOST; n *= 2) {
		begin(&w, n, 1);
		for (u32 i = 0; i < N_PAIRS; i++) {
			bool is_near = d3_length(way(&w, w.pairs[i])) < 1;
			if (is_near || below(8) == 0) w.pairs[i] = TS_STRUCK + below(3);
		}
		n_ties += expect(&w, n);
		for (u32 i = 0; i < N_PAIRS; i++) ts_k_view_map_item(&w.args, (u64)i * 8009 % N_PAIRS);
		assert_memory_equal(w.texels, w.expected, sizeof w.texels);
		for (u32 t = 0; t < N_VIEWS * 2 * n * n; t++) {
			if (nearest_corner(t % (2 * n * n), n) > 1) assert_true(w.texels[t] == TS_EMPTY);
		}
	}
	assert_true(n_ties > 200);
}

/* Every leaf for every view, none of which is culled or too near: the same as all pairs. */
static void all_pairs_give_the_same_maps(void **state)
{
	(void)state;
	enum { N = 8 };
	static world w;
	i64 n_rendered = 0;
	begin(&w, N, 1);
	for (u32 v = 0; v < N_VIEWS; v++) w.cones[v] = (ts_cone){.axis = {0, 0, 1}, .cosine = 1, .views = 1};
	const ts_view_map_all_args args = {
		.of = {.nodes = w.nodes, .views = w.views, .cones = w.cones, .phi = {-1, 0}, .n = N},
		.to = w.args,
		.n_rendered = &n_rendered,
		.n_leaves = N_NODES};
	expect(&w, N);
	for (u64 i = 0; i < N_PAIRS; i++) ts_k_view_map_all_item(&args, i);
	assert_int_equal(n_rendered, N_PAIRS);
	assert_memory_equal(w.texels, w.expected, sizeof w.texels);
}

/* Level l of a pyramid is behind those before it, two maps of n >> l texels a side, each a square of finer ones. */
static u32 above(spot at, u32 n, u32 level)
{
	u32 first = 0;
	for (u32 l = 0; l < level; l++) first += 2 * (n >> l) * (n >> l);
	return first + (at.half * (n >> level) + (at.row >> level)) * (n >> level) + (at.column >> level);
}

static void each_texel_is_above_its_finer_ones(void **state)
{
	(void)state;
	for (u32 n = 1, levels = 1; n <= MOST; n *= 2, levels++) {
		const ts_pyramid pyramid = {n, levels, .point = 1};
		assert_int_equal(ts_k_pyramid_texels(&pyramid), above((spot){0, 0, 0}, n, levels));
		for (u32 t = 0; t < 2 * n * n; t++) {
			const spot at = {t / (n * n), t / n % n, t % n};
			for (u32 l = 0; l < levels; l++) assert_int_equal(ts_k_pyramid_above(&pyramid, t, l), above(at, n, l));
		}
	}
}

/* Whether the middle of a texel is a direction that meets the filled ball of a pair's node. By points only balls wider
 * than a texel are filled, and the texel of the node's own middle is covered, too. Where rounding decides, `unsure`. */
static bool is_covered(const world *w, u64 pair, u32 texel, u32 n, bool *unsure)
{
	double u = (2.0 * (texel % n) + 1) / n - 1, v = (2.0 * (texel / n % n) + 1) / n - 1, s = u * u + v * v;
	double3 middle = {texel < n * n ? 1 - s : s - 1, 2 * u, 2 * v}, d = way(w, pair);
	double r = (double)w->args.pyramid.fill * (double)w->nodes[pair >> 32].radius, far = d3_length(d);
	double edge = sqrt(fmax(0, (far - r) * (far + r))), wide = far > r ? n * r / (fabs(d.x) + edge) : n;
	double inside = far > r ? d3_dot(middle, d) / (1 + s) - edge : 1;
	bool point = w->args.pyramid.point != 0, own = point && texel_of(d, n) == texel;
	*unsure = (fabs(inside) < 2e-5 * far || (point && fabs(wide - 1) < 1e-5)) && !own;
	return ((wide > 1 || !point) && inside > 0) || own;
}

/* Leaves from far ones, narrower than a texel, to such that a view is in. */
static void begin_leaves(world *w, u32 levels, bool point)
{
	begin(w, MOST, levels);
	w->args.pyramid.point = point;
	w->args.pyramid.fill = 0.75f;
	for (u32 i = 0; i < N_NODES; i++) w->nodes[i].radius = uniform(0.001f, i % 8 == 0 ? 1.0f : 0.3f);
}

static const u32 all_levels = 5; /* of maps of MOST */

/* Each pair alone: the texels that show it are those that it covers, none more, one by one or by a pyramid. */
static void check_fill(bool point)
{
	static world w, splat;
	u32 n_none = 0, n_wide = 0, n_unsure = 0, n_coarse = 0;
	begin_leaves(&w, 1, point);
	splat = w;
	splat.args = w.args;
	splat.args.nodes = splat.nodes, splat.args.views = splat.views, splat.args.pairs = splat.pairs;
	splat.args.texels = splat.texels, splat.args.pyramid.levels = all_levels;
	for (u32 i = 0; i < N_PAIRS; i += 5) {
		u64 pair = w.pairs[i];
		u64 *map = &w.texels[(u32)pair * ts_k_pyramid_texels(&w.args.pyramid)];
		u64 *levels = &splat.texels[(u32)pair * ts_k_pyramid_texels(&splat.args.pyramid)];
		ts_k_view_map_item(&w.args, i);
		ts_k_view_map_item(&splat.args, i);
		u32 n = 0;
		for (u32 t = 0; t < TEXELS; t++) {
			bool unsure, covered = is_covered(&w, pair, t, MOST, &unsure);
			assert_true(ts_k_map_key(levels, &splat.args.pyramid, t) == map[t]);
			n_unsure += unsure;
			if (!unsure) assert_true(map[t] == (covered ? key_of(way(&w, pair), pair) : TS_EMPTY));
			n += map[t] != TS_EMPTY;
		}
		n_none += n == 0;
		n_wide += n > 1;
		for (u32 t = TEXELS; t < ts_k_pyramid_texels(&splat.args.pyramid); t++) n_coarse += levels[t] != TS_EMPTY;
		memset(map, 0xff, TEXELS * sizeof *map);
		memset(levels, 0xff, ts_k_pyramid_texels(&splat.args.pyramid) * sizeof *levels);
	}
	assert_memory_equal(w.texels, w.expected, sizeof w.texels);
	assert_memory_equal(splat.texels, w.expected, sizeof w.texels);
	assert_true(n_wide > 1000 && n_coarse > 1000 && n_unsure < 200);
	assert_true(point ? n_none == 0 : n_none > 300);
}

static void pairs_fill_just_what_they_cover(void **state)
{
	(void)state;
	check_fill(false);
	check_fill(true);
}

/* Of many leaves each texel shows the nearest that covers it, however they are filled. */
static void filled_texels_show_the_nearest_leaf(void **state)
{
	(void)state;
	static world w;
	for (u32 choice = 0; choice < 4; choice++) {
		begin_leaves(&w, choice % 2 == 0 ? 1 : all_levels, choice / 2 != 0);
		u32 n_shown = 0, n_few = 400;
		for (u32 i = 0; i < n_few; i++) w.pairs[i] = ts_k_pair(below(N_NODES), i % N_VIEWS);
		for (u32 i = 0; i < n_few; i++) ts_k_view_map_item(&w.args, i);
		for (u32 t = 0; t < N_VIEWS * TEXELS; t++) {
			u64 sure = TS_EMPTY, maybe = TS_EMPTY;
			for (u32 i = t / TEXELS; i < n_few; i += N_VIEWS) {
				bool unsure, covered = is_covered(&w, w.pairs[i], t % TEXELS, MOST, &unsure);
				u64 key = key_of(way(&w, w.pairs[i]), w.pairs[i]);
				if (covered && !unsure && key < sure) sure = key;
				if ((covered || unsure) && key < maybe) maybe = key;
			}
			const u64 *map = &w.texels[t / TEXELS * ts_k_pyramid_texels(&w.args.pyramid)];
			u64 found = ts_k_map_key(map, &w.args.pyramid, t % TEXELS);
			assert_true(found == sure || found == maybe);
			n_shown += sure != TS_EMPTY;
		}
		assert_true(n_shown > TEXELS);
	}
}

enum { N = 4, MAP = 2 * N * N, DEPTH = 5 };

/* A line of nodes of views, each the child of the one before, and their maps. */
typedef struct {
	ts_node views[DEPTH];
	u64 texels[DEPTH * MAP];
	u32 depths[DEPTH * MAP], shown[DEPTH * MAP];
	ts_view_map_fuse_args args;
} line;

static void begin_line(line *w, bool nearest)
{
	memset(w, 0, sizeof *w);
	for (u32 level = 0; level < DEPTH; level++) {
		w->views[level] = (ts_node){.level = level, .parent = level > 0 ? level - 1 : TS_NONE};
		ts_store3(w->views[level].centre, uniform3(-1, 1));
	}
	for (u32 i = 0; i < DEPTH * MAP; i++) {
		u64 distance = ts_f2u(uniform(0, 3));
		w->texels[i] = below(2) == 0 ? TS_EMPTY : distance << 32 | below(1000);
	}
	w->args = (ts_view_map_fuse_args){.views = w->views,
	                                  .texels = w->texels,
	                                  .depths = w->depths,
	                                  .nodes = w->shown,
	                                  .pyramid = {N, 1, .point = 1},
	                                  .nearest = nearest};
}

static void fuse(line *w)
{
	for (w->args.first = 0; w->args.first < DEPTH; w->args.first++) {
		for (u64 i = MAP; i-- > 0;) ts_k_view_map_fuse_item(&w->args, i);
	}
}

/* What a texel shows, at a distance; node TS_NONE: nothing. Where rounding decides which, `unsure`. */
typedef struct {
	double distance;
	u32 node;
	bool unsure;
} show;

/* The way of a texel's middle u: ((1 - u^2), 2 u) / (1 + u^2), to the front or the back. */
static double3 middle_of(u32 texel)
{
	double u = 2 * (texel % N + 0.5) / N - 1, v = 2 * (texel / N % N + 0.5) / N - 1, square = u * u + v * v;
	double x = texel < N * N ? 1 - square : square - 1;
	return d3_scale((double3){x, 2 * u, 2 * v}, 1 / (1 + square));
}

static show show_of(const line *w, u32 level, u32 texel)
{
	u64 key = w->texels[level * MAP + texel];
	show own = {key != TS_EMPTY ? (double)ts_u2f((u32)(key >> 32)) : 1e9, (u32)key, false};
	if (level == 0) return own;
	show moved = show_of(w, level - 1, texel);
	if (moved.node == TS_NONE || (own.node != TS_NONE && !w->args.nearest)) return own;
	double3 from = centre(&w->views[level - 1]), at = d3_mad(from, middle_of(texel), moved.distance);
	moved.distance = d3_distance(at, centre(&w->views[level]));
	bool unsure = moved.unsure || fabs(moved.distance - own.distance) < 1e-5;
	show r = moved.distance < own.distance ? moved : own;
	r.unsure = unsure;
	return r;
}

static void children_show_what_their_parents_show(void **state)
{
	(void)state;
	static line w;
	u32 n_sure = 0, n_of_parents = 0;
	for (u32 number = 0; number < 400; number++) {
		begin_line(&w, number % 2 != 0);
		fuse(&w);
		for (u32 i = 0; i < DEPTH * MAP; i++) {
			show expected = show_of(&w, i / MAP, i % MAP);
			u64 found = (u64)w.depths[i] << 32 | w.shown[i];
			assert_true(ts_k_fuse_query(&w.args, i / MAP, i % MAP) == found);
			if (expected.unsure) continue;
			assert_int_equal(w.shown[i], expected.node);
			if (expected.node == TS_NONE) assert_true(found == TS_EMPTY);
			if (expected.node != TS_NONE) assert_near(ts_u2f(w.depths[i]), expected.distance, 2e-6);
			n_of_parents += expected.node != TS_NONE && found != w.texels[i];
			n_sure++;
		}
	}
	assert_true(n_sure > 400 * DEPTH * MAP / 100 * 99 && n_of_parents > 10000);
}

/* What lies in the parent's middle is as far from the child as that: of two as far the lower node is shown. */
static void the_lower_node_wins_a_tie(void **state)
{
	(void)state;
	static line w;
	begin_line(&w, true);
	ts_store3(w.views[0].centre, ts_v3_make(1, 2, 3));
	ts_store3(w.views[1].centre, ts_v3_make(4, 2, -1));
	for (u32 t = 0; t < MAP; t++) {
		w.texels[t] = 100;
		w.texels[MAP + t] = (u64)ts_f2u(5) << 32 | (99 + t % 3);
	}
	fuse(&w);
	for (u32 t = 0; t < MAP; t++) assert_int_equal(w.shown[MAP + t], t % 3 == 0 ? 99 : 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(each_pair_writes_one_texel),
		seeded_test(the_nearest_pair_of_each_texel_wins),
		seeded_test(all_pairs_give_the_same_maps),
		seeded_test(each_texel_is_above_its_finer_ones),
		seeded_test(pairs_fill_just_what_they_cover),
		seeded_test(filled_texels_show_the_nearest_leaf),
		seeded_test(children_show_what_their_parents_show),
		seeded_test(the_lower_node_wins_a_tie),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
