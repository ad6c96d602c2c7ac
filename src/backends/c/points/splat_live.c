/* Rows of points, as arrays. */
#include "backends/c/points/splat_live.h"
#include <stdlib.h>
#include <string.h>
#include "kernels/points/splat_pieces.h"
#include "model/core.h"

enum { WORDS = 6 + TS_SPLAT_CORNERS + TS_SPLAT_SIDES, POINTS = TS_SPLAT_POINTS, LANES = TS_SPLAT_LANES };

ts_splat_bounds ts_splat_bounds_of(const f32 *const centre[3], u32 n)
{
	ts_splat_bounds b;
	for (u32 axis = 0; axis < 3; axis++) {
		const f32 *x = centre[axis];
		ts_range r = {x[0], x[0]};
		for (u32 i = 1; i < n; i++) {
			r.least = ts_min(r.least, x[i]);
			r.most = ts_max(r.most, x[i]);
		}
		b.of[axis] = r;
	}
	return b;
}

void ts_splat_bounds_add(ts_splat_bounds *to, const ts_splat_bounds *more)
{
	for (u32 axis = 0; axis < 3; axis++) {
		to->of[axis].least = ts_min(to->of[axis].least, more->of[axis].least);
		to->of[axis].most = ts_max(to->of[axis].most, more->of[axis].most);
	}
}

/* One block, which begins with `piece`, holds all arrays of words. */
static bool make_room(ts_splat_live *live, size_t n)
{
	size_t room = n + LANES;
	u32 *words = ts_alloc(WORDS * room, sizeof *words, "pieces that have points");
	if (words == NULL) return false;
	live->piece = words;
	live->triangle = words + room;
	live->tiny = words + 2 * room;
	live->index = words + 3 * room;
	f32 *floats = (f32 *)(words + 4 * room);
	live->length = floats;
	live->slack = floats + room;
	for (u32 k = 0; k < TS_SPLAT_CORNERS; k++) live->corner[k] = floats + (2 + k) * room;
	for (u32 k = 0; k < TS_SPLAT_SIDES; k++) live->side[k] = floats + (2 + TS_SPLAT_CORNERS + k) * room;
	return true;
}

static bool make_room_for_points(ts_splat_live *live, size_t n_points, size_t n_rows)
{
	size_t room = n_points + POINTS + LANES;
	f32 *centre = ts_alloc(3 * room, sizeof *centre, "coordinates of points");
	live->bounds = ts_alloc(n_rows, sizeof *live->bounds, "bounds of points");
	live->centre[0] = centre;
	if (centre == NULL || live->bounds == NULL) return false;
	for (u32 axis = 0; axis < 3; axis++) {
		live->centre[axis] = centre + axis * room;
		memset(live->centre[axis] + n_points, 0, (room - n_points) * sizeof *centre);
	}
	return true;
}

static void find(ts_splat_live *live, const u32 *offset, u32 n_pieces, u32 most)
{
	for (u32 piece = 0; piece < n_pieces; piece++) {
		for (u32 at = offset[piece], end = offset[piece + 1]; at < end; at += end - at < most ? end - at : most) {
			live->piece[live->n] = piece;
			live->index[live->n++] = at;
		}
	}
	live->index[live->n] = offset[n_pieces];
}

static void take_piece(ts_splat_live *live, u64 i, const ts_points_args *from)
{
	const ts_piece *piece = &from->pieces[live->piece[i]];
	const ts_align *frame = &from->frames[live->piece[i]];
	bool stored = from->points != NULL;
	ts_flight point = stored ? ts_k_flight_record(from, live->index[i]) : ts_k_flight_of_piece(from, live->piece[i]);
	f32 half_length = point.length * 0.5f;
	live->triangle[i] = piece->triangle;
	live->tiny[i] = point.flags & TS_POINT_TINY;
	live->length[i] = point.length;
	live->slack[i] = ts_k_piece_slack(piece);
	for (u32 axis = 0; axis < 3; axis++) {
		live->corner[axis][i] = piece->a[axis];
		live->corner[3 + axis][i] = piece->b[axis];
		live->corner[6 + axis][i] = piece->c[axis];
		live->side[axis][i] = frame->u[axis] * half_length;
		live->side[3 + axis][i] = frame->v[axis] * half_length;
	}
}

static void take_points(ts_splat_live *live, u64 i, const ts_point *points)
{
	u32 begin = live->index[i], n = ts_splat_live_points(live, i, i + 1);
	const f32 *const centre[3] = {live->centre[0] + begin, live->centre[1] + begin, live->centre[2] + begin};
	for (u32 at = begin; at < begin + n; at++) {
		for (u32 axis = 0; axis < 3; axis++) live->centre[axis][at] = points[at].centre[axis];
	}
	live->bounds[i] = ts_splat_bounds_of(centre, n);
}

bool ts_splat_live_make(ts_splat_live *live, const ts_splat_args *args, u32 threads)
{
	const ts_points_args *from = &args->from;
	bool stored = from->points != NULL;
	u32 n_points = from->offset[args->n_pieces], most = stored ? POINTS : n_points;
	size_t n_rows = (size_t)args->n_pieces + (stored ? n_points / POINTS : 0);
	if (!make_room(live, n_rows + 1)) return false;
	if (stored && !make_room_for_points(live, n_points, n_rows)) return false;
	find(live, from->offset, args->n_pieces, most);
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for num_threads(threads)
	for (i64 i = 0; i < (i64)live->n; i++) {
		if (ts_stopped(stop)) continue;
		take_piece(live, (u64)i, from);
		if (stored) take_points(live, (u64)i, from->points);
	}
	return !ts_stopped(stop);
}

void ts_splat_live_clear(ts_splat_live *live)
{
	free(live->piece);
	free(live->centre[0]);
	free(live->bounds);
}

#include "backends/selftest.h"
