/* Octrees for tests: a room with balls and pillars, or noise, in the unit cube, and views in it; built by sorting
 * codes. */
#ifndef TS_TESTS_METHODS_VIEWS_GROVE_H
#define TS_TESTS_METHODS_VIEWS_GROVE_H
#include "tests/methods/small.h"

enum { GROVE_LEVELS = 9 };

static u64 grove_state;

/* Set-up of tests: the same groves, whatever ran before. */
static inline int grove_restart(void **state)
{
	(void)state;
	grove_state = 1234567;
	return 0;
}

/* Xorshift in [0, 1), as the prototype that FIGURES 11 comes from. */
static inline double grove_uniform(void)
{
	grove_state ^= grove_state << 13;
	grove_state ^= grove_state >> 7;
	grove_state ^= grove_state << 17;
	return (double)(grove_state >> 11) * (1.0 / 9007199254740992.0);
}

static inline u32 grove_below(u32 n) { return (u32)(grove_uniform() * n); }

/* A point and the way that a view looks from there. */
typedef struct {
	ts_v3 p, n;
} grove_place;

static inline ts_v3 grove_v3(double x, double y, double z) { return ts_v3_make((f32)x, (f32)y, (f32)z); }

static inline grove_place grove_wall(void)
{
	u32 wall = grove_below(6);
	double a = 0.03 + 0.94 * grove_uniform(), b = 0.03 + 0.94 * grove_uniform(), at = wall % 2 == 0 ? 0.03 : 0.97;
	f32 in = wall % 2 == 0 ? 1 : -1;
	if (wall < 2) return (grove_place){grove_v3(at, a, b), {in, 0, 0}};
	if (wall < 4) return (grove_place){grove_v3(a, at, b), {0, in, 0}};
	return (grove_place){grove_v3(a, b, at), {0, 0, in}};
}

static inline grove_place grove_thing(bool ball)
{
	u32 k = grove_below(ball ? 4 : 6);
	double z = ball ? 2 * grove_uniform() - 1 : 0, turn = 6.283185307179586 * grove_uniform(), r = sqrt(1 - z * z);
	ts_v3 n = grove_v3(r * cos(turn), r * sin(turn), z);
	ts_v3 of_ball = grove_v3(0.3 + 0.4 * (k & 1), 0.3 + 0.4 * (k >> 1), 0.14 + 0.1 * k);
	if (ball) return (grove_place){ts_mad(of_ball, n, 0.09f), n};
	ts_v3 of_pillar = grove_v3(0.15 + 0.14 * k, (k & 1) != 0 ? 0.2 : 0.8, 0.03 + 0.94 * grove_uniform());
	return (grove_place){ts_mad(of_pillar, n, 0.03f), n};
}

static inline grove_place grove_surface(void)
{
	double k = grove_uniform();
	return k < 0.55 ? grove_wall() : grove_thing(k < 0.75);
}

/* Of a square on the floor, as light falls through a window. */
static inline grove_place grove_floor(void)
{
	grove_uniform();
	double x = 0.3 + 0.4 * grove_uniform(), y = 0.3 + 0.4 * grove_uniform();
	return (grove_place){grove_v3(x, y, 0.0301), {0, 0, 1}};
}

static inline u64 grove_code(ts_v3 p, u32 levels)
{
	f32 at[3] = {p.x, p.y, p.z};
	u64 code = 0;
	for (u32 axis = 0; axis < 3; axis++) {
		i32 last = (1 << levels) - 1;
		u64 place = (u64)ts_min_i32(ts_max_i32(ts_floor_i32(at[axis] * (f32)(last + 1)), 0), last);
		for (u32 bit = 0; bit < levels; bit++) code |= (place >> bit & 1) << (3 * bit + axis);
	}
	return code;
}

static inline int grove_order(const void *a, const void *b)
{
	u64 x = *(const u64 *)a, y = *(const u64 *)b;
	return x < y ? -1 : x > y;
}

