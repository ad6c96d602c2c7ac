/* Fast path of the splat kernels, with the same bits: a thread owns a cube face, so there are no atomics. Rows of
 * points are processed side by side, as many as a cache holds, into all faces of a cube; rows beside a face are left
 * out. Where pixels list the texels they read, the others stay empty. Splats that touch only those, or are hidden, are
 * left out: near rows come first. Ties are looked for in the same way, and hidden splats have none. */
#include <omp.h>
#include <stdlib.h>
#include <string.h>
#include "backends/c/points/asked_texels.h"
#include "backends/c/points/splat_sieve.h"
#include "backends/fast.h"
#include "model/core.h"
#include "model/order.h"

enum { LANES = TS_SPLAT_LANES, POINTS = TS_SPLAT_POINTS, ROOM = TS_SPLAT_ROOM };

/* Cubes per thread; rows and points of each that are taken at once, about; rows per cluster. */
enum { MOST_CUBES = 10, MANY_CUBES = 16, PART_ROWS = 1024, PART_POINTS = 16384, CLUSTER = 32 };

/* Clusters are in order of distance, in bins that have one exponent and the first bits of the fraction. */
enum { BIN_SHIFT = 20, BINS = 1 << (31 - BIN_SHIFT) };

/* Rows whose bits are prefetched: those of neighbours are a cache line or more apart. */
enum { AHEAD = 24 };

/* Points from which a block pays, and points of a row from which its bounds are looked at first. */
enum { MANY = POINTS / 2, SOME = 32 };

/* Largest boxes of clusters and of rows, in texels, that are searched. */
enum { MOST_TEXELS = 4096, MOST_ROW_TEXELS = 512 };

/* Rows one after another. */
typedef struct {
	ts_splat_bounds points;
	ts_splat_reach reach;
} cluster;

typedef struct {
	const ts_splat_args *args;
	ts_splat_live live;
	ts_asked asked;
	u64 n_clusters;
	cluster *clusters; /* NULL: every write counts */
	bool sieves;
	u32 *order; /* of clusters, per thread */
	u8 *faces;  /* of a task's cubes, per thread */
	ts_stop *stop;
} job;

/* Cubes, and the faces to draw. */
typedef struct {
	u32 first, n, faces;
} task;

/* What a thread works with. */
typedef struct {
	task found;            /* whose cubes' faces were found */
	u8 *faces[MOST_CUBES]; /* of each cube of a task, that may see each row */
	ts_splat_face face;
	ts_asked_face asked; /* of the face */
	ts_splat_batch batch;
	ts_splat_block block;
	ts_splat_sieve sieve;
	f32 made[3][ROOM];
	u32 *order; /* of clusters, as `from` sees them */
	const ts_face *from;
	u32 owner; /* the piece that has the block for itself, or TS_NONE */
} worker;

/* How a row is drawn. */
typedef struct {
	u32 k;      /* of the batch */
	bool owned; /* the block is its own */
	const ts_lines *lines;
} way;

static u32 points_of(const job *j, u32 row) { return ts_splat_live_points(&j->live, row, (u64)row + 1); }

static bool is_inside(ts_box box, const ts_lines *lines)
{
	return ts_k_inside_lines(lines, box.x0, box.y0) && ts_k_inside_lines(lines, box.x1, box.y0) &&
	       ts_k_inside_lines(lines, box.x0, box.y1) && ts_k_inside_lines(lines, box.x1, box.y1);
}

/* Texels that a row's splats may touch, of those that their piece may write. False: none. */
static bool row_box(ts_box *box, const job *j, const worker *w, u32 k, const ts_splat_bounds *points)
{
	ts_splat_reach reach = ts_splat_reach_of(&j->live, w->batch.live[k]);
	ts_splat_extent e = ts_splat_extent_of(&w->face, points, &reach);
	if (ts_splat_is_beside(&w->face, &e)) return false;
	*box = ts_k_box_meet(ts_splat_extent_box(&w->face, &e), *box);
	return box->x0 <= box->x1 && box->y0 <= box->y1;
}

/* No texel of the box can change: none is asked for, or all hold nearer points. */
static bool is_box_needless(const job *j, const worker *w, ts_box box, const ts_splat_bounds *points)
{
	if (!ts_asked_any(&w->asked, box)) return true;
	return j->args->plane_depth == 0 && ts_splat_is_hidden(&w->face, box, points);
}

