/* Fast paths of the kernels that count points and write them, with the same bits: rows of wide pieces as a whole, their
 * ends by division, their points side by side; narrow pieces side by side; masks of pieces found once. */
#include <omp.h>
#include <stdlib.h>
#include "backends/c/points/made_points.h"
#include "backends/c/points/narrow_pieces.h"
#include "backends/fast.h"
#include "model/core.h"

/* Fewest samples per row, on average, for a wide piece; most that there is room for, and those at its ends. */
enum { LEAST = 8, MOST = 4096, ENDS = 4, PIECES = TS_NARROW_PIECES, CHUNK = 16 };

static i32 extent(const i32 *q)
{
	return ts_max_i32(ts_max_i32(q[0], q[2]), q[4]) - ts_min_i32(ts_min_i32(q[0], q[2]), q[4]);
}

/* A triangle's rows are half as long as its box, on average. */
static bool is_wide(const ts_points_args *args, u64 piece)
{
	i32 wide = extent(args->frames[piece].q);
	return wide >= 2 * LEAST * 256 && wide <= MOST * 256;
}

/* How a piece is processed. */
typedef enum { NONE, ALONE, WIDE, MASKED, NARROW } way;

static way way_of(const ts_points_args *args, u64 piece, bool narrow)
{
	if (!(args->frames[piece].s > 0.0f)) return NONE;
	if (narrow) return NARROW;
	if (ts_k_is_masked(&args->scene, args->pieces[piece].triangle)) return MASKED;
	return is_wide(args, piece) ? WIDE : ALONE;
}

static u32 pieces_from(u64 first, u64 n) { return n - first < PIECES ? (u32)(n - first) : PIECES; }

static u32 points_of(const ts_points_args *args, u64 piece, way of)
{
	if (of == NONE) return 0;
	const ts_band all = ts_k_band(piece, 0u);
	if (of == ALONE) return ts_k_points_of(args, &all);
	ts_made_piece made = ts_made_piece_begin(args, piece);
	return (u32)ts_made_piece_count(&made);
}

/* Leaves out the samples that a narrow piece's mask cuts. */
static void cut(const ts_points_args *args, u64 piece, ts_narrow_pieces *of, u32 i)
{
	ts_sample_mask mask = ts_sample_mask_of(&args->scene, &args->frames[piece], args->pieces[piece].triangle);
	for (u32 y = 0; y < of->n_rows; y++) {
		for (u32 bits = of->rows[y][i]; bits != 0; bits &= bits - 1) {
			i32 x = __builtin_ctz(bits);
			if (!ts_sample_mask_cuts(&mask, of->x0[i] + x, of->y0[i] + (i32)y)) continue;
			of->rows[y][i] ^= 1u << x;
			of->n[i]--;
		}
	}
}

static void count(const ts_points_args *args, u64 first, u32 n)
{
	ts_narrow_pieces narrow;
	ts_narrow_find(&narrow, args->frames + first, n, args->half_size);
	for (u32 i = 0; i < n; i++) {
		way of = way_of(args, first + i, narrow.narrow[i] != 0);
		bool masked = of == NARROW && ts_k_is_masked(&args->scene, args->pieces[first + i].triangle);
		if (masked) cut(args, first + i, &narrow, i);
		args->offset[first + i] = of == NARROW ? narrow.n[i] : points_of(args, first + i, of);
	}
}

bool ts_c_fast_points_count(const void *of, u64 n, u32 threads)
{
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, CHUNK) num_threads(threads)
	for (i64 first = 0; first < (i64)n; first += PIECES) {
		if (ts_stopped(stop)) continue;
		count(of, (u64)first, pieces_from((u64)first, n));
	}
	return true;
}

static void put_row(const ts_points_args *args, ts_flight *point, ts_span row, f32 *const centre[3], u64 at)
{
	for (point->x = row.first; point->x <= row.last; point->x++, at++) {
		i32 k = point->x - row.first;
		point->centre = ts_v3_make(centre[0][k], centre[1][k], centre[2][k]);
		ts_k_point_write(args, point, at);
	}
}

static void put_wide(const ts_points_args *args, u64 piece, f32 *const centre[3])
{
	u64 at = args->offset[piece];
	ts_made_piece made = ts_made_piece_begin(args, piece);
	ts_box box = made.cover.touched;
	ts_flight point = ts_k_flight_of_piece(args, piece);
	for (point.y = box.y0; point.y <= box.y1; point.y++) {
		ts_span row = ts_k_touched_row(&made.lines, box, point.y);
		ts_made_span(&made, row, point.y, centre);
		put_row(args, &point, row, centre, at);
		at += (u64)(row.last - row.first + 1);
	}
}

static void put_masked(const ts_points_args *args, u64 piece)
{
	u64 at = args->offset[piece];
	ts_made_piece made = ts_made_piece_begin(args, piece);
	ts_box box = made.cover.touched;
	ts_flight point = ts_k_flight_of_piece(args, piece);
	for (i32 y = box.y0; y <= box.y1; y++) {
		for (i32 x = box.x0; x <= box.x1; x++) {
			if (ts_made_is_point(&made, x, y)) ts_k_point_put(args, &point, x, y, at++);
		}
	}
}

static void put_narrow(const ts_points_args *args, u64 piece, const ts_narrow_pieces *of, u32 i)
{
	u64 at = args->offset[piece];
	ts_flight point = ts_k_flight_of_piece(args, piece);
	for (u32 y = 0; y < of->n_rows; y++) {
		for (u32 bits = of->rows[y][i]; bits != 0; bits &= bits - 1)
			ts_k_point_put(args, &point, of->x0[i] + __builtin_ctz(bits), of->y0[i] + (i32)y, at++);
	}
}

static void put(const ts_points_args *args, u64 first, u32 n, f32 *const centre[3])
{
	ts_narrow_pieces narrow;
	ts_narrow_find(&narrow, args->frames + first, n, args->half_size);
	for (u32 i = 0; i < n; i++) {
		u32 n_points = args->offset[first + i + 1] - args->offset[first + i];
		if (n_points == 0) continue;
		way of = way_of(args, first + i, narrow.narrow[i] != 0);
		if (of == NARROW && narrow.n[i] != n_points) cut(args, first + i, &narrow, i);
		if (of == NARROW) put_narrow(args, first + i, &narrow, i);
		if (of == MASKED) put_masked(args, first + i);
		if (of == WIDE) put_wide(args, first + i, centre);
		if (of == ALONE) ts_k_points_item(args, first + i);
	}
}

/* Refuses where points may find no room. */
bool ts_c_fast_points(const void *of, u64 n, u32 threads)
{
	const ts_points_args *args = of;
	size_t room = MOST + ENDS + TS_MADE_LANES;
	if (args->room < args->offset[n]) return false;
	f32 *rows = ts_alloc(threads * 3 * room, sizeof *rows, "rows of points");
	if (rows == NULL) return false;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, CHUNK) num_threads(threads)
	for (i64 first = 0; first < (i64)n; first += PIECES) {
		if (ts_stopped(stop)) continue;
		f32 *row = rows + (size_t)omp_get_thread_num() * 3 * room;
		put(args, (u64)first, pieces_from((u64)first, n), (f32 *const[]){row, row + room, row + 2 * room});
	}
	free(rows);
	return true;
}

#include "backends/selftest.h"