static inline u64 grove_unique(u64 *codes, u64 n)
{
	u64 kept = 0;
	qsort(codes, n, sizeof *codes, grove_order);
	for (u64 i = 0; i < n; i++) {
		if (kept == 0 || codes[kept - 1] != codes[i]) codes[kept++] = codes[i];
	}
	return kept;
}

typedef struct {
	ts_node *nodes;
	u32 before[GROVE_LEVELS + 2], levels; /* nodes before each level */
	u64 *leaves;                          /* codes */
} grove_tree;

static inline void grove_node(ts_node *node, u64 code, u32 level)
{
	u32 place[3] = {0, 0, 0};
	f32 side = 1.0f / (f32)(1u << level);
	for (u32 bit = 0; bit < 3 * level; bit++) place[bit % 3] |= (u32)(code >> bit & 1) << bit / 3;
	for (u32 k = 0; k < 3; k++) node->centre[k] = ((f32)place[k] + 0.5f) * side;
	node->radius = 0.8660254f * side;
	node->level = level;
	node->child = node->parent = TS_NONE;
}

/* A level from the codes of the one below; links both. */
static inline void grove_level(ts_node *nodes, const u64 *below, const u32 *before, u32 level)
{
	u32 own = before[level], n = before[level + 2] - before[level + 1];
	for (u32 i = 0; i < n; i++) {
		u32 child = before[level + 1] + i;
		own += i > 0 && below[i] >> 3 != below[i - 1] >> 3;
		if (nodes[own].children == 0) {
			grove_node(&nodes[own], below[i] >> 3, level);
			nodes[own].child = child;
		}
		nodes[own].children |= 1u << (below[i] & 7);
		nodes[child].parent = own;
	}
}

/* Of leaves with sorted, unique codes, which become the tree's. */
static inline grove_tree grove_build(u64 *leaves, u64 n, u32 levels)
{
	grove_tree t = {.leaves = leaves, .levels = levels};
	u64 *codes[GROVE_LEVELS + 1] = {NULL};
	u32 count[GROVE_LEVELS + 1] = {0};
	codes[levels] = leaves;
	count[levels] = (u32)n;
	for (u32 level = levels; level-- > 0;) {
		codes[level] = malloc(n * sizeof **codes);
		assert_non_null(codes[level]);
		for (u32 i = 0; i < count[level + 1]; i++) codes[level][i] = codes[level + 1][i] >> 3;
		count[level] = (u32)grove_unique(codes[level], count[level + 1]);
	}
	for (u32 level = 0; level <= levels; level++) t.before[level + 1] = t.before[level] + count[level];
	t.nodes = calloc(t.before[levels + 1], sizeof *t.nodes);
	assert_non_null(t.nodes);
	for (u32 i = 0; i < n; i++) grove_node(&t.nodes[t.before[levels] + i], leaves[i], levels);
	for (u32 level = levels; level-- > 0;) {
		grove_level(t.nodes, codes[level + 1], t.before, level);
		if (level + 1 < levels) free(codes[level + 1]);
	}
	if (levels > 0) free(codes[0]);
	return t;
}

static inline void grove_tree_free(grove_tree *t)
{
	free(t->nodes);
	free(t->leaves);
}

static inline u32 grove_leaf_of(const grove_tree *t, ts_v3 p)
{
	u64 code = grove_code(p, t->levels);
	const u64 *found =
		bsearch(&code, t->leaves, t->before[t->levels + 1] - t->before[t->levels], sizeof code, grove_order);
	assert_non_null(found);
	return t->before[t->levels] + (u32)(found - t->leaves);
}

typedef struct {
	grove_tree scene, views;
	ts_cone *cones;      /* of views.nodes */
	grove_place *places; /* the views */
	u32 *leaf;           /* of each */
	u32 n_places;
} grove;

