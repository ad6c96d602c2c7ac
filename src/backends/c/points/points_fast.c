/* Fast paths of the kernels that count points and write them, with the same bits: rows of wide pieces as a whole, their
 * ends by division, their points side by side. */
#include <omp.h>
#include <stdlib.h>
#include "../../../model/core.h"
#include "../../fast.h"
#include "made_points.h"

/* Samples of a row, on average, that are worth that; and the most that there is room for, with those at its ends. */
enum { LEAST = 8, MOST = 4096, ENDS = 4, PIECES_A_CHUNK = 1024 };

static i32 extent(const i32 *q)
{
	return ts_max_i32(ts_max_i32(q[0], q[2]), q[4]) - ts_min_i32(ts_min_i32(q[0], q[2]), q[4]);
}

/* A triangle's rows are half as long as its box, on average. */
static bool is_wide(const ts_points_args *args, u64 piece)
{
	i32 wide = extent(args->frames[piece].q);
	if (wide < 2 * LEAST * 256 || wide > MOST * 256 || !(args->frames[piece].s > 0.0f)) return false;
	return !ts_k_is_masked(&args->scene, args->pieces[piece].triangle);
}

static void count(const ts_points_args *args, u64 piece)
{
	if (is_wide(args, piece)) {
		ts_made_piece made = ts_made_piece_begin(args, piece);
		args->offset[piece] = (u32)ts_made_piece_count(&made);
	} else {
		ts_k_points_count_item(args, piece);
	}
}

bool ts_c_fast_points_count(const void *of, u64 n, u32 threads)
{
#pragma omp parallel for schedule(dynamic, PIECES_A_CHUNK) num_threads(threads)
	for (i64 i = 0; i < (i64)n; i++) count(of, (u64)i);
	return true;
}

static void put_row(const ts_points_args *args, const ts_flight *piece, ts_span row, i32 y, f32 *const centre[3],
                    u64 at)
{
	u64 key = (piece->piece << 32) | ((u64)(u32)(y + 32768) << 16);
	for (i32 x = row.first; x <= row.last; x++, at++) {
		i32 k = x - row.first;
		f32 *to = args->points[at].centre;
		for (u32 axis = 0; axis < 3; axis++) to[axis] = centre[axis][k];
		args->points[at].length = piece->length;
		args->points[at].piece = (u32)piece->piece;
		args->points[at].flags = piece->flags;
		args->points[at].pad[0] = args->points[at].pad[1] = 0;
		args->keys[at] = key | (u64)(u32)(x + 32768);
	}
}

static void put_wide(const ts_points_args *args, u64 piece, f32 *const centre[3])
{
	u64 at = args->offset[piece];
	ts_made_piece made = ts_made_piece_begin(args, piece);
	ts_box box = made.cover.touched;
	ts_flight point = ts_k_flight_of_piece(args, piece);
	for (i32 y = box.y0; y <= box.y1; y++) {
		u32 n = ts_made_row(&made, y, centre);
		put_row(args, &point, ts_k_touched_row(&made.lines, box, y), y, centre, at);
		at += n;
	}
}

static void put(const ts_points_args *args, u64 piece, f32 *const centre[3])
{
	if (is_wide(args, piece)) {
		put_wide(args, piece, centre);
	} else {
		ts_k_points_item(args, piece);
	}
}

/* Not where points may find no room. */
bool ts_c_fast_points(const void *of, u64 n, u32 threads)
{
	const ts_points_args *args = of;
	size_t room = MOST + ENDS + TS_MADE_LANES;
	if (args->room < args->offset[n]) return false;
	f32 *rows = ts_alloc(threads * 3 * room, sizeof *rows, "rows of points");
	if (rows == NULL) return false;
#pragma omp parallel for schedule(dynamic, PIECES_A_CHUNK) num_threads(threads)
	for (i64 i = 0; i < (i64)n; i++) {
		f32 *row = rows + (size_t)omp_get_thread_num() * 3 * room;
		put(args, (u64)i, (f32 *const[]){row, row + room, row + 2 * room});
	}
	free(rows);
	return true;
}
