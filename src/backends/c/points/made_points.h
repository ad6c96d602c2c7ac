/* Makes the points of a piece, row by row of its lattice, in vector lanes, with the bits of ts_k_flight_start. */
#ifndef TS_BACKENDS_C_POINTS_MADE_POINTS_H
#define TS_BACKENDS_C_POINTS_MADE_POINTS_H
#include "backends/c/points/sample_mask.h"
#include "backends/c/points/view_planes.h"
#include "kernels/points/points.h"

/* Lanes beyond the last point may be written, and hold anything when read. */
enum { TS_MADE_LANES = 16 };

/* Values that all rows of a piece share; the scale of its frame is above 0. */
typedef struct {
	const ts_points_args *from;
	u64 piece;
	bool masked;
	ts_cover cover;
	ts_lines lines;
	ts_v2 corner[3];     /* in the lattice */
	ts_sample_mask mask; /* where it is masked */
} ts_made_piece;

ts_made_piece ts_made_piece_begin(const ts_points_args *from, u64 piece);
/* Whether a sample is a point. */
bool ts_made_is_point(const ts_made_piece *piece, i32 x, i32 y);
/* Number of points of the rows from touched.y0 to touched.y1. */
u64 ts_made_piece_count(const ts_made_piece *piece);
/* A box that contains all these points. */
ts_bounds ts_made_piece_bounds(const ts_made_piece *piece);
/* Makes the points of row y, in the order of x; returns their number. Arrays have room for the whole row and
 * TS_MADE_LANES. */
u32 ts_made_row(const ts_made_piece *piece, i32 y, f32 *const centre[3]);
/* ts_made_row for a piece without a mask, of which the touching samples are known; none: last is first - 1. */
void ts_made_span(const ts_made_piece *piece, ts_span row, i32 y, f32 *const centre[3]);

#endif
