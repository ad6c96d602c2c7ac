/* Fast path of the splat kernels, with the same bits: a thread owns a cube face, so there are no atomics; pieces and
 * points go side by side, as many as a cache holds into all faces of some cubes; rows beside a face are left out. Where
 * pixels tell which texels they read, the others stay empty, and what would touch those alone is left out. */
#include <omp.h>
#include <stdlib.h>
#include <string.h>
#include "../../fast.h"
#include "asked_texels.h"
#include "splat_extent.h"

enum { LANES = TS_SPLAT_LANES, POINTS = TS_SPLAT_POINTS, ROOM = TS_SPLAT_ROOM };

/* A thread takes that many cubes at once, and live pieces of about so many points, in clusters. */
enum { MOST_CUBES = 8, PART_PIECES = 1024, PART_POINTS = 16384, CLUSTER = 32 };

/* Live pieces one after another. */
typedef struct {
	ts_splat_bounds points;
	ts_splat_reach reach;
} cluster;

typedef struct {
	const ts_splat_args *args;
	ts_splat_live live;
	ts_asked asked;
	f32 *centre[3];          /* of stored points; NULL: they are made */
	ts_splat_bounds *bounds; /* of each POINTS stored ones */
	cluster *clusters;
} job;

/* What a thread works with. */
typedef struct {
	u8 faces[MOST_CUBES][PART_PIECES + CLUSTER]; /* of each cube, that may see each piece of a part */
	ts_splat_face face;
	ts_asked_face asked; /* of the face */
	ts_splat_batch batch;
	ts_splat_block block;
	f32 made[3][ROOM];
} worker;

/* How rows of a piece's points go. */
typedef struct {
	u32 k;      /* of the batch */
	bool owned; /* the block is its own */
	const ts_lines *lines;
} way;

static bool is_inside(ts_box box, const ts_lines *lines)
{
	return ts_k_inside_lines(lines, box.x0, box.y0) && ts_k_inside_lines(lines, box.x1, box.y0) &&
	       ts_k_inside_lines(lines, box.x0, box.y1) && ts_k_inside_lines(lines, box.x1, box.y1);
}

static void splat_owned_row(const job *j, worker *w, const way *of, ts_splat_row row)
{
	ts_splat_bounds made;
	ts_splat_reach reach = ts_splat_reach_of(&j->live, w->batch.live[of->k]);
	const ts_splat_bounds *points = j->bounds != NULL ? &j->bounds[row.index / POINTS] : &made;
	if (j->bounds == NULL) made = ts_splat_bounds_of(row.centre, row.n);
	ts_splat_extent e = ts_splat_extent_of(&w->face, points, &reach);
	if (ts_splat_is_beside(&w->face, &e)) return;
	ts_box box = ts_splat_extent_box(&w->face, &e);
	if (!ts_asked_any(&w->asked, box)) return;
	bool cut = of->lines != NULL && !is_inside(box, of->lines);
	ts_splat_block_row(&w->block, &w->face, &j->live, row, cut ? of->lines : NULL);
}

static void splat_row(const job *j, worker *w, const way *of, ts_splat_row row)
{
	if (of->owned) {
		splat_owned_row(j, w, of, row);
	} else {
		ts_splat_block_add(&w->block, &w->face, &j->live, &w->batch, of->k, row);
	}
}

/* Rows end where bounds do. */
static void splat_stored(const job *j, worker *w, const way *of, u32 begin, u32 end)
{
	for (u32 at = begin, next; at < end; at = next) {
		next = (at / POINTS + 1) * POINTS;
		next = next < end ? next : end;
		splat_row(j, w, of, (ts_splat_row){{j->centre[0] + at, j->centre[1] + at, j->centre[2] + at}, at, next - at});
	}
}

