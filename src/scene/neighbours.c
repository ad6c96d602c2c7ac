/* A k-d tree in one array: the points of a node are a range of `order`, its children the halves of it. A search skips a
 * node when nothing in it, by the distance to its box and by its lowest index, can be among the nearest. */
#include "scene/neighbours.h"
#include <stdlib.h>

enum { LEAF = 8, RUN = 1 << 16 };

typedef struct {
	ts_v3 low, high;
	u32 lowest;
} box; /* of a range's points; their lowest index */

struct ts_neighbours {
	const ts_v3 *points;
	u32 n, n_nodes;
	u32 *order;
	box *nodes; /* node i has the children 2 i + 1 and 2 i + 2 */
	ts_stop *stop;
};

static f32 along(ts_v3 p, u32 axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

static u32 widest(const box *b)
{
	ts_v3 d = ts_sub(b->high, b->low);
	return d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
}

static bool is_before(const ts_v3 *points, u32 axis, u32 i, u32 j)
{
	f32 a = along(points[i], axis), b = along(points[j], axis);
	return a < b || (a == b && i < j);
}

static void swap(u32 *a, u32 *b)
{
	u32 c = *a;
	*a = *b;
	*b = c;
}

/* Moves the `middle` first of the range before the others: Hoare's selection. */
static void part(const ts_v3 *points, u32 *order, u32 n, u32 middle, u32 axis)
{
	u32 low = 0, high = n - 1;
	while (low < high) {
		u32 pivot = order[low + ts_random(low, high, 0) % (high - low + 1)], i = low, j = high;
		while (i <= j) {
			while (is_before(points, axis, order[i], pivot)) i++;
			while (is_before(points, axis, pivot, order[j])) j--;
			if (i > j) break;
			swap(&order[i++], &order[j]);
			if (j-- == 0) break;
		}
		if (middle >= i)
			low = i;
		else if (middle <= j && j < n)
			high = j;
		else
			return;
	}
}

static box box_of(const ts_v3 *points, const u32 *order, u32 n)
{
	box b = {points[order[0]], points[order[0]], order[0]};
	for (u32 i = 1; i < n; i++) {
		b.low = ts_min3(b.low, points[order[i]]);
		b.high = ts_max3(b.high, points[order[i]]);
		b.lowest = order[i] < b.lowest ? order[i] : b.lowest;
	}
	return b;
}

static void grow(ts_neighbours *tree, u32 node, u32 first, u32 n)
{
	u32 *order = tree->order + first;
	tree->nodes[node] = box_of(tree->points, order, n);
	if (n <= LEAF || ts_stopped(tree->stop)) return;
	part(tree->points, order, n, n / 2, widest(&tree->nodes[node]));
	grow(tree, 2 * node + 1, first, n / 2);
	grow(tree, 2 * node + 2, first + n / 2, n - n / 2);
}

/* For a tree whose every level halves: the right child has the larger half. */
static u32 nodes_for(u32 n)
{
	u32 levels = 1;
	for (; n > LEAF; n -= n / 2) levels++;
	return (1u << levels) - 1;
}

ts_neighbours *ts_neighbours_new(const ts_v3 *points, u32 n)
{
	ts_neighbours *tree = ts_alloc_zero(1, sizeof *tree, "a tree of points");
	if (tree == NULL) return NULL;
	*tree = (ts_neighbours){.points = points, .n = n, .n_nodes = nodes_for(n), .stop = ts_stop_here()};
	tree->order = ts_alloc(n, sizeof *tree->order, "the order of points");
	tree->nodes = ts_alloc(tree->n_nodes, sizeof *tree->nodes, "nodes of a tree of points");
	if (tree->order == NULL || tree->nodes == NULL) {
		ts_neighbours_free(tree);
		return NULL;
	}
	for (u32 i = 0; i < n; i++) tree->order[i] = i;
	if (n > 0) grow(tree, 0, 0, n);
	if (ts_go_on() == TS_OK) return tree;
	ts_neighbours_free(tree);
	return NULL;
}

void ts_neighbours_free(ts_neighbours *tree)
{
	if (tree == NULL) return;
	free(tree->order);
	free(tree->nodes);
	free(tree);
}

typedef struct {
	const ts_neighbours *tree;
	ts_v3 at;
	u32 self, k, n;
	ts_neighbour *found; /* n neighbours so far, nearest first */
} search;

static f32 square_of(ts_v3 d) { return ts_dot(d, d); }

static bool is_wanted(const search *s, f32 square, u32 index)
{
	if (s->n < s->k) return true;
	const ts_neighbour *last = &s->found[s->n - 1];
	return square < last->square || (square == last->square && index < last->index);
}

static void offer(search *s, u32 index)
{
	f32 square = square_of(ts_sub(s->tree->points[index], s->at));
	if (index == s->self || !is_wanted(s, square, index)) return;
	u32 place = s->n < s->k ? s->n++ : s->n - 1;
	for (; place > 0; place--) {
		const ts_neighbour *before = &s->found[place - 1];
		if (before->square < square || (before->square == square && before->index < index)) break;
		s->found[place] = *before;
	}
	s->found[place] = (ts_neighbour){square, index};
}

/* At most the square to any point of the box: each operation rounds the same way as a point's. */
static f32 square_to(const box *b, ts_v3 p)
{
	ts_v3 nearest = ts_min3(ts_max3(p, b->low), b->high);
	return square_of(ts_sub(nearest, p));
}

static void visit(search *s, u32 node, u32 first, u32 n)
{
	const box *b = &s->tree->nodes[node];
	if (!is_wanted(s, square_to(b, s->at), b->lowest)) return;
	if (n <= LEAF) {
		for (u32 i = first; i < first + n; i++) offer(s, s->tree->order[i]);
		return;
	}
	const box *left = &s->tree->nodes[2 * node + 1], *right = &s->tree->nodes[2 * node + 2];
	f32 to_left = square_to(left, s->at), to_right = square_to(right, s->at);
	bool left_first = to_left < to_right || (to_left == to_right && left->lowest < right->lowest);
	if (left_first) visit(s, 2 * node + 1, first, n / 2);
	visit(s, 2 * node + 2, first + n / 2, n - n / 2);
	if (!left_first) visit(s, 2 * node + 1, first, n / 2);
}

u32 ts_neighbours_find(const ts_neighbours *tree, u32 i, u32 k, ts_neighbour *found)
{
	search s = {.tree = tree, .at = tree->points[i], .self = i, .k = k, .found = found};
	if (k > 0) visit(&s, 0, 0, tree->n);
	return s.n;
}

typedef struct {
	ts_v3 at;
	u32 index;
} placed;

static int by_place(const void *a, const void *b)
{
	const placed *p = a, *q = b;
	if (p->at.x != q->at.x) return p->at.x < q->at.x ? -1 : 1;
	if (p->at.y != q->at.y) return p->at.y < q->at.y ? -1 : 1;
	if (p->at.z != q->at.z) return p->at.z < q->at.z ? -1 : 1;
	return p->index < q->index ? -1 : 1;
}

static void merge(placed *to, const placed *from, u64 middle, u64 n, ts_stop *stop)
{
	u64 i = 0, j = middle;
	for (u64 k = 0; k < n && !ts_stopped(stop); k++) {
		bool first = j == n || (i < middle && by_place(&from[i], &from[j]) < 0);
		to[k] = from[first ? i++ : j++];
	}
}

/* Sorts so that it can be stopped. Returns the array of both that has the result. */
static placed *sort(placed *from, placed *to, u64 n, ts_stop *stop)
{
	for (u64 first = 0; first < n && !ts_stopped(stop); first += RUN)
		qsort(from + first, n - first < RUN ? n - first : RUN, sizeof *from, by_place);
	for (u64 run = RUN; run < n; run *= 2) {
		for (u64 first = 0; first < n; first += 2 * run) {
			u64 left = n - first;
			merge(to + first, from + first, left < run ? left : run, left < 2 * run ? left : 2 * run, stop);
		}
		placed *sorted = to;
		to = from;
		from = sorted;
	}
	return from;
}

/* The first point of each place, then the places by these. */
static void find_places(ts_places_of *of, const placed *sorted, const ts_v3 *points, u32 n, ts_stop *stop)
{
	for (u32 k = 0, first = 0; k < n && !ts_stopped(stop); k++) {
		if (sorted[k].at.x != sorted[first].at.x || sorted[k].at.y != sorted[first].at.y ||
		    sorted[k].at.z != sorted[first].at.z)
			first = k;
		of->place[sorted[k].index] = sorted[first].index;
	}
	for (u32 i = 0; i < n && !ts_stopped(stop); i++) {
		bool is_first = of->place[i] == i;
		if (is_first) of->at[of->n] = points[i];
		of->place[i] = is_first ? of->n++ : of->place[of->place[i]];
	}
}

ts_status ts_neighbours_places(ts_places_of *of, const ts_v3 *points, u32 n)
{
	ts_stop *stop = ts_stop_here();
	placed *sorted = ts_alloc(2 * (size_t)n, sizeof *sorted, "places of points");
	*of = (ts_places_of){.at = ts_alloc(n, sizeof *of->at, "places of points"),
	                     .place = ts_alloc(n, sizeof *of->place, "places of points")};
	ts_status status = sorted != NULL && of->at != NULL && of->place != NULL ? TS_OK : TS_ERROR;
	if (status == TS_OK) {
		for (u32 i = 0; i < n; i++) sorted[i] = (placed){points[i], i};
		find_places(of, sort(sorted, sorted + n, n, stop), points, n, stop);
		status = ts_go_on();
	}
	free(sorted);
	if (status != TS_OK) ts_neighbours_places_free(of);
	return status;
}

void ts_neighbours_places_free(ts_places_of *of)
{
	free(of->at);
	free(of->place);
}

static ts_status distances(f32 *distance, const ts_v3 *points, u32 n, u32 k)
{
	ts_neighbours *tree = ts_neighbours_new(points, n);
	if (tree == NULL) return TS_ERROR;
#pragma omp parallel for num_threads((int)ts_threads_all()) schedule(dynamic, 1024)
	for (u32 i = 0; i < n; i++) {
		if (ts_stopped(tree->stop)) continue;
		ts_neighbour found[TS_MAX_NEIGHBOURS];
		u32 m = ts_neighbours_find(tree, i, k, found);
		f32 sum = 0.0f;
		for (u32 j = 0; j < m; j++) sum += ts_sqrt(found[j].square);
		distance[i] = m > 0 ? sum / (f32)m : 0.0f;
	}
	ts_neighbours_free(tree);
	return ts_go_on();
}

ts_status ts_neighbours_distance(f32 *distance, const ts_v3 *points, u32 n, u32 k)
{
	ts_places_of of;
	f32 *own = ts_alloc(n, sizeof *own, "distances of points");
	ts_status status = own != NULL ? ts_neighbours_places(&of, points, n) : TS_ERROR;
	if (status == TS_OK) {
		status = distances(own, of.at, of.n, k);
		for (u32 i = 0; i < n && status == TS_OK; i++) distance[i] = own[of.place[i]];
		ts_neighbours_places_free(&of);
	}
	free(own);
	return status;
}
