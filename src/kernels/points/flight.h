/* Points on their way to views: as they are stored, or made from their piece; and made again from their index alone,
 * where none is stored (EPR section 3.4; METHODS 18). */
#ifndef TS_KERNELS_FLIGHT_H
#define TS_KERNELS_FLIGHT_H
#include "points.h"

/* A point on its way. */
typedef struct {
	u64 piece;
	i32 x, y;
	ts_v3 centre;
	f32 length;
	u32 flags;
	bool at_centre; /* of its texel, not at its own place */
} ts_flight;

/* As it is stored, but for its sample. */
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

TS_FN ts_flight ts_k_flight_stored(const ts_points_args *from, u64 i)
{
	u64 key = *ts_at(from->keys, i);
	ts_flight r = ts_k_flight_record(from, i);
	r.x = (i32)(key & 0xffffu) - 32768;
	r.y = (i32)((key >> 16) & 0xffffu) - 32768;
	return r;
}

/* What all points of a piece have in common; the rest is ts_k_flight_start's. */
TS_FN ts_flight ts_k_flight_of_piece(const ts_points_args *from, u64 piece)
{
	ts_flight r;
	r.piece = piece;
	r.x = 0;
	r.y = 0;
	r.centre = ts_v3_make(0.0f, 0.0f, 0.0f);
	r.at_centre = false;
	r.length = ts_put(ts_k_splat_length(from, &from->pieces[piece], from->frames[piece].s, &r.flags));
	return r;
}

TS_FN void ts_k_flight_start(const ts_points_args *from, ts_flight *point, i32 x, i32 y)
{
	ts_v3 centre = ts_k_point_centre(from, point->piece, x, y);
	point->x = x;
	point->y = y;
	point->centre = ts_v3_make(ts_put(centre.x), ts_put(centre.y), ts_put(centre.z));
}

/* The piece of point `index`: of those that have points, the last one that begins at the index or before. */
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

/* Goes to point *rank of row y, of whose samples `touched` touch the piece; what the row has is counted off where it
 * does not have so many. An alpha mask may cut any of them: these are looked at one by one. */
TS_FN bool ts_k_flight_in_row(const ts_points_args *from, const ts_cover *cover, ts_span touched, ts_flight *point,
                              i32 y, u32 *rank)
{
	u32 triangle = from->pieces[point->piece].triangle;
	bool masked = (from->scene.materials[from->scene.triangles[triangle].material].flags & TS_MASKED) != 0u;
	u32 n = (u32)(touched.last - touched.first + 1);
	i32 x = touched.first;
	if (!masked && *rank >= n) {
		*rank -= n;
		return false;
	}
	if (!masked) x += (i32)*rank;
	for (; masked && x <= touched.last; x++) {
		if (!ts_k_is_point(from, cover, point->piece, x, y)) continue;
		if (*rank == 0u) break;
		*rank -= 1u;
	}
	if (x > touched.last) return false;
	ts_k_flight_start(from, point, x, y);
	return true;
}

/* Point `index` of pieces whose points from->offset counts: its piece by search, its sample by counting rows. */
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

/* n_pieces 0: points are stored. */
TS_FN ts_flight ts_k_flight_at(const ts_points_args *from, u32 n_pieces, u32 index)
{
	if (n_pieces != 0u) return ts_k_flight_again(from, n_pieces, index);
	return ts_k_flight_stored(from, index);
}

/* What a point shows. */
TS_FN ts_surface ts_k_flight_surface(const ts_points_args *from, const ts_flight *point)
{
	return ts_k_lattice_surface(&from->scene, &from->frames[point->piece], from->pieces[point->piece].triangle,
	                            point->x, point->y, point->centre, point->length);
}

#endif
