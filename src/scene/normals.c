/* Planes through neighbourhoods, and one side for each connected part: along the edges of a minimum spanning forest,
 * whose weights are the angles between planes. The forest is Kruskal's, with weights rounded to 16 bits. */
#include "scene/normals.h"
#include <stdlib.h>
#include <string.h>
#include "scene/neighbours.h"
#include "scene/surfel.h"

enum { K = TS_NORMALS_NEIGHBOURS, SWEEPS = 10, WEIGHTS = 1 << 16 };
#define THIN 9.5367431640625e-7f /* 2^-20: relative to the variance along a line, less across it is rounding */

/* The normals of a cloud, and the edges from each point to its K nearest: TS_NONE where there are fewer. */
typedef struct {
	const ts_v3 *points;
	ts_v3 *normals;
	u32 n;
	u32 *first; /* edge of each weight, in `order` */
	u32 *near;
	u32 *order; /* edges by weight */
	u32 *link;  /* from a point towards the root of its tree: index << 1 | whether the point is turned against it */
	ts_stop *stop;
} cloud;

/* Columns of the covariance of the neighbours and the point itself, in units of `size`. */
static void add_covariance(ts_v3 column[3], const cloud *c, u32 i, const ts_neighbour *found, u32 m, f32 size)
{
	ts_v3 at[K + 1] = {{0.0f, 0.0f, 0.0f}}, mean = at[0];
	for (u32 j = 0; j < m; j++) {
		at[j + 1] = ts_scale(ts_sub(c->points[found[j].index], c->points[i]), 1.0f / size);
		mean = ts_add(mean, at[j + 1]);
	}
	mean = ts_scale(mean, 1.0f / (f32)(m + 1));
	for (u32 j = 0; j <= m; j++) {
		ts_v3 d = ts_sub(at[j], mean);
		column[0] = ts_mad(column[0], d, d.x);
		column[1] = ts_mad(column[1], d, d.y);
		column[2] = ts_mad(column[2], d, d.z);
	}
}

/* Perpendicular to the two longer columns when those are perpendicular: the covariance's eigenvectors. */
static ts_v3 normal_of(const cloud *c, u32 i, const ts_neighbour *found, u32 m)
{
	ts_v3 column[3] = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}}, none = column[0];
	f32 size = m > 0 ? ts_sqrt(found[m - 1].square) : 0.0f, length[3];
	if (!(size > 0.0f)) return none;
	add_covariance(column, c, i, found, m, size);
	bool is_turned = true;
	for (u32 sweep = 0; sweep < SWEEPS && is_turned; sweep++) {
		is_turned = false;
		for (u32 k = 0; k < 3; k++) is_turned |= ts_axes_straighten(&column[k], &column[(k + 1) % 3]);
	}
	for (u32 k = 0; k < 3; k++) length[k] = ts_length(column[k]);
	u32 least = length[0] < length[1] ? 0 : 1;
	if (length[2] < length[least]) least = 2;
	f32 a = length[(least + 1) % 3], b = length[(least + 2) % 3];
	if (!(ts_min(a, b) > THIN * ts_max(a, b))) return none;
	return ts_normalize(ts_cross(column[(least + 1) % 3], column[(least + 2) % 3]));
}

static ts_status fit_planes(cloud *c)
{
	ts_neighbours *tree = ts_neighbours_new(c->points, c->n);
	if (tree == NULL) return TS_ERROR;
#pragma omp parallel for num_threads((int)ts_threads_all()) schedule(dynamic, 1024)
	for (u32 i = 0; i < c->n; i++) {
		if (ts_stopped(c->stop)) continue;
		ts_neighbour found[K];
		u32 m = ts_neighbours_find(tree, i, K, found);
		c->normals[i] = normal_of(c, i, found, m);
		for (u32 j = 0; j < K; j++) c->near[i * K + j] = j < m ? found[j].index : TS_NONE;
	}
	ts_neighbours_free(tree);
	return ts_go_on();
}

static bool is_none(ts_v3 normal) { return normal.x == 0.0f && normal.y == 0.0f && normal.z == 0.0f; }

/* The weight of an edge; WEIGHTS: no edge. */
static u32 weight_of(const cloud *c, u32 edge)
{
	if (c->near[edge] == TS_NONE) return WEIGHTS;
	ts_v3 a = c->normals[edge / K], b = c->normals[c->near[edge]];
	if (is_none(a) || is_none(b)) return WEIGHTS;
	return (u32)((1.0f - ts_min(ts_abs(ts_dot(a, b)), 1.0f)) * (f32)(WEIGHTS - 1));
}

/* Sorts by weight, then index. Returns the number of edges. */
static u32 sort_edges(cloud *c)
{
	u32 *first = c->first;
	memset(first, 0, (WEIGHTS + 2) * sizeof *first);
	for (u32 e = 0; e < c->n * K && !ts_stopped(c->stop); e++) first[weight_of(c, e) + 1]++;
	if (ts_stopped(c->stop)) return 0;
	for (u32 w = 0; w < WEIGHTS; w++) first[w + 1] += first[w];
	u32 n = first[WEIGHTS];
	for (u32 e = 0; e < c->n * K && !ts_stopped(c->stop); e++) {
		u32 w = weight_of(c, e);
		if (w < WEIGHTS) c->order[first[w]++] = e;
	}
	return n;
}

