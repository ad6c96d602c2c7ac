/* The lists of vpl_gather.pairs without queues of pairs, with the same entries. A pair at the level of gathering is
 * listed if the traversal culls none of the pairs that it splits on the way there. Nodes of a level have the same size
 * in both octrees, so the views are split first, then the node of the scene. A node of the scene tests, side by side,
 * the views of its level that its parent left. */
#include <omp.h>
#include <stdlib.h>
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/views/vpl_gather_pairs.h"

enum { MOST_LEVELS = 12, BELOW = 2 }; /* levels below a node that one thread takes */

/* Per view node: its middle, and the axis and psi of its cone. */
typedef struct {
	f32 *at[3], *axis[3], *cosine, *sine;
} lanes;

typedef struct {
	const ts_traverse_args *how;
	const ts_vpl_gather_pairs_args *to;
	u32 last;                      /* the level of gathering */
	u32 scene[MOST_LEVELS + 1];    /* nodes before each level */
	u32 views[MOST_LEVELS + 1], n; /* the same for views; their number */
	f32 radius[MOST_LEVELS];       /* of view nodes, per level */
	f32 *numbers;                  /* what the lanes point into */
	u32 *room;                     /* three times n per thread */
	lanes v;
	bool counts;
} job;

/* 1 for each view node that is left: before and after tests with a node of the scene of its level; and room for n
 * more. */
typedef struct {
	u32 *asked, *left, *other;
} flags;

static bool find_levels(const ts_node *nodes, u32 n_roots, u32 last, u32 *first)
{
	first[0] = 0;
	first[1] = n_roots;
	for (u32 level = 0; level < last; level++) {
		const ts_node *node = &nodes[first[level + 1] - 1];
		if (node->children == 0) return false;
		first[level + 2] = node->child + ts_k_count_bits(node->children);
	}
	return true;
}

/* The views are split where both nodes are of one level, the scene where the views are a level deeper. */
static bool splits_in_turns(job *j)
{
	for (u32 level = 0; level <= j->last; level++) {
		j->radius[level] = j->how->views[j->views[level]].radius;
		if (j->last == 0) continue;
		if (!(j->radius[level] > 0) || j->radius[level] != j->how->nodes[j->scene[level]].radius) return false;
		if (level > 0 && j->radius[level] != j->radius[level - 1] * 0.5f) return false;
	}
	return true;
}

static bool begin(job *j, u64 n_starts)
{
	const ts_traverse_args *how = j->how;
	if (how->to_last == 0 || how->apart > 0 || how->cutoff > 0 || how->n_nodes != 1 || how->first_node != 0)
		return false;
	if (how->last >= MOST_LEVELS || n_starts >= TS_NONE || (how->last > 0 && n_starts != 1)) return false;
	j->last = how->last;
	if (!find_levels(how->nodes, 1, j->last, j->scene)) return false;
	if (!find_levels(how->views, (u32)n_starts, j->last, j->views)) return false;
	j->n = j->views[j->last + 1];
	return j->to->first == j->scene[j->last] && splits_in_turns(j);
}

static bool allocate(job *j, u32 threads)
{
	f32 **lane[] = {&j->v.at[0],   &j->v.at[1],   &j->v.at[2],  &j->v.axis[0],
	                &j->v.axis[1], &j->v.axis[2], &j->v.cosine, &j->v.sine};
	enum { LANES = sizeof lane / sizeof *lane };
	j->numbers = malloc((size_t)j->n * LANES * sizeof *j->numbers);
	j->room = malloc((size_t)j->n * 3 * threads * sizeof *j->room);
	if (j->numbers == NULL || j->room == NULL) return false;
	for (u32 k = 0; k < LANES; k++) *lane[k] = j->numbers + (size_t)k * j->n;
	return true;
}

static void load(const job *j)
{
	for (u32 i = 0; i < j->n; i++) {
		ts_cone_k cone = ts_k_load_cone(&j->how->cones[i]);
		ts_aperture psi = ts_k_pair_psi(&cone, &j->how->phi);
		for (u32 k = 0; k < 3; k++) {
			j->v.at[k][i] = j->how->views[i].centre[k];
			j->v.axis[k][i] = j->how->cones[i].axis[k];
		}
		j->v.cosine[i] = psi.cosine;
		j->v.sine[i] = psi.sine;
	}
}