static void splat_made(const job *j, worker *w, const way *of, u32 piece)
{
	const ts_points_args *from = &j->args->from;
	ts_flight point = ts_k_flight_of_piece(from, piece);
	ts_cover cover = ts_k_lattice_cover(&from->frames[piece], from->half_size);
	ts_splat_row row = {{w->made[0], w->made[1], w->made[2]}, from->offset[piece], 0};
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(from, &cover, piece, x, y)) continue;
			ts_k_flight_start(from, &point, x, y);
			for (u32 axis = 0; axis < 3; axis++) w->made[axis][row.n] = ts_k_along(point.centre, axis);
			if (++row.n < POINTS) continue;
			splat_row(j, w, of, row);
			row.index += row.n;
			row.n = 0;
		}
	}
	if (row.n > 0) splat_row(j, w, of, row);
}

/* Its points go into the block beside others'. */
static void splat_points(const job *j, worker *w, const way *of)
{
	u32 piece = j->live.piece[w->batch.live[of->k]];
	const u32 *offset = j->args->from.offset;
	if (j->bounds != NULL) {
		splat_stored(j, w, of, offset[piece], offset[piece + 1]);
	} else {
		splat_made(j, w, of, piece);
	}
}

/* Many points, and those of which lines tell the texels, have the block for themselves. */
static void splat_together(const job *j, worker *w, u32 k, u32 n, const ts_lines *lines)
{
	way of = {k, n >= POINTS || lines != NULL, lines};
	if (of.owned) {
		ts_splat_block_write(&w->block, &w->face, &j->live);
		ts_splat_block_own(&w->block, &w->batch, k, n < POINTS ? n : POINTS);
	}
	splat_points(j, w, &of);
}

/* A piece that a plane clips, or that is too large, or of which each texel has a depth of its own. */
static void splat_alone(const job *j, worker *w, u32 k, u32 n)
{
	u32 at = w->batch.live[k];
	const ts_splat_face *f = &w->face;
	ts_cover cover = ts_k_splat_triangle(&f->view, &j->args->from.pieces[j->live.piece[at]]);
	if (cover.n == 0) return;
	w->face.scatters += n;
	ts_box box = ts_k_view_box(&f->view);
	if (j->args->clip != 0 || j->live.tiny[at] != 0) box = ts_k_box_meet(box, cover.touched);
	if (box.x1 < box.x0 || box.y1 < box.y0) return;
	if (!ts_asked_any(&w->asked, box)) return;
	ts_lines lines = {.n = 0};
	if (j->args->clip != 0) ts_k_lines(&lines, &cover);
	bool edges = ts_splat_batch_box(&w->batch, k, box, &lines) && j->args->plane_depth == 0;
	splat_together(j, w, k, n, edges ? NULL : &lines);
}

static void splat_piece(const job *j, worker *w, u32 k)
{
	const u32 *offset = j->args->from.offset;
	u32 piece = j->live.piece[w->batch.live[k]], n = offset[piece + 1] - offset[piece];
	if (w->batch.way[k] == TS_SPLAT_ALONE) {
		splat_alone(j, w, k, n);
		return;
	}
	w->face.scatters += n;
	if (w->batch.way[k] == TS_SPLAT_UNSEEN || !ts_asked_any(&w->asked, ts_splat_batch_box_of(&w->batch, k))) return;
	splat_together(j, w, k, n, NULL);
}

static void splat_batch(const job *j, worker *w)
{
	if (w->batch.n == 0) return;
	ts_splat_batch_place(&w->batch, &w->face, &j->live);
	for (u32 k = 0; k < w->batch.n; k++) splat_piece(j, w, k);
	w->batch.n = 0;
}

/* Cubes, and which of their faces. */
typedef struct {
	u32 first, n, faces;
} task;

/* Live pieces. */
typedef struct {
	u64 begin, end;
} part;

#define EIGHT 0x0101010101010101u /* the same bit of eight bytes */

static void find_faces(const job *j, worker *w, const task *t, part p)
{
	for (u32 k = 0; k < t->n; k++) memset(w->faces[k] + (p.end - p.begin) / CLUSTER * CLUSTER, 0, CLUSTER);
	for (u64 i = p.begin; i < p.end; i++) {
		const u64 *words = j->args->bits + (u64)j->live.triangle[i] * j->args->n_words;
		for (u32 k = 0; k < t->n; k++) w->faces[k][i - p.begin] = (u8)(ts_k_cube_bits(words, t->first + k) & t->faces);
	}
}