/* No texel that the splats may touch can change. */
static bool is_needless(const job *j, const worker *w, const cluster *c, i64 most_texels)
{
	ts_splat_extent e = ts_splat_extent_of(&w->face, &c->points, &c->reach);
	if (ts_splat_is_beside(&w->face, &e)) return true;
	ts_box box = ts_splat_extent_box(&w->face, &e);
	if ((i64)(box.x1 - box.x0) * (box.y1 - box.y0) > most_texels) return !ts_asked_any(&w->asked, box);
	return is_box_needless(j, w, box, &c->points);
}

static cluster row_alone(const job *j, u32 row)
{
	return (cluster){j->live.bounds[row], ts_splat_reach_of(&j->live, row)};
}

static void own_block(const job *j, worker *w, u32 k)
{
	u32 piece = j->live.piece[w->batch.live[k]];
	if (w->owner == piece) return;
	ts_splat_block_write(&w->block, &w->face, &j->live);
	ts_splat_block_own(&w->block, &w->face, &j->live, &w->batch, k);
	w->owner = piece;
}

static void splat_owned_row(const job *j, worker *w, const way *of, ts_splat_row row, const ts_splat_bounds *points)
{
	ts_box box = ts_splat_batch_box_of(&w->batch, of->k);
	bool cut = of->lines != NULL;
	if ((cut || !j->sieves) && !row_box(&box, j, w, of->k, points)) return;
	cut = cut && !is_inside(box, of->lines);
	own_block(j, w, of->k);
	ts_splat_block_row(&w->block, &w->face, &j->live, row, cut ? of->lines : NULL);
}

static void splat_row(const job *j, worker *w, const way *of, ts_splat_row row, const ts_splat_bounds *points)
{
	if (of->owned) {
		splat_owned_row(j, w, of, row, points);
	} else {
		w->owner = TS_NONE;
		ts_splat_block_add(&w->block, &w->face, &j->live, &w->batch, of->k, row);
	}
}

static void splat_stored(const job *j, worker *w, const way *of)
{
	const ts_splat_live *live = &j->live;
	u32 i = w->batch.live[of->k], at = live->index[i];
	ts_splat_row row = {{live->centre[0] + at, live->centre[1] + at, live->centre[2] + at}, at, points_of(j, i), NULL};
	splat_row(j, w, of, row, &live->bounds[i]);
}

static void splat_sieved(const job *j, worker *w, const way *of)
{
	const ts_splat_sieve *s = &w->sieve;
	u32 at = w->batch.begin[of->k];
	ts_splat_row row = {
		{s->centre[0] + at, s->centre[1] + at, s->centre[2] + at}, 0, w->batch.left[of->k], s->index + at};
	splat_row(j, w, of, row, &j->live.bounds[w->batch.live[of->k]]);
}

static void splat_made_row(const job *j, worker *w, const way *of, ts_splat_row row)
{
	ts_splat_bounds points = ts_splat_bounds_of(row.centre, row.n);
	splat_row(j, w, of, row, &points);
}

static void splat_made(const job *j, worker *w, const way *of)
{
	const ts_points_args *from = &j->args->from;
	u32 piece = j->live.piece[w->batch.live[of->k]];
	ts_flight point = ts_k_flight_of_piece(from, piece);
	ts_cover cover = ts_k_lattice_cover(&from->frames[piece], from->half_size);
	ts_splat_row row = {{w->made[0], w->made[1], w->made[2]}, from->offset[piece], 0, NULL};
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(from, &cover, piece, x, y)) continue;
			ts_k_flight_start(from, &point, x, y);
			for (u32 axis = 0; axis < 3; axis++) w->made[axis][row.n] = ts_k_along(point.centre, axis);
			if (++row.n < POINTS) continue;
			splat_made_row(j, w, of, row);
			row.index += row.n;
			row.n = 0;
		}
	}
	if (row.n > 0) splat_made_row(j, w, of, row);
}

/* Rows with many points or with lines have the block for themselves. */
static void splat_together(const job *j, worker *w, u32 k, const ts_lines *lines)
{
	bool sieved = w->batch.left[k] != TS_NONE;
	u32 n = sieved ? w->batch.left[k] : points_of(j, w->batch.live[k]);
	way of = {k, n >= MANY || lines != NULL, lines};
	if (sieved) {
		splat_sieved(j, w, &of);
	} else if (j->live.bounds != NULL) {
		splat_stored(j, w, &of);
	} else {
		splat_made(j, w, &of);
	}
}

