/* Fast path of the splat kernels, with the same bits: a thread owns a cube face, so there are no atomics; a cube's bits
 * are read once for all its faces; pieces and points go side by side, but for pieces that a plane clips. */
#include <omp.h>
#include <stdlib.h>
#include "../../fast.h"
#include "splat_batch.h"

enum { LANES = TS_SPLAT_LANES };

/* A piece with points. */
typedef struct {
	u32 piece, triangle, flags;
	f32 length;
} live;

/* A piece of `live`, and those faces of a cube that may see it. */
typedef struct {
	u32 live, faces;
} seen;

typedef struct {
	const ts_splat_args *args;
	live *pieces;
	u64 n_pieces;
	f32 *centre[3]; /* of stored points; NULL: they are made */
} job;

/* What a thread works with. */
typedef struct {
	seen *seen;
	ts_splat_face face;
	ts_splat_batch batch;
	ts_splat_block block;
} worker;

/* Points of a piece as they go together. */
static void splat_stored(const job *j, worker *w, u32 k, u32 begin, u32 n)
{
	const f32 *centre[3] = {j->centre[0] + begin, j->centre[1] + begin, j->centre[2] + begin};
	ts_splat_block_add(&w->block, &w->face, &w->batch, k, centre, begin, n);
}

static void splat_made(const job *j, worker *w, u32 k, u32 begin)
{
	const ts_points_args *from = &j->args->from;
	u64 piece = w->batch.piece[k];
	ts_flight point = ts_k_flight_of_piece(from, piece);
	ts_cover cover = ts_k_lattice_cover(&from->frames[piece], from->half_size);
	f32 made[3][LANES] = {{0}};
	const f32 *centre[3] = {made[0], made[1], made[2]};
	u32 n = 0;
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(from, &cover, piece, x, y)) continue;
			ts_k_flight_start(from, &point, x, y);
			for (u32 axis = 0; axis < 3; axis++) made[axis][n] = ts_k_along(point.centre, axis);
			if (++n < LANES) continue;
			ts_splat_block_add(&w->block, &w->face, &w->batch, k, centre, begin, n);
			begin += n;
			n = 0;
		}
	}
	ts_splat_block_add(&w->block, &w->face, &w->batch, k, centre, begin, n);
}

/* Pieces that a plane clips, point by point. */
static void splat_stored_alone(const job *j, ts_splat_face *f, u64 piece)
{
	const u32 *offset = j->args->from.offset;
	ts_piece_view view;
	if (!ts_k_piece_view(&view, j->args, piece, f->cube, f->side, &f->scatters)) return;
	for (u32 p = offset[piece]; p < offset[piece + 1]; p++) f->writes += ts_k_piece_point(j->args, &view, p);
}

static void splat_made_alone(const job *j, ts_splat_face *f, u64 piece)
{
	const ts_splat_args *args = j->args;
	const ts_points_args *from = &args->from;
	u64 first = (u64)(f->texels - args->texels);
	u32 index = from->offset[piece];
	ts_cover triangle = ts_k_splat_triangle(&f->view, &from->pieces[piece]);
	if (triangle.n == 0) return;
	f->scatters += from->offset[piece + 1] - index;
	ts_flight point = ts_k_flight_of_piece(from, piece);
	ts_cover cover = ts_k_lattice_cover(&from->frames[piece], from->half_size);
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(from, &cover, piece, x, y)) continue;
			ts_k_flight_start(from, &point, x, y);
			f->writes += ts_k_splat(args, &f->view, &triangle, &point, ts_k_splat_word(args, index++), first);
		}
	}
}

/* A piece of the batch. */
static void splat_piece(const job *j, worker *w, u32 k)
{
	const u32 *offset = j->args->from.offset;
	u32 piece = w->batch.piece[k], begin = offset[piece], n = offset[piece + 1] - begin;
	bool stored = j->centre[0] != NULL, alone = w->batch.way[k] == TS_SPLAT_ALONE;
	if (alone && stored) splat_stored_alone(j, &w->face, piece);
	if (alone && !stored) splat_made_alone(j, &w->face, piece);
	if (alone) return;
	w->face.scatters += n;
	if (w->batch.way[k] == TS_SPLAT_UNSEEN) return;
	if (stored) {
		splat_stored(j, w, k, begin, n);
	} else {
		splat_made(j, w, k, begin);
	}
}

static void splat_batch(const job *j, worker *w)
{
	ts_splat_batch_place(&w->batch, &w->face);
	for (u32 k = 0; k < w->batch.n; k++) splat_piece(j, w, k);
	w->batch.n = 0;
}