/* The least cone about the mean direction that holds all below: by a walk up from every view. */
static inline void grove_cones(grove *g)
{
	u32 n = g->views.before[g->views.levels + 1];
	g->cones = calloc(n, sizeof *g->cones);
	assert_non_null(g->cones);
	for (u32 i = 0; i < g->n_places; i++) {
		for (u32 v = g->leaf[i]; v != TS_NONE; v = g->views.nodes[v].parent) {
			ts_store3(g->cones[v].axis, ts_add(ts_load3(g->cones[v].axis), g->places[i].n));
			g->cones[v].views++;
		}
	}
	for (u32 v = 0; v < n; v++) {
		ts_v3 sum = ts_load3(g->cones[v].axis);
		ts_store3(g->cones[v].axis, ts_length(sum) > 1e-6f ? ts_normalize(sum) : ts_v3_make(0, 0, 1));
		g->cones[v].cosine = 1;
	}
	for (u32 i = 0; i < g->n_places; i++) {
		for (u32 v = g->leaf[i]; v != TS_NONE; v = g->views.nodes[v].parent) {
			f32 cosine = ts_dot(ts_load3(g->cones[v].axis), g->places[i].n);
			g->cones[v].cosine = ts_min(g->cones[v].cosine, cosine);
		}
	}
}

typedef grove_place grove_source(void);

static inline u64 *grove_codes(u64 n)
{
	u64 *codes = malloc(n * sizeof *codes);
	assert_non_null(codes);
	return codes;
}

static inline void grove_plant(grove *g, u32 levels_s, u32 levels_v, u64 n_points, grove_source *point, u32 n_views,
                               grove_source *view)
{
	u64 *codes = grove_codes(n_points), *view_codes = grove_codes(n_views);
	for (u64 i = 0; i < n_points; i++) codes[i] = grove_code(point().p, levels_s);
	g->scene = grove_build(codes, grove_unique(codes, n_points), levels_s);
	g->places = malloc(n_views * sizeof *g->places);
	g->leaf = malloc(n_views * sizeof *g->leaf);
	assert_true(g->places != NULL && g->leaf != NULL);
	g->n_places = n_views;
	for (u32 i = 0; i < n_views; i++) {
		g->places[i] = view();
		g->places[i].p = ts_mad(g->places[i].p, g->places[i].n, 0.002f);
		view_codes[i] = grove_code(g->places[i].p, levels_v);
	}
	g->views = grove_build(view_codes, grove_unique(view_codes, n_views), levels_v);
	for (u32 i = 0; i < n_views; i++) g->leaf[i] = grove_leaf_of(&g->views, g->places[i].p);
	grove_cones(g);
}

static inline void grove_free(grove *g)
{
	grove_tree_free(&g->scene);
	grove_tree_free(&g->views);
	free(g->cones);
	free(g->places);
	free(g->leaf);
}

/* Sizes are what buffers tell that were not made by stages. */
static inline void grove_sizes(ts_run *run)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_dim of = ts_buffer_gives((ts_buffer_id)id);
		bool counts = run->frame.buffer[id].made && of != TS_DIM_none && ts_dim_table[of].how == TS_IS_counted;
		if (counts) ts_run_set_size(run, of, run->frame.buffer[id].shape[0]);
	}
}

/* A run in whose frame the octrees are; its stages run one by one. */
static inline void grove_begin(ts_run *run, const ts_scene *scene, const ts_params *params, u32 threads, const grove *g)
{
	ts_run_begin(run, scene, params, threads);
	u32 n = g->views.before[g->views.levels + 1];
	ts_frame_borrow(&run->frame, TS_B_octree_node, g->scene.nodes, g->scene.before[g->scene.levels + 1]);
	ts_frame_borrow(&run->frame, TS_B_view_octree_node, g->views.nodes, n);
	ts_frame_borrow(&run->frame, TS_B_view_octree_level, g->views.before, g->views.levels + 2);
	ts_frame_borrow(&run->frame, TS_B_view_octree_cone, g->cones, n);
	grove_sizes(run);
}

static inline void grove_stage(ts_run *run, const char *name)
{
	if (ts_run_stage(run, ts_stage_find(name)) != TS_OK) fail_msg("%s", ts_error_message());
}