/* A piece that a plane clips, that is too large, or whose texels have depths of their own. */
static void splat_alone(const job *j, worker *w, u32 k)
{
	u32 at = w->batch.live[k];
	const ts_splat_face *f = &w->face;
	ts_box box = ts_k_view_box(&f->view);
	if (j->clusters != NULL && w->batch.left[k] == TS_NONE) {
		cluster row = row_alone(j, at);
		if (is_needless(j, w, &row, MOST_ROW_TEXELS)) return;
	}
	ts_cover cover = ts_k_splat_triangle(&f->view, &j->args->from.pieces[j->live.piece[at]]);
	if (cover.n == 0) return;
	w->face.scatters += points_of(j, at);
	if (j->args->clip != 0 || j->live.tiny[at] != 0) box = ts_k_box_meet(box, cover.touched);
	if (box.x1 < box.x0 || box.y1 < box.y0) return;
	ts_lines lines = {.n = 0};
	if (j->args->clip != 0) ts_k_lines(&lines, &cover);
	bool edges = ts_splat_batch_box(&w->batch, k, box, &lines) && j->args->plane_depth == 0;
	splat_together(j, w, k, edges ? NULL : &lines);
}

static void splat_piece(const job *j, worker *w, u32 k)
{
	if (w->batch.way[k] == TS_SPLAT_ALONE) {
		splat_alone(j, w, k);
		return;
	}
	u32 at = w->batch.live[k];
	w->face.scatters += points_of(j, at);
	if (w->batch.way[k] == TS_SPLAT_UNSEEN) return;
	bool few = j->sieves && w->batch.left[k] == TS_NONE;
	if (few && is_box_needless(j, w, ts_splat_batch_box_of(&w->batch, k), &j->live.bounds[at])) return;
	splat_together(j, w, k, NULL);
}

static void splat_batch(const job *j, worker *w)
{
	if (w->batch.n == 0) return;
	ts_splat_batch_place(&w->batch, &w->face, &j->live);
	for (u32 k = 0; k < w->batch.n; k++) splat_piece(j, w, k);
	w->batch.n = 0;
	w->sieve.n = 0;
}

/* Clusters, in the worker's order. */
typedef struct {
	u64 begin, end;
} part;

#define EIGHT 0x0101010101010101u /* the same bit in eight bytes */

static u64 cluster_end(const job *j, u64 begin) { return begin + CLUSTER < j->live.n ? begin + CLUSTER : j->live.n; }

static const u64 *words_of(const job *j, u64 row)
{
	return j->args->bits + (u64)j->live.triangle[row] * j->args->n_words;
}

/* ts_k_cube_bits of MOST_CUBES cubes from `cube` on, six bits each. */
static u64 bits_from(const u64 *words, u32 n_words, u32 cube)
{
	u32 word = cube * 6 / 64, shift = cube * 6 % 64;
	u64 bits = words[word] >> shift;
	return shift != 0 && word + 1 < n_words ? bits | words[word + 1] << (64 - shift) : bits;
}

/* Rows beyond the last one get no faces. */
static void find_faces(const job *j, worker *w, const task *t)
{
	for (u64 i = 0; i < j->live.n; i++) {
		if (i + AHEAD < j->live.n) __builtin_prefetch(words_of(j, i + AHEAD) + t->first * 6 / 64);
		u64 bits = bits_from(words_of(j, i), j->args->n_words, t->first);
		for (u32 k = 0; k < t->n; k++, bits >>= 6) w->faces[k][i] = (u8)(bits & 63);
	}
	w->found = *t;
}

/* Whether a row may change a texel; what is left of a large one is in the sieve. */
static bool is_left(const job *j, worker *w, u32 row)
{
	u32 k = w->batch.n;
	w->batch.left[k] = TS_NONE;
	if (!j->sieves || points_of(j, row) < SOME) return true;
	cluster alone = row_alone(j, row);
	if (is_needless(j, w, &alone, MOST_ROW_TEXELS)) return false;
	w->batch.begin[k] = w->sieve.n;
	w->batch.left[k] = ts_splat_sieve_add(&w->sieve, &w->face, &j->live, row, &alone.reach);
	return w->batch.left[k] > 0;
}

/* Takes eight rows at once, most of which the face does not see. */
static void splat_cluster(const job *j, worker *w, const u8 *faces, u64 of)
{
	for (u32 k = 0; k < CLUSTER / 8; k++) {
		for (u64 bits = ts_order_read(faces + 8 * k, 8) >> w->face.side & EIGHT; bits != 0; bits &= bits - 1) {
			u32 row = (u32)of * CLUSTER + k * 8 + (u32)__builtin_ctzll(bits) / 8;
			if (!is_left(j, w, row)) continue;
			w->batch.live[w->batch.n++] = row;
			if (w->batch.n == TS_SPLAT_PIECES || w->sieve.n > TS_SIEVE_POINTS) splat_batch(j, w);
		}
	}
}

