/* Pieces that have points, as arrays. */
#include <stdlib.h>
#include "../../../model/core.h"
#include "splat_batch.h"

enum { WORDS = 4 + TS_SPLAT_CORNERS + TS_SPLAT_SIDES };

/* Memory of all arrays is one block, which begins with `piece`. */
static bool make_room(ts_splat_live *live, size_t n)
{
	size_t room = n + TS_SPLAT_LANES;
	u32 *words = ts_alloc(WORDS * room, sizeof *words, "pieces that have points");
	if (words == NULL) return false;
	live->piece = words;
	live->triangle = words + room;
	live->tiny = words + 2 * room;
	f32 *floats = (f32 *)(words + 3 * room);
	live->length = floats;
	for (u32 k = 0; k < TS_SPLAT_CORNERS; k++) live->corner[k] = floats + (1 + k) * room;
	for (u32 k = 0; k < TS_SPLAT_SIDES; k++) live->side[k] = floats + (1 + TS_SPLAT_CORNERS + k) * room;
	return true;
}

static void find(ts_splat_live *live, const u32 *offset, u32 n_pieces)
{
	for (u32 piece = 0; piece < n_pieces; piece++) {
		if (offset[piece + 1] != offset[piece]) live->piece[live->n++] = piece;
	}
}

static ts_flight first_of(const ts_points_args *from, u32 piece)
{
	return from->points != NULL ? ts_k_flight_record(from, from->offset[piece]) : ts_k_flight_of_piece(from, piece);
}

static void take(ts_splat_live *live, u64 i, const ts_points_args *from)
{
	const ts_piece *piece = &from->pieces[live->piece[i]];
	const ts_align *frame = &from->frames[live->piece[i]];
	ts_flight point = first_of(from, live->piece[i]);
	f32 half_length = point.length * 0.5f;
	live->triangle[i] = piece->triangle;
	live->tiny[i] = point.flags & TS_POINT_TINY;
	live->length[i] = point.length;
	for (u32 axis = 0; axis < 3; axis++) {
		live->corner[axis][i] = piece->a[axis];
		live->corner[3 + axis][i] = piece->b[axis];
		live->corner[6 + axis][i] = piece->c[axis];
		live->side[axis][i] = frame->u[axis] * half_length;
		live->side[3 + axis][i] = frame->v[axis] * half_length;
	}
}

bool ts_splat_live_make(ts_splat_live *live, const ts_splat_args *args, u32 threads)
{
	if (!make_room(live, args->n_pieces)) return false;
	find(live, args->from.offset, args->n_pieces);
#pragma omp parallel for num_threads(threads)
	for (i64 i = 0; i < (i64)live->n; i++) take(live, (u64)i, &args->from);
	return true;
}

void ts_splat_live_clear(ts_splat_live *live) { free(live->piece); }
