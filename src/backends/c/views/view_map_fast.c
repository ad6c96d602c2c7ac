/* Maps without queues of pairs, with the same texels and counts: the traversal goes depth first, and the pairs that
 * follow from some split pairs are decided and rendered side by side (pair_lot.h). Threads take nodes of views of one
 * level; nobody else writes their maps and those below them, so nothing is atomic. Pairs above that level are decided
 * again for each node of it, but rendered and counted only for the first node below them. */
#include <omp.h>
#include <stdlib.h>
#include "backends/c/views/cap_rows.h"
#include "backends/c/views/pair_lot.h"
#include "backends/fast.h"

enum { SHARES = 16, ROOTS = 16 }; /* least shares of work per thread; most roots of views per share */
enum { FASTER = 2 };              /* than the passes, with equally many threads */
enum { MOST_ROWS = TS_LOT_PAIRS * (TS_STEPS + 1), MOST_LEVELS = TS_STEPS + 1 };

/* An octree, as deep as a traversal descends. */
typedef struct {
	const ts_node *nodes;
	ts_lane_nodes lanes;
	u32 *child;
	u8 *children, *level;           /* number of children; steps below the nodes with which the traversal begins */
	u32 n_levels, n, level_of_leaf; /* the first level that has a leaf */
	u32 first[MOST_LEVELS + 1];     /* node of each level */
} octree;

typedef struct {
	const ts_traverse_args *how;
	ts_view_map_args to;
	ts_lot_job lots;
	ts_cap_sides sides;
	u32 n_texels; /* of a map */
	octree scene, views;
	u32 shared; /* the level whose nodes of views the threads share */
	u64 steps[TS_STEPS];
	ts_stop *stop;
} job;

/* What a thread works on: the views below some nodes of the shared level, and the one path from a root to there. */
typedef struct {
	job *of;
	u32 root, end, node; /* with which the next pairs begin */
	u32 path[MOST_LEVELS];
	u8 leads[MOST_LEVELS]; /* 1: the path's node at the shared level is the first below this node */
	ts_pair_counts counts;
	u64 steps[TS_STEPS];
	ts_pair_lot lot;
	u32 n_rows, n_waiting;
	ts_pair_row row[TS_LOT_PAIRS], waiting[MOST_ROWS]; /* of the lot; waiting ones, the deepest last */
} share;

/* Finds the levels from `begin` on; the first has n nodes. False: there are more than a traversal has steps. */
static bool find_levels(octree *t, const ts_node *nodes, u32 begin, u32 n)
{
	t->nodes = nodes;
	t->first[0] = begin;
	t->level_of_leaf = TS_NONE;
	for (u32 end = begin + n; begin < end; t->n_levels++) {
		u32 next = end;
		if (t->n_levels == MOST_LEVELS) return false;
		for (u32 i = begin; i < end; i++) {
			if (nodes[i].children == 0 && t->level_of_leaf == TS_NONE) t->level_of_leaf = t->n_levels;
			if (nodes[i].children != 0) next = nodes[i].child + ts_k_count_bits(nodes[i].children);
		}
		t->first[t->n_levels + 1] = t->n = begin = end;
		end = next;
	}
	return true;
}

static void load_node(octree *t, u32 i, u32 level)
{
	const ts_node *node = &t->nodes[i];
	for (u32 k = 0; k < 3; k++) t->lanes.at[k][i] = node->centre[k];
	t->lanes.radius[i] = node->radius;
	t->lanes.leaf[i] = node->children == 0 ? 1 : 0;
	t->child[i] = node->child;
	t->children[i] = (u8)ts_k_count_bits(node->children);
	t->level[i] = (u8)level;
}

static void *allocate(u32 n, size_t bytes) { return calloc((size_t)n + TS_ROW, bytes); }