/* The faces that may see any row of a cluster. */
static u8 any_face(const u8 *faces)
{
	u64 eight[CLUSTER / 8], any = 0;
	memcpy(eight, faces, sizeof eight);
	for (u32 k = 0; k < CLUSTER / 8; k++) any |= eight[k];
	any |= any >> 32;
	any |= any >> 16;
	return (u8)(any | any >> 8);
}

static void splat_face(const job *j, worker *w, const u8 *faces, const u8 *any, part p)
{
	w->owner = TS_NONE;
	for (u64 c = p.begin; c < p.end && !ts_stopped(j->stop); c++) {
		u64 of = w->order[c];
		if ((any[c - p.begin] >> w->face.side & 1) == 0) continue;
		if (j->clusters != NULL && is_needless(j, w, &j->clusters[of], MOST_TEXELS)) continue;
		splat_cluster(j, w, faces + of * CLUSTER, of);
	}
	splat_batch(j, w);
	ts_splat_block_write(&w->block, &w->face, &j->live);
	ts_add_i64(j->args->n_scatters, w->face.scatters);
	ts_add_i64(j->args->n_writes, w->face.writes);
}

static void splat_part(const job *j, worker *w, u32 cube, u32 sides, const u8 *faces, part p)
{
	u8 any[PART_ROWS / CLUSTER];
	for (u64 c = p.begin; c < p.end; c++) any[c - p.begin] = any_face(faces + (u64)w->order[c] * CLUSTER);
	for (u32 side = 0; side < 6; side++) {
		if ((sides >> side & 1) == 0) continue;
		w->face = ts_splat_face_begin(j->args, cube, side);
		w->asked = ts_asked_face_of(&j->asked, j->args->cubes, cube, side);
		splat_face(j, w, faces, any, p);
	}
}

static u64 part_end(const job *j, const worker *w, u64 begin)
{
	u64 end = begin, n = 0;
	for (; end < j->n_clusters && (end - begin) < PART_ROWS / CLUSTER && n < PART_POINTS; end++) {
		u64 first = (u64)w->order[end] * CLUSTER;
		n += ts_splat_live_points(&j->live, first, cluster_end(j, first));
	}
	return end;
}

static u32 bin_of(const job *j, ts_v3 eye, u64 of)
{
	f32 d = ts_splat_nearest(eye, &j->clusters[of].points);
	return ts_f2u(d) >> BIN_SHIFT;
}

/* Near clusters first, where some may hide others. */
static void find_order(const job *j, worker *w, u32 cube)
{
	u32 begin[BINS + 1] = {0};
	ts_v3 eye = ts_load3(j->args->cubes[cube].centre);
	if (w->from == &j->args->cubes[cube]) return;
	w->from = &j->args->cubes[cube];
	if (j->clusters == NULL) {
		for (u64 of = 0; of < j->n_clusters; of++) w->order[of] = (u32)of;
		return;
	}
	for (u64 of = 0; of < j->n_clusters; of++) begin[bin_of(j, eye, of) + 1]++;
	for (u32 bin = 0; bin < BINS; bin++) begin[bin + 1] += begin[bin];
	for (u64 of = 0; of < j->n_clusters; of++) w->order[begin[bin_of(j, eye, of)]++] = (u32)of;
}

static void splat_cube(const job *j, worker *w, u32 cube, u32 sides, const u8 *faces)
{
	part p = {0, 0};
	if (j->args->cubes[cube].n == 0) return;
	find_order(j, w, cube);
	for (; p.begin < j->n_clusters && !ts_stopped(j->stop); p.begin = p.end) {
		p.end = part_end(j, w, p.begin);
		splat_part(j, w, cube, sides, faces, p);
	}
}

static void splat_task(const job *j, worker *w, const task *t)
{
	if (t->first != w->found.first || t->n > w->found.n) find_faces(j, w, t);
	for (u32 k = 0; k < t->n; k++) splat_cube(j, w, t->first + k, t->faces, w->faces[k]);
}

/* Threads take whole cubes; where these are few, the last ones go face by face, so that threads end together. */
typedef struct {
	u32 n_whole, n_a_task;
	i64 n_tasks_of_whole, n;
} tasks;