/* root << 1 | whether i is turned against it. Halves the path. */
static u32 root_of(u32 *link, u32 i)
{
	u32 turned = 0;
	while (link[i] >> 1 != i) {
		link[i] = link[link[i] >> 1] ^ (link[i] & 1);
		turned ^= link[i] & 1;
		i = link[i] >> 1;
	}
	return i << 1 | turned;
}

/* Joins the trees of both ends, flattest edges first. */
static void grow_forest(cloud *c)
{
	for (u32 i = 0; i < c->n; i++) c->link[i] = i << 1;
	u32 n_edges = sort_edges(c);
	for (u32 k = 0; k < n_edges && !ts_stopped(c->stop); k++) {
		u32 e = c->order[k], i = e / K, j = c->near[e];
		u32 a = root_of(c->link, i), b = root_of(c->link, j);
		u32 turned = (ts_dot(c->normals[i], c->normals[j]) < 0.0f) ^ (a & 1) ^ (b & 1);
		u32 low = a < b ? a >> 1 : b >> 1, high = a < b ? b >> 1 : a >> 1;
		if (low != high) c->link[high] = low << 1 | turned;
	}
}

static bool is_down(ts_v3 n) { return n.y < 0.0f || (n.y == 0.0f && (n.x < 0.0f || (n.x == 0.0f && n.z < 0.0f))); }

/* Turns points that are turned against their root; or all others, where the highest point would then point down. */
static void choose_sides(cloud *c)
{
	u32 *top = c->order; /* the highest point of each root's tree, then whether the root is to be turned */
	for (u32 i = 0; i < c->n; i++) top[i] = TS_NONE;
	for (u32 i = 0; i < c->n && !ts_stopped(c->stop); i++) {
		u32 root = root_of(c->link, i) >> 1;
		if (top[root] == TS_NONE || c->points[i].y > c->points[top[root]].y) top[root] = i;
	}
	for (u32 i = 0; i < c->n && !ts_stopped(c->stop); i++)
		if (top[i] != TS_NONE) top[i] = is_down(c->normals[top[i]]) ^ (root_of(c->link, top[i]) & 1);
	for (u32 i = 0; i < c->n && !ts_stopped(c->stop); i++) {
		u32 root = root_of(c->link, i);
		if ((root & 1) != top[root >> 1]) c->normals[i] = ts_sub(ts_v3_make(0.0f, 0.0f, 0.0f), c->normals[i]);
	}
}

/* The normals of a closed surface cancel out. */
static ts_status find_open(u8 *guessed, cloud *c)
{
	ts_v3 *sum = ts_alloc_zero(c->n, sizeof *sum, "sums of normals");
	u32 *count = ts_alloc_zero(c->n, sizeof *count, "sums of normals");
	for (u32 i = 0; i < c->n && sum != NULL && count != NULL && !ts_stopped(c->stop); i++) {
		u32 root = root_of(c->link, i) >> 1;
		sum[root] = ts_add(sum[root], c->normals[i]);
		count[root]++;
	}
	for (u32 i = 0; i < c->n && sum != NULL && count != NULL && !ts_stopped(c->stop); i++) {
		u32 root = root_of(c->link, i) >> 1;
		guessed[i] = ts_length(sum[root]) * 8.0f > (f32)count[root];
	}
	ts_status status = sum != NULL && count != NULL ? TS_OK : TS_ERROR;
	free(sum);
	free(count);
	return status;
}

static ts_status estimate(ts_v3 *normals, u8 *guessed, const ts_v3 *points, u32 n)
{
	u32 *memory = ts_alloc((u64)n * (2 * K + 1) + WEIGHTS + 2, sizeof *memory, "normals of points");
	if (memory == NULL) return TS_ERROR;
	cloud c = {.points = points, .normals = normals, .n = n, .first = memory, .stop = ts_stop_here()};
	c.near = c.first + WEIGHTS + 2;
	c.order = c.near + (size_t)n * K;
	c.link = c.order + (size_t)n * K;
	ts_status status = fit_planes(&c);
	if (status == TS_OK) {
		grow_forest(&c);
		choose_sides(&c);
		status = find_open(guessed, &c);
		if (status == TS_OK) status = ts_go_on();
	}
	free(memory);
	return status;
}

ts_status ts_normals_estimate(ts_v3 *normals, u8 *guessed, const ts_v3 *points, u32 n)
{
	ts_places_of of;
	if (ts_neighbours_places(&of, points, n) != TS_OK) return TS_ERROR;
	ts_v3 *own = ts_alloc(of.n, sizeof *own, "normals of points");
	u8 *open = ts_alloc(of.n, 1, "normals of points");
	ts_status status = own != NULL && open != NULL ? estimate(own, open, of.at, of.n) : TS_ERROR;
	for (u32 i = 0; i < n && status == TS_OK; i++) {
		normals[i] = own[of.place[i]];
		if (guessed != NULL) guessed[i] = open[of.place[i]];
	}
	free(own);
	free(open);
	ts_neighbours_places_free(&of);
	return status;
}
