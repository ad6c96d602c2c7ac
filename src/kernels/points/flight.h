/* Points on their way to views: read from where they are stored; or, where none is stored, made again from their index
 * alone (EPR section 3.4; METHODS 18). */
#ifndef TS_KERNELS_POINTS_FLIGHT_H
#define TS_KERNELS_POINTS_FLIGHT_H
#include "kernels/points/points.h"

/* A stored point. Its sample is not stored: x and y are 0. */
TS_FN ts_flight ts_k_flight_record(const ts_points_args *from, u64 i)
{
	TS_GLOBAL const ts_point *record = ts_at(from->points, i);
	ts_flight r;
	r.piece = record->piece;
	r.x = 0;
	r.y = 0;
	r.centre = ts_load3(record->centre);
	r.length = record->length;
	r.flags = record->flags;
	r.at_centre = false;
	return r;
}

/* A stored point with its sample, which its key holds. */
TS_FN ts_flight ts_k_flight_stored(const ts_points_args *from, u64 i)
{
	u64 key = *ts_at(from->keys, i);
	ts_flight r = ts_k_flight_record(from, i);
	r.x = (i32)(key & 0xffffu) - TS_SAMPLE_BIAS;
	r.y = (i32)((key >> 16) & 0xffffu) - TS_SAMPLE_BIAS;
	return r;
}

/* The piece of point `index`: of the pieces that have points, the last whose first point is not after it. */
TS_FN u32 ts_k_piece_of(const ts_points_args *from, u32 n_pieces, u32 index)
{
	u32 low = 0u;
	u32 high = n_pieces;
	while (high - low > 1u) {
		u32 middle = low + (high - low) / 2u;
		if (from->offset[middle] <= index) {
			low = middle;
		} else {
			high = middle;
		}
	}
	return low;
}

/* Finds point *rank of row y, in which the samples of the span `touched` touch the piece. If the row has fewer points,
 * subtracts their number from *rank and returns false. Samples of a masked material are tested one by one. */
TS_FN bool ts_k_flight_in_row(const ts_points_args *from, const ts_cover *cover, ts_span touched, ts_flight *point,
                              i32 y, u32 *rank)
{
	/* See whether a mask may cut samples away. */
	u32 triangle = from->pieces[point->piece].triangle;
	bool masked = (from->scene.materials[from->scene.triangles[triangle].material].flags & TS_MASKED) != 0u;
	/* Skip the row, or step to the sample, where there is no mask: all samples of the span are points. */
	u32 n = (u32)(touched.last - touched.first + 1);
	i32 x = touched.first;
	if (!masked && *rank >= n) {
		*rank -= n;
		return false;
	}
	if (!masked) x += (i32)*rank;
	/* Count the samples that a mask leaves. */
	for (; masked && x <= touched.last; x++) {
		if (!ts_k_is_point(from, cover, point->piece, x, y)) continue;
		if (*rank == 0u) break;
		*rank -= 1u;
	}
	/* Make the point, if the row has that many. */
	if (x > touched.last) return false;
	ts_k_flight_start(from, point, x, y);
	return true;
}

/* Makes point `index` again: finds its piece in from->offset by search, and its sample by counting rows. */
TS_CALL ts_flight ts_k_flight_again(const ts_points_args *from, u32 n_pieces, u32 index)
{
	ts_flight point = ts_k_flight_of_piece(from, ts_k_piece_of(from, n_pieces, index));
	ts_cover cover = ts_k_lattice_cover(&from->frames[point.piece], from->half_size);
	ts_lines lines;
	ts_k_lines(&lines, &cover);
	u32 rank = index - from->offset[point.piece];
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		ts_span row = ts_k_touched_row(&lines, cover.touched, y);
		if (ts_k_flight_in_row(from, &cover, row, &point, y, &rank)) break;
	}
	return point;
}

/* Point `index`; n_pieces is 0 if points are stored. */
TS_FN ts_flight ts_k_flight_at(const ts_points_args *from, u32 n_pieces, u32 index)
{
	if (n_pieces != 0u) return ts_k_flight_again(from, n_pieces, index);
	return ts_k_flight_stored(from, index);
}

/* The surface that a point shows. */
TS_FN ts_surface ts_k_flight_surface(const ts_points_args *from, const ts_flight *point)
{
	return ts_k_lattice_surface(&from->scene, &from->frames[point->piece], from->pieces[point->piece].triangle,
	                            point->x, point->y, point->centre, point->length);
}

#endif