static tasks tasks_of(u32 n_cubes, u32 threads)
{
	u32 n_whole = n_cubes >= MANY_CUBES * threads ? n_cubes : n_cubes > threads ? n_cubes - threads : 0;
	u32 most = n_whole / (4 * threads), n = most < 1 ? 1 : most > MOST_CUBES ? MOST_CUBES : most;
	tasks t = {n_whole, n, (n_whole + n - 1) / n, 0};
	t.n = t.n_tasks_of_whole + (i64)(n_cubes - n_whole) * 6;
	return t;
}

static task task_of(const tasks *of, i64 i)
{
	i64 face = i - of->n_tasks_of_whole;
	if (face >= 0) return (task){of->n_whole + (u32)(face / 6), 1, 1u << face % 6};
	u32 first = (u32)i * of->n_a_task, left = of->n_whole - first;
	return (task){first, left < of->n_a_task ? left : of->n_a_task, 63};
}

static void splat_all(const job *j, worker *workers, u32 threads)
{
	tasks all = tasks_of(j->args->n_cubes, threads);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (i64 i = 0; i < all.n; i++) {
		task t = task_of(&all, i);
		splat_task(j, &workers[omp_get_thread_num()], &t);
	}
}

static cluster cluster_of(const job *j, u64 begin, u64 end)
{
	cluster c = {j->live.bounds[begin], ts_splat_reach_of(&j->live, begin)};
	for (u64 i = begin + 1; i < end; i++) {
		ts_splat_reach reach = ts_splat_reach_of(&j->live, i);
		ts_splat_bounds_add(&c.points, &j->live.bounds[i]);
		for (u32 axis = 0; axis < 3; axis++) c.reach.along[axis] = ts_max(c.reach.along[axis], reach.along[axis]);
		c.reach.slack = ts_max(c.reach.slack, reach.slack);
	}
	return c;
}

static bool make_clusters(job *j, u32 threads)
{
	j->clusters = ts_alloc(j->n_clusters, sizeof *j->clusters, "clusters of points");
	if (j->clusters == NULL) return false;
#pragma omp parallel for num_threads(threads)
	for (i64 i = 0; i < (i64)j->n_clusters; i++) {
		if (ts_stopped(j->stop)) continue;
		j->clusters[i] = cluster_of(j, (u64)i * CLUSTER, cluster_end(j, (u64)i * CLUSTER));
	}
	return !ts_stopped(j->stop);
}

static bool ask(job *j, u32 threads)
{
	const ts_splat_args *args = j->args;
	if (j->live.bounds == NULL || (args->pixels == NULL && args->mark == 0)) return true;
	return (args->pixels == NULL || ts_asked_make(&j->asked, args, threads)) && make_clusters(j, threads);
}

static worker *make_workers(job *j, u32 threads)
{
	size_t n_faces = j->n_clusters * CLUSTER;
	worker *workers = ts_alloc_zero(threads, sizeof *workers, "threads that splat");
	j->order = ts_alloc(threads * j->n_clusters, sizeof *j->order, "orders of clusters");
	j->faces = ts_alloc_zero(threads * MOST_CUBES * n_faces, 1, "faces that see points");
	for (u32 k = 0; workers != NULL && k < threads; k++) {
		workers[k].order = j->order + k * j->n_clusters;
		for (u32 cube = 0; cube < MOST_CUBES; cube++)
			workers[k].faces[cube] = j->faces + (k * MOST_CUBES + cube) * n_faces;
	}
	return workers;
}

static bool splat(const ts_splat_args *args, u32 threads)
{
	if (args->from.offset == NULL) return false;
	job j = {.args = args, .stop = ts_stop_here()};
	bool made = ts_splat_live_make(&j.live, args, threads);
	j.n_clusters = (j.live.n + CLUSTER - 1) / CLUSTER;
	made = made && ask(&j, threads);
	worker *workers = made ? make_workers(&j, threads) : NULL;
	made = workers != NULL && j.order != NULL && j.faces != NULL;
	j.sieves = j.clusters != NULL && args->plane_depth == 0;
	if (made) {
		ts_asked_close(&j.asked, args->texels, threads);
		splat_all(&j, workers, threads);
		ts_asked_open(&j.asked, args->texels, threads);
	}
	ts_asked_clear(&j.asked);
	free(workers);
	free(j.order);
	free(j.faces);
	free(j.clusters);
	ts_splat_live_clear(&j.live);
	return made;
}

/* For points in order of piece. */
bool ts_c_fast_splat(const void *of, u64 n, u32 threads)
{
	(void)n;
	return splat(of, threads);
}

bool ts_c_fast_splat_fragments(const void *of, u64 n, u32 threads)
{
	(void)n;
	return splat(of, threads);
}

#include "backends/selftest.h"
