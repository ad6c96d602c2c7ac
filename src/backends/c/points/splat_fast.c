/* Fast path of the splat kernels, with the same bits: a thread owns a cube face, so there are no atomics; pieces and
 * points go side by side, as many as a cache holds into all faces of some cubes; rows beside a face are left out. */
#include <omp.h>
#include <stdlib.h>
#include <string.h>
#include "../../fast.h"
#include "splat_batch.h"

enum { LANES = TS_SPLAT_LANES, POINTS = TS_SPLAT_POINTS, ROOM = TS_SPLAT_ROOM };

/* A thread takes that many cubes at once, and live pieces of about so many points. */
enum { MOST_CUBES = 8, PART_PIECES = 1024, PART_POINTS = 16384 };

typedef struct {
	f32 least, most;
} range;

/* Where points are, in the world. */
typedef struct {
	range of[3];
} bounds;

typedef struct {
	const ts_splat_args *args;
	ts_splat_live live;
	f32 *centre[3]; /* of stored points; NULL: they are made */
	bounds *bounds; /* of each POINTS stored ones */
} job;

/* What a thread works with. */
typedef struct {
	u8 faces[MOST_CUBES][PART_PIECES + 8]; /* of each cube, that may see each piece of a part */
	ts_splat_face face;
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

static range range_of(const f32 *x, u32 n)
{
	range r = {x[0], x[0]};
	for (u32 i = 1; i < n; i++) {
		r.least = ts_min(r.least, x[i]);
		r.most = ts_max(r.most, x[i]);
	}
	return r;
}

static bounds bounds_of(const f32 *const centre[3], u32 n)
{
	return (bounds){{range_of(centre[0], n), range_of(centre[1], n), range_of(centre[2], n)}};
}

/* Of squares around points: as seen from the eye, along an axis, with room for what is rounded. */
static range towards(range of, f32 wide, f32 eye, f32 sign)
{
	f32 room = wide + 0.000001f * (ts_max(ts_abs(of.least), ts_abs(of.most)) + ts_abs(eye) + wide);
	range r = {(of.least - room - eye) * sign, (of.most + room - eye) * sign};
	return sign < 0 ? (range){r.most, r.least} : r;
}

/* Where the splats of a row are, on the face's axes: right, up, ahead. */
typedef struct {
	range of[3];
} extent;

static extent extent_of(const worker *w, const bounds *points, u32 k)
{
	extent e;
	for (u32 r = 0; r < 3; r++) {
		ts_row row = w->face.row[r];
		f32 wide = ts_abs(w->batch.side[r][k]) + ts_abs(w->batch.side[3 + r][k]);
		e.of[r] = towards(points->of[row.axis], wide, w->face.eye[row.axis], row.sign);
	}
	return e;
}

/* All splats lie beyond one side of the face, with room for what is rounded. */
static bool is_beside(const ts_splat_face *f, const extent *e)
{
	f32 ahead = ts_max(e->of[2].most, f->view.near) * 1.001f;
	for (u32 r = 0; r < 2; r++) {
		f32 rounded = 0.0001f * ts_max(ts_abs(e->of[r].least), ts_abs(e->of[r].most));
		if (e->of[r].least - rounded > ahead || e->of[r].most + rounded < -ahead) return true;
	}
	return false;
}

static i32 texel_near(const ts_splat_face *f, f32 x)
{
	return ts_k_floor_within(ts_clamp(x, 0.0f, (f32)(f->view.width - 1)), (f32)f->view.width);
}

/* Texels, x or y, and one more on each side. */
static void span_of(const ts_splat_face *f, range across, range ahead, f32 sign, i32 span[2])
{
	f32 least = across.least / (across.least < 0 ? ahead.least : ahead.most);
	f32 most = across.most / (across.most < 0 ? ahead.most : ahead.least);
	f32 middle = (f32)f->view.width * 0.5f;
	span[0] = texel_near(f, middle + f->view.focal * (sign < 0 ? -most : least) - 1.0f);
	span[1] = texel_near(f, middle + f->view.focal * (sign < 0 ? -least : most) + 1.0f);
}

/* No texel that the splats may touch is outside of the lines. */
static bool is_inside(const ts_splat_face *f, const extent *e, const ts_lines *lines)
{
	i32 x[2], y[2];
	if (!(e->of[2].least > f->view.near)) return false;
	span_of(f, e->of[0], e->of[2], 1, x);
	span_of(f, e->of[1], e->of[2], -1, y);
	for (u32 corner = 0; corner < 4; corner++) {
		if (!ts_k_inside_lines(lines, x[corner & 1], y[corner >> 1])) return false;
	}
	return true;
}

static void splat_owned_row(const job *j, worker *w, const way *of, ts_splat_row row)
{
	bounds made;
	const bounds *points = j->bounds != NULL ? &j->bounds[row.index / POINTS] : &made;
	if (j->bounds == NULL) made = bounds_of(row.centre, row.n);
	extent e = extent_of(w, points, of->k);
	if (is_beside(&w->face, &e)) return;
	bool cut = of->lines != NULL && !is_inside(&w->face, &e, of->lines);
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

static void splat_owned(const job *j, worker *w, u32 k, u32 n, const ts_lines *lines)
{
	way of = {k, true, lines};
	ts_splat_block_write(&w->block, &w->face, &j->live);
	ts_splat_block_own(&w->block, &w->batch, k, n < POINTS ? n : POINTS);
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
	ts_splat_batch_box(&w->batch, k, box);
	ts_lines lines;
	ts_k_lines(&lines, &cover);
	splat_owned(j, w, k, n, j->args->clip != 0 ? &lines : NULL);
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
	if (w->batch.way[k] == TS_SPLAT_UNSEEN) return;
	if (n >= POINTS) {
		splat_owned(j, w, k, n, NULL);
	} else {
		splat_points(j, w, &(way){k, false, NULL});
	}
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
	for (u32 k = 0; k < t->n; k++) memset(w->faces[k] + (p.end - p.begin) / 8 * 8, 0, 8);
	for (u64 i = p.begin; i < p.end; i++) {
		const u64 *words = j->args->bits + (u64)j->live.triangle[i] * j->args->n_words;
		for (u32 k = 0; k < t->n; k++) w->faces[k][i - p.begin] = (u8)(ts_k_cube_bits(words, t->first + k) & t->faces);
	}
}

/* Eight pieces at once, most of which the face does not see. */
static void splat_face(const job *j, worker *w, const u8 *faces, part p)
{
	for (u64 begin = p.begin; begin < p.end; begin += 8, faces += 8) {
		u64 eight;
		memcpy(&eight, faces, sizeof eight);
		for (u64 bits = eight >> w->face.side & EIGHT; bits != 0; bits &= bits - 1) {
			w->batch.live[w->batch.n++] = (u32)begin + (u32)__builtin_ctzll(bits) / 8;
			if (w->batch.n == TS_SPLAT_PIECES) splat_batch(j, w);
		}
	}
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
			splat_face(j, w, w->faces[k], p);
		}
	}
}

static u64 part_end(const job *j, u64 begin)
{
	u64 end = begin + 1;
	u32 first = j->args->from.offset[j->live.piece[begin]];
	while (end < j->live.n && end - begin < PART_PIECES &&
	       j->args->from.offset[j->live.piece[end] + 1] - first <= PART_POINTS)
		end++;
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
	j->bounds[of] = bounds_of(centre, end - begin);
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

static bool splat(const ts_splat_args *args, bool stored, u32 threads)
{
	if (args->from.offset == NULL || args->mark != 0) return false;
	job j = {.args = args};
	bool made = ts_splat_live_make(&j.live, args, threads) && (!stored || take_centres(&j, threads));
	worker *workers = made ? calloc(threads, sizeof *workers) : NULL;
	if (workers != NULL) splat_all(&j, workers, threads);
	free(workers);
	free(j.centre[0]);
	free(j.bounds);
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