/* A run with views alone, some of those of the grove. */
static inline void grove_begin_alone(ts_run *run, const ts_scene *scene, const ts_params *params, const grove *g,
                                     ts_vpl *lights, u32 n)
{
	ts_run_begin(run, scene, params, 2);
	for (u32 i = 0; i < n; i++) {
		const grove_place *place = &g->places[(u64)i * g->n_places / n];
		lights[i] = (ts_vpl){.bounce = 1};
		ts_store3(lights[i].position, place->p);
		ts_store3(lights[i].normal, place->n);
	}
	run->params.octree_levels = g->scene.levels;
	ts_frame_borrow(&run->frame, TS_B_octree_node, g->scene.nodes, g->scene.before[g->scene.levels + 1]);
	ts_frame_borrow(&run->frame, TS_B_octree_level, g->scene.before, g->scene.levels + 2);
	ts_frame_borrow(&run->frame, TS_B_vpl_light, lights, n);
	grove_sizes(run);
	grove_stage(run, "view_octree.alone");
}

/* What a run made. */
typedef struct {
	u64 n_pairs, n_maps, n_depths;
	u64 *pairs, *maps; /* pairs: if it was traced */
	u32 *depths, *shown;
	i64 longest; /* step, in pairs */
} grove_outcome;

static inline void *grove_copy(const ts_run *run, ts_buffer_id id, u64 *n)
{
	const ts_buffer *b = &run->frame.buffer[id];
	void *copy = malloc(b->bytes + 1);
	assert_non_null(copy);
	memcpy(copy, ts_frame_data(&run->frame, id), b->bytes);
	*n = b->n;
	return copy;
}

static inline grove_outcome grove_run(const grove *g, const ts_scene *scene, const ts_params *params, u32 threads,
                                      ts_backend *backend, bool traced)
{
	ts_run run;
	grove_outcome r = {.pairs = NULL};
	grove_begin(&run, scene, params, threads, g);
	run.backend = backend;
	if (traced) grove_stage(&run, "traverse");
	grove_stage(&run, "view_map");
	grove_stage(&run, "view_map.fuse");
	if (traced) r.pairs = grove_copy(&run, TS_B_traverse_rendered, &r.n_pairs);
	r.maps = grove_copy(&run, TS_B_view_map_depth_node, &r.n_maps);
	r.depths = grove_copy(&run, TS_B_view_map_fused_depth, &r.n_depths);
	r.shown = grove_copy(&run, TS_B_view_map_fused_node, &r.n_depths);
	r.longest = ts_run_counter(&run, "longest queue");
	ts_run_end(&run);
	return r;
}

/* What a texel of the whole maps shows, as in those of the pairs. */
static inline u64 grove_fused(const grove_outcome *r, u64 i) { return (u64)r->depths[i] << 32 | r->shown[i]; }

static inline void grove_assert_same(const grove_outcome *a, const grove_outcome *b)
{
	assert_true(a->n_maps == b->n_maps && a->n_depths == b->n_depths);
	assert_memory_equal(a->maps, b->maps, a->n_maps * sizeof *a->maps);
	assert_memory_equal(a->depths, b->depths, a->n_depths * sizeof *a->depths);
	assert_memory_equal(a->shown, b->shown, a->n_depths * sizeof *a->shown);
	if (a->pairs == NULL || b->pairs == NULL) return;
	assert_int_equal(a->n_pairs, b->n_pairs);
	assert_memory_equal(a->pairs, b->pairs, a->n_pairs * sizeof *a->pairs);
}

static inline void grove_outcome_free(grove_outcome *r)
{
	free(r->pairs);
	free(r->maps);
	free(r->depths);
	free(r->shown);
}

/* Anywhere, looking anywhere. */
static inline grove_place grove_noise(void)
{
	f32 x = (f32)grove_uniform(), y = (f32)grove_uniform(), z = (f32)grove_uniform();
	f32 a = (f32)grove_uniform() - 0.5f, b = (f32)grove_uniform() - 0.5f;
	ts_v3 p = ts_v3_make(0.02f + 0.96f * x, 0.02f + 0.96f * y, 0.02f + 0.96f * z);
	return (grove_place){p, ts_normalize(ts_v3_make(a, b, 0.3f))};
}

#endif