/* ts_k_pair_is_culled of views [begin, end). */
TS_WIDE(void, leave_seen,
        (u32 *restrict left, const u32 *restrict asked, lanes of, u32 begin, u32 end, ts_ball s, f32 radius),
        (left, asked, of, begin, end, s, radius))
{
	for (u32 i = begin; i < end; i++) {
		ts_ball v = {.p = ts_v3_make(of.at[0][i], of.at[1][i], of.at[2][i]), .r = radius};
		ts_v3 axis = ts_v3_make(of.axis[0][i], of.axis[1][i], of.axis[2][i]);
		ts_aperture psi = {of.cosine[i], of.sine[i]};
		f32 fs = ts_k_pair_outside_psi(ts_sub(s.p, v.p), axis, psi);
		u32 outside = fs > 0.0f ? 1u : 0u;
		u32 beyond = fs > ts_k_pair_reach(&s, &v) ? 1u : 0u;
		left[i] = asked[i] & ~(outside & beyond);
	}
}

/* Tests the views of a level, for a node of that level or the one above. */
static void leave(const job *j, u32 *left, const u32 *asked, u32 node, u32 level)
{
	leave_seen(left, asked, j->v, j->views[level], j->views[level + 1], ts_k_node_ball(&j->how->nodes[node]),
	           j->radius[level]);
}

/* Marks the views of the next level that the node's children test. */
static void ask_below(const job *j, const flags *f, u32 node, u32 level)
{
	for (u32 i = j->views[level]; i < j->views[level + 1]; i++) {
		const ts_node *view = &j->how->views[i];
		u32 n = ts_k_count_bits(view->children);
		for (u32 k = 0; k < n; k++) f->other[view->child + k] = f->left[i];
	}
	leave(j, f->asked, f->other, node, level + 1);
}

TS_WIDE(u32, count_left, (const u32 *left, u32 n), (left, n))
{
	u32 sum = 0;
	for (u32 i = 0; i < n; i++) sum += left[i];
	return sum;
}

static u32 list_left(const u32 *left, u32 first, u32 n, u32 *list)
{
	u32 at = 0;
	for (u32 i = 0; i < n; i++) {
		list[at] = first + i;
		at += left[i];
	}
	return at;
}

/* Entry i + 1 of `offset` counts the list of node i, or is where its next view goes. */
static void store(const job *j, const flags *f, u32 node)
{
	u32 first = j->views[j->last], n = j->n - first, *offset = &j->to->offset[node - j->to->first + 1];
	if (j->counts) {
		*offset += count_left(f->left + first, n);
		return;
	}
	u32 listed = list_left(f->left + first, first, n, f->other);
	memcpy(j->to->nodes + *offset, f->other, listed * sizeof *f->other);
	*offset += listed;
}

/* Finds the views that are left for a node, given those of its parent. */
static void descend(const job *j, const flags *f, u32 node, u32 level)
{
	leave(j, f->left, f->asked, node, level);
	if (level == j->last) {
		store(j, f, node);
		return;
	}
	const ts_node *parent = &j->how->nodes[node];
	u32 n = ts_k_count_bits(parent->children);
	ask_below(j, f, node, level);
	for (u32 k = 0; k < n; k++) descend(j, f, parent->child + k, level + 1);
}

/* Finds the views that are left for a node by way of its ancestors. */
static void ask(const job *j, const flags *f, u32 node, u32 level)
{
	if (level == 0) {
		for (u32 i = 0; i < j->views[1]; i++) f->asked[i] = 1;
		return;
	}
	u32 parent = j->how->nodes[node].parent;
	ask(j, f, parent, level - 1);
	leave(j, f->left, f->asked, parent, level - 1);
	ask_below(j, f, parent, level - 1);
}

static void all(const job *j, u32 threads)
{
	u32 level = j->last > BELOW ? j->last - BELOW : 0;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (i64 node = j->scene[level]; node < (i64)j->scene[level + 1]; node++) {
		if (ts_stopped(stop)) continue;
		u32 *room = j->room + (size_t)omp_get_thread_num() * 3 * j->n;
		flags f = {room, room + j->n, room + 2 * (size_t)j->n};
		ask(j, &f, (u32)node, level);
		descend(j, &f, (u32)node, level);
	}
}

static bool at_once(const void *source, const void *of, u64 n, u32 threads, bool counts)
{
	job j = {.how = source, .to = of, .counts = counts};
	if (n == 0) return true;
	if (!begin(&j, n)) return false;
	bool enough = allocate(&j, threads);
	if (enough) {
		load(&j);
		all(&j, threads);
	}
	free(j.numbers);
	free(j.room);
	return enough;
}

bool ts_c_at_once_vpl_gather_pairs_count(const void *source, const void *args, u64 n, u32 threads)
{
	return at_once(source, args, n, threads, true);
}

bool ts_c_at_once_vpl_gather_pairs_list(const void *source, const void *args, u64 n, u32 threads)
{
	return at_once(source, args, n, threads, false);
}

#include "backends/selftest.h"