/* Returns how many pieces the faces may see. */
static u64 find_seen(const job *j, seen *to, u32 cube, u32 faces)
{
	u64 n = 0;
	for (u64 i = 0; i < j->n_pieces; i++) {
		u32 bits = ts_k_cube_bits(j->args->bits + (u64)j->pieces[i].triangle * j->args->n_words, cube) & faces;
		to[n] = (seen){(u32)i, bits};
		n += bits != 0;
	}
	return n;
}

static void splat_face(const job *j, worker *w, u32 cube, u32 side, u64 n)
{
	w->face = ts_splat_face_begin(j->args, cube, side);
	for (u64 i = 0; i < n; i++) {
		if ((w->seen[i].faces >> side & 1) == 0) continue;
		const live *piece = &j->pieces[w->seen[i].live];
		ts_splat_batch_add(&w->batch, &w->face, piece->piece, piece->length, piece->flags);
		if (w->batch.n == TS_SPLAT_PIECES) splat_batch(j, w);
	}
	splat_batch(j, w);
	ts_splat_block_write(&w->block, &w->face);
	ts_add_i64(j->args->n_scatters, w->face.scatters);
	ts_add_i64(j->args->n_writes, w->face.writes);
}

static void splat_faces(const job *j, worker *w, u32 cube, u32 faces)
{
	if (j->args->cubes[cube].n == 0) return;
	u64 n = find_seen(j, w->seen, cube, faces);
	for (u32 side = 0; side < 6; side++) {
		if ((faces >> side & 1) != 0) splat_face(j, w, cube, side, n);
	}
}

static live live_of(const ts_points_args *from, u32 piece)
{
	live r = {.piece = piece, .triangle = from->pieces[piece].triangle};
	if (from->points != NULL) {
		r.length = from->points[from->offset[piece]].length;
		r.flags = from->points[from->offset[piece]].flags;
	} else {
		ts_flight point = ts_k_flight_of_piece(from, piece);
		r.length = point.length;
		r.flags = point.flags;
	}
	return r;
}

static bool find_live(job *j)
{
	const ts_points_args *from = &j->args->from;
	j->pieces = malloc(((size_t)j->args->n_pieces + 1) * sizeof *j->pieces);
	if (j->pieces == NULL) return false;
	for (u32 piece = 0; piece < j->args->n_pieces; piece++) {
		if (from->offset[piece + 1] != from->offset[piece]) j->pieces[j->n_pieces++] = live_of(from, piece);
	}
	return true;
}

/* Coordinates of the stored points, apart. */
static bool take_centres(job *j, u32 threads)
{
	i64 n = j->args->from.offset[j->args->n_pieces];
	size_t room = (size_t)n + LANES;
	f32 *centre = calloc(3 * room, sizeof *centre);
	if (centre == NULL) return false;
	for (u32 axis = 0; axis < 3; axis++) j->centre[axis] = centre + axis * room;
#pragma omp parallel for num_threads(threads)
	for (i64 i = 0; i < n; i++) {
		for (u32 axis = 0; axis < 3; axis++) j->centre[axis][i] = j->args->from.points[i].centre[axis];
	}
	return true;
}

static worker *make_workers(const job *j, u32 n)
{
	worker *workers = calloc(n, sizeof *workers);
	seen *lists = malloc((size_t)n * (j->n_pieces + 1) * sizeof *lists);
	for (u32 t = 0; workers != NULL && t < n; t++) workers[t].seen = lists + (size_t)t * (j->n_pieces + 1);
	if (workers != NULL && lists != NULL) return workers;
	free(workers);
	free(lists);
	return NULL;
}

/* Threads take cubes where there are enough, otherwise faces. */
static void splat_all(const job *j, worker *workers, u32 threads)
{
	bool by_cube = j->args->n_cubes >= 4 * threads;
	i64 n = (i64)j->args->n_cubes * (by_cube ? 1 : 6);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (i64 i = 0; i < n; i++) {
		splat_faces(j, &workers[omp_get_thread_num()], (u32)(by_cube ? i : i / 6), by_cube ? 63u : 1u << i % 6);
	}
}

static bool splat(const ts_splat_args *args, bool stored, u32 threads)
{
	if (args->from.offset == NULL || args->mark != 0) return false;
	job j = {.args = args};
	bool made = find_live(&j) && (!stored || take_centres(&j, threads));
	worker *workers = made ? make_workers(&j, threads) : NULL;
	if (workers != NULL) {
		splat_all(&j, workers, threads);
		free(workers->seen);
	}
	free(workers);
	free(j.centre[0]);
	free(j.pieces);
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