static bool load_tree(octree *t)
{
	bool enough = true;
	for (u32 k = 0; k < 3; k++) enough &= (t->lanes.at[k] = allocate(t->n, sizeof(f32))) != NULL;
	enough &= (t->lanes.radius = allocate(t->n, sizeof(f32))) != NULL;
	enough &= (t->lanes.leaf = allocate(t->n, sizeof(u32))) != NULL;
	enough &= (t->child = allocate(t->n, sizeof(u32))) != NULL;
	enough &= (t->children = allocate(t->n, 1)) != NULL;
	enough &= (t->level = allocate(t->n, 1)) != NULL;
	for (u32 level = 0; enough && level < t->n_levels; level++) {
		for (u32 i = t->first[level]; i < t->first[level + 1]; i++) load_node(t, i, level);
	}
	return enough;
}

static bool load_cones(job *j)
{
	ts_lane_cones *c = &j->lots.cones;
	u32 n = j->views.n;
	bool enough = true;
	for (u32 k = 0; k < 3; k++) enough &= (c->axis[k] = allocate(n, sizeof(f32))) != NULL;
	enough &= (c->cosine = allocate(n, sizeof(f32))) != NULL;
	enough &= (c->sine = allocate(n, sizeof(f32))) != NULL;
	enough &= (c->views = allocate(n, sizeof(u32))) != NULL;
	for (u32 i = 0; enough && i < n; i++) {
		ts_cone_k cone = ts_k_load_cone(&j->how->cones[i]);
		ts_aperture psi = ts_k_pair_psi(&cone, &j->how->phi);
		for (u32 k = 0; k < 3; k++) c->axis[k][i] = j->how->cones[i].axis[k];
		c->cosine[i] = psi.cosine;
		c->sine[i] = psi.sine;
		c->views[i] = j->how->cones[i].views;
	}
	return enough;
}

static void unload(job *j)
{
	for (u32 k = 0; k < 3; k++) {
		free(j->scene.lanes.at[k]);
		free(j->views.lanes.at[k]);
		free(j->lots.cones.axis[k]);
	}
	void *const memory[] = {j->scene.lanes.radius, j->scene.lanes.leaf,   j->scene.child,       j->scene.children,
	                        j->scene.level,        j->views.lanes.radius, j->views.lanes.leaf,  j->views.child,
	                        j->views.children,     j->views.level,        j->lots.cones.cosine, j->lots.cones.sine,
	                        j->lots.cones.views};
	for (u32 i = 0; i < sizeof memory / sizeof *memory; i++) free(memory[i]);
}

static u32 nodes_of(const octree *t, u32 level) { return t->first[level + 1] - t->first[level]; }

/* Finds the first level with enough nodes of views for all threads, or the one with the most. False: there are so few
 * that the passes, for which all threads work, are faster. */
static bool find_shared(job *j, u32 threads)
{
	u64 enough = (u64)threads * SHARES;
	for (u32 level = 0; threads > 1 && level <= j->views.level_of_leaf; level++) {
		if (nodes_of(&j->views, j->shared) >= enough) break;
		if (nodes_of(&j->views, level) > nodes_of(&j->views, j->shared)) j->shared = level;
	}
	return threads == 1 || (u64)nodes_of(&j->views, j->shared) * FASTER >= threads;
}

static bool begin(job *j, u64 n_starts, u32 threads)
{
	const ts_traverse_args *how = j->how;
	u64 n_roots = n_starts / how->n_nodes;
	if (how->to_last != 0 || how->cutoff > 0 || how->last != TS_NONE || how->n != j->to.pyramid.n) return false;
	if ((how->n & (how->n - 1)) != 0 || how->n > TS_MOST_SIDE || n_roots >= TS_NONE) return false;
	if (!find_levels(&j->scene, how->nodes, how->first_node, how->n_nodes)) return false;
	if (!find_levels(&j->views, how->views, 0, (u32)n_roots)) return false;
	return j->scene.n_levels + j->views.n_levels <= TS_STEPS + 1 && find_shared(j, threads);
}

/* Rows of pairs with which the traversal begins. */
static void begin_rows(share *s)
{
	const job *j = s->of;
	u32 first = j->how->first_node, end = first + j->how->n_nodes;
	while (s->root < s->end && s->n_waiting < TS_ROW) {
		bool of_views = j->how->n_nodes == 1;
		u32 left = of_views ? s->end - s->root : end - s->node, n = left < TS_ROW ? left : TS_ROW;
		s->waiting[s->n_waiting++] = (ts_pair_row){.first = of_views ? s->root : s->node,
		                                           .other = of_views ? s->node : s->root,
		                                           .n = (u8)n,
		                                           .of_views = of_views,
		                                           .mine = s->leads[0]};
		if (of_views) s->root += n;
		if (!of_views) s->node += n;
		if (of_views || s->node < end) continue;
		s->root++;
		s->node = first;
	}
}