/* No texel that splats of the cluster may touch is asked for. */
static bool is_unasked(const job *j, const worker *w, u64 begin)
{
	if (j->clusters == NULL) return false;
	const cluster *c = &j->clusters[begin / CLUSTER];
	ts_splat_extent e = ts_splat_extent_of(&w->face, &c->points, &c->reach);
	return ts_splat_is_beside(&w->face, &e) || !ts_asked_any(&w->asked, ts_splat_extent_box(&w->face, &e));
}

/* Eight pieces at once, most of which the face does not see. */
static void splat_cluster(const job *j, worker *w, const u8 *faces, u64 begin)
{
	u64 eight[CLUSTER / 8], any = 0;
	memcpy(eight, faces, sizeof eight);
	for (u32 k = 0; k < CLUSTER / 8; k++) any |= eight[k] = eight[k] >> w->face.side & EIGHT;
	if (any == 0 || is_unasked(j, w, begin)) return;
	for (u32 k = 0; k < CLUSTER / 8; k++) {
		for (u64 bits = eight[k]; bits != 0; bits &= bits - 1) {
			w->batch.live[w->batch.n++] = (u32)begin + k * 8 + (u32)__builtin_ctzll(bits) / 8;
			if (w->batch.n == TS_SPLAT_PIECES) splat_batch(j, w);
		}
	}
}

static void splat_face(const job *j, worker *w, const u8 *faces, part p)
{
	for (u64 at = p.begin; at < p.end; at += CLUSTER) splat_cluster(j, w, faces + (at - p.begin), at);
	splat_batch(j, w);
	ts_splat_block_write(&w->block, &w->face, &j->live);
	ts_add_i64(j->args->n_scatters, w->face.scatters);
	ts_add_i64(j->args->n_writes, w->face.writes);
}

static void splat_part(const job *j, worker *w, const task *t, part p)
{
	find_faces(j, w, t, p);
	for (u32 k = 0; k < t->n; k++) {
		for (u32 side = 0; side < 6 && j->args->cubes[t->first + k].n != 0; side++) {
			if ((t->faces >> side & 1) == 0) continue;
			w->face = ts_splat_face_begin(j->args, t->first + k, side);
			w->asked = ts_asked_face_of(&j->asked, j->args->cubes, t->first + k, side);
			splat_face(j, w, w->faces[k], p);
		}
	}
}

static u64 cluster_end(const job *j, u64 begin) { return begin + CLUSTER < j->live.n ? begin + CLUSTER : j->live.n; }

/* Points of live pieces from one to before another. */
static u32 points_of(const job *j, u64 begin, u64 end)
{
	const u32 *offset = j->args->from.offset, *piece = j->live.piece;
	return offset[piece[end - 1] + 1] - offset[piece[begin]];
}

/* Whole clusters. */
static u64 part_end(const job *j, u64 begin)
{
	u64 end = cluster_end(j, begin);
	while (end < j->live.n && end - begin < PART_PIECES && points_of(j, begin, cluster_end(j, end)) <= PART_POINTS)
		end = cluster_end(j, end);
	return end;
}

static void splat_task(const job *j, worker *w, const task *t)
{
	part p = {0, 0};
	for (; p.begin < j->live.n; p.begin = p.end) {
		p.end = part_end(j, p.begin);
		splat_part(j, w, t, p);
	}
}

/* Threads take cubes where there are enough, otherwise faces. */
static void splat_all(const job *j, worker *workers, u32 threads)
{
	u32 n_cubes = j->args->n_cubes, most = n_cubes / (4 * threads);
	u32 n = most > MOST_CUBES ? MOST_CUBES : most; /* 0: a face */
	i64 n_tasks = n > 0 ? (n_cubes + n - 1) / n : (i64)n_cubes * 6;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (i64 i = 0; i < n_tasks; i++) {
		u32 first = n > 0 ? (u32)i * n : (u32)i / 6, left = n_cubes - first;
		task t = {first, n > 0 ? (left < n ? left : n) : 1, n > 0 ? 63 : 1u << i % 6};
		splat_task(j, &workers[omp_get_thread_num()], &t);
	}
}