/* Makes a lot of the rows that wait, later ones first, and counts its pairs. */
static void take_rows(share *s)
{
	u32 n = 0;
	s->n_rows = 0;
	while (s->n_waiting > 0 && n + s->waiting[s->n_waiting - 1].n <= TS_LOT_PAIRS) {
		const ts_pair_row *row = &s->waiting[--s->n_waiting];
		u32 counted = row->mine != 0 ? row->n : 0;
		s->row[s->n_rows++] = *row;
		s->steps[row->step] += counted;
		s->counts.pairs += counted;
		n += row->n;
	}
	ts_pair_lot_lay(&s->lot, &s->of->lots, s->row, s->n_rows);
}

static ts_pair_row views_below(const share *s, u32 node, u32 view)
{
	const octree *t = &s->of->views;
	u32 level = t->level[view];
	ts_pair_row row = {.first = t->child[view], .other = node, .n = t->children[view], .of_views = 1, .mine = 1};
	if (level >= s->of->shared) return row;
	row.first = s->path[level + 1];
	row.n = 1;
	row.mine = s->leads[level + 1];
	return row;
}

/* Adds the children of split pairs; those of the deepest come last. */
static void split(share *s)
{
	const ts_pair_lot *lot = &s->lot;
	const octree *scene = &s->of->scene;
	for (u32 i = lot->n; i-- > 0;) {
		if (lot->split[i] == 0) continue;
		ts_pair_row *row = &s->waiting[s->n_waiting++];
		u32 node = lot->node[i], view = lot->view[i];
		*row = (ts_pair_row){
			.first = scene->child[node], .other = view, .n = scene->children[node], .mine = (u8)lot->mine[i]};
		if (lot->split[i] == 2) *row = views_below(s, node, view);
		row->step = (u8)(lot->step[i] + 1);
	}
}

static inline void lower(u64 *texel, u64 key) { *texel = key < *texel ? key : *texel; }

static u64 key_of(const ts_pair_lot *lot, u32 i) { return ((u64)lot->depth[i] << 32) | lot->node[i]; }

static u64 *map_of(const job *j, u32 view) { return j->to.texels + (u64)view * j->n_texels; }

/* Fills the texels of a pair of the lot in half a map. */
static void fill_half(const job *j, const ts_pair_lot *lot, u32 i, u32 back)
{
	const ts_lot_half *half = &lot->half[back];
	u64 key = key_of(lot, i), *map = map_of(j, lot->view[i]), *texel = map + half->texel[i];
	u32 mask = half->mask[i], n = j->to.pyramid.n;
	if (mask == TS_LOT_MANY) {
		f32 radius = lot->node_radius[i] * j->to.pyramid.fill;
		ts_cap cap = ts_k_cap(ts_v3_make(lot->x[i], lot->y[i], lot->z[i]), radius, back != 0);
		ts_cap_rows_fill(map, &j->sides, &cap, back != 0, key);
		return;
	}
	for (u32 k = 0; k < 4; k++) {
		if ((mask >> k & 1) != 0) lower(texel + (k >> 1) * n + (k & 1), key);
	}
}

static void leave_own(share *s)
{
	ts_pair_lot *lot = &s->lot;
	const job *j = s->of;
	for (u32 i = 0; i < lot->n; i++) {
		u64 pair = ts_k_pair(lot->node[i], lot->view[i]);
		if (lot->rendered[i] != 0 && ts_k_pair_is_own(&j->to.own, j->how->views, pair)) lot->rendered[i] = 0;
	}
}

static void draw_middles(const job *j, const ts_pair_lot *lot)
{
	for (u32 i = 0; i < lot->n; i++) {
		if (lot->rendered[i] != 0) lower(map_of(j, lot->view[i]) + lot->middle[i], key_of(lot, i));
	}
}

static void draw_half(const job *j, const ts_pair_lot *lot, u32 back)
{
	u32 list[TS_LOT_PAIRS], n = 0;
	for (u32 i = 0; i < lot->n; i++) {
		list[n] = i;
		n += lot->rendered[i] & (lot->half[back].mask[i] != 0 ? 1u : 0u);
	}
	for (u32 k = 0; k < n; k++) fill_half(j, lot, list[k], back);
}

static void draw(share *s)
{
	const job *j = s->of;
	if (j->to.own.reflectors != NULL) leave_own(s);
	ts_pair_lot_place(&s->lot, &j->lots);
	if (j->to.pyramid.point != 0) draw_middles(j, &s->lot);
	for (u32 back = 0; ts_lot_fills(&j->to.pyramid) && back < 2; back++) draw_half(j, &s->lot, back);
}

/* Begins with nodes [first, end) of the shared level: roots, or one below a root. */
static void enter(share *s, u32 first, u32 end)
{
	const octree *t = &s->of->views;
	u32 level = s->of->shared;
	s->path[level] = first;
	s->leads[level] = 1;
	for (; level > 0; level--) {
		u32 parent = t->nodes[s->path[level]].parent;
		s->path[level - 1] = parent;
		s->leads[level - 1] = s->leads[level] != 0 && t->child[parent] == s->path[level] ? 1 : 0;
	}
	s->root = s->path[0];
	s->end = s->of->shared == 0 ? end : s->root + 1;
	s->node = s->of->how->first_node;
}

static void render(share *s)
{
	while (!ts_stopped(s->of->stop)) {
		if (s->n_waiting == 0) begin_rows(s);
		if (s->n_waiting == 0) return;
		u64 rendered = s->counts.rendered;
		take_rows(s);
		ts_pair_lot_decide(&s->lot, &s->of->lots, &s->counts);
		if (s->counts.rendered > rendered) draw(s);
		split(s);
	}
}

static void add_counts(const share *s)
{
	const ts_pair_counts *c = &s->counts;
	const u64 counted[] = {c->culled, c->near, c->rendered, c->wide, c->several, c->served, c->pairs};
	for (u32 i = 0; i < sizeof counted / sizeof *counted; i++) s->of->how->tallies[i] += (i64)counted[i];
	for (u32 step = 0; step < TS_STEPS; step++) s->of->steps[step] += s->steps[step];
}

static void all(job *j, share *shares, u32 threads)
{
	u32 first = j->views.first[j->shared], n = nodes_of(&j->views, j->shared), each = 1;
	if (j->shared == 0) each = n / (threads * SHARES) < ROOTS ? n / (threads * SHARES) + 1 : ROOTS;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (u32 at = 0; at < n; at += each) {
		share *s = &shares[omp_get_thread_num()];
		enter(s, first + at, first + (at + each < n ? at + each : n));
		render(s);
	}
	for (u32 i = 0; i < threads; i++) add_counts(&shares[i]);
	i64 *longest = &j->how->tallies[TS_TALLY_LONGEST];
	for (u32 step = 0; step < TS_STEPS; step++)
		*longest = (i64)j->steps[step] > *longest ? (i64)j->steps[step] : *longest;
}

bool ts_c_at_once_view_map(const void *source, const void *args, u64 n, u32 threads)
{
	job j = {.how = source, .to = *(const ts_view_map_args *)args, .stop = ts_stop_here()};
	if (n == 0) return true;
	if (!begin(&j, n, threads)) return false;
	share *shares = calloc(threads, sizeof *shares);
	bool enough = shares != NULL && load_tree(&j.scene) && load_tree(&j.views) && load_cones(&j);
	if (enough) {
		for (u32 i = 0; i < threads; i++) shares[i].of = &j;
		j.lots.scene = j.scene.lanes;
		j.lots.views = j.views.lanes;
		j.lots.pyramid = j.to.pyramid;
		j.lots.apart = j.how->apart;
		j.n_texels = ts_k_pyramid_texels(&j.to.pyramid);
		ts_cap_sides_set(&j.sides, &j.to.pyramid);
		all(&j, shares, threads);
	}
	unload(&j);
	free(shares);
	return enough;
}

#include "backends/selftest.h"