static void take_bounds(job *j, u32 of, u32 n)
{
	u32 begin = of * POINTS, end = begin + POINTS < n ? begin + POINTS : n;
	for (u32 i = begin; i < end; i++) {
		for (u32 axis = 0; axis < 3; axis++) j->centre[axis][i] = j->args->from.points[i].centre[axis];
	}
	const f32 *const centre[3] = {j->centre[0] + begin, j->centre[1] + begin, j->centre[2] + begin};
	j->bounds[of] = ts_splat_bounds_of(centre, end - begin);
}

/* Coordinates of the stored points, apart, and their bounds. */
static bool take_centres(job *j, u32 threads)
{
	u32 n = j->args->from.offset[j->args->n_pieces], n_bounds = (n + POINTS - 1) / POINTS;
	size_t room = (size_t)n + ROOM;
	f32 *centre = ts_alloc(3 * room, sizeof *centre, "coordinates of points");
	j->bounds = ts_alloc(n_bounds, sizeof *j->bounds, "bounds of points");
	for (u32 axis = 0; centre != NULL && axis < 3; axis++) {
		j->centre[axis] = centre + axis * room;
		memset(j->centre[axis] + n, 0, ROOM * sizeof *centre);
	}
	if (centre == NULL || j->bounds == NULL) return false;
#pragma omp parallel for num_threads(threads)
	for (i64 i = 0; i < (i64)n_bounds; i++) take_bounds(j, (u32)i, n);
	return true;
}

static cluster cluster_of(const job *j, u64 begin, u64 end)
{
	const u32 *offset = j->args->from.offset, *piece = j->live.piece;
	u32 first = offset[piece[begin]] / POINTS, last = (offset[piece[end - 1] + 1] - 1) / POINTS;
	cluster c = {j->bounds[first], ts_splat_reach_of(&j->live, begin)};
	for (u32 k = first + 1; k <= last; k++) ts_splat_bounds_add(&c.points, &j->bounds[k]);
	for (u64 i = begin + 1; i < end; i++) {
		ts_splat_reach reach = ts_splat_reach_of(&j->live, i);
		for (u32 axis = 0; axis < 3; axis++) c.reach.along[axis] = ts_max(c.reach.along[axis], reach.along[axis]);
	}
	return c;
}

static bool make_clusters(job *j, u32 threads)
{
	u64 n = (j->live.n + CLUSTER - 1) / CLUSTER;
	j->clusters = ts_alloc(n, sizeof *j->clusters, "clusters of pieces");
	if (j->clusters == NULL) return false;
#pragma omp parallel for num_threads(threads)
	for (i64 i = 0; i < (i64)n; i++) j->clusters[i] = cluster_of(j, (u64)i * CLUSTER, cluster_end(j, (u64)i * CLUSTER));
	return true;
}

static bool ask(job *j, u32 threads)
{
	return j->args->pixels == NULL || (ts_asked_make(&j->asked, j->args, threads) && make_clusters(j, threads));
}

static bool splat(const ts_splat_args *args, bool stored, u32 threads)
{
	if (args->from.offset == NULL || args->mark != 0) return false;
	job j = {.args = args};
	bool made = ts_splat_live_make(&j.live, args, threads) && (!stored || take_centres(&j, threads));
	made = made && ask(&j, threads);
	worker *workers = made ? calloc(threads, sizeof *workers) : NULL;
	ts_asked_close(&j.asked, args->texels, threads);
	if (workers != NULL) splat_all(&j, workers, threads);
	ts_asked_open(&j.asked, args->texels, threads);
	ts_asked_clear(&j.asked);
	free(workers);
	free(j.centre[0]);
	free(j.bounds);
	free(j.clusters);
	ts_splat_live_clear(&j.live);
	return workers != NULL;
}

/* Points that stand by piece, and nothing to mark. */
bool ts_c_fast_splat(const void *of, u64 n, u32 threads)
{
	(void)n;
	return splat(of, true, threads);
}

bool ts_c_fast_splat_fragments(const void *of, u64 n, u32 threads)
{
	(void)n;
	return splat(of, false, threads);
}
