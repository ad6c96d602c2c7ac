/* Points: the samples that an aligned piece touches by the conservative test, row by row (EPR sections 3.3, 3.4;
 * METHODS 2). */
#ifndef TS_KERNELS_POINTS_POINTS_H
#define TS_KERNELS_POINTS_POINTS_H
#include "kernels/base/area.h"
#include "kernels/base/args.h"
#include "kernels/base/band.h"
#include "kernels/raster/lattice.h"

#define TS_ROWS_ts_points_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_piece, pieces, split_piece) \
	ARG(IN, ts_align, frames, align_frame) \
	ARG(OUT_OPT, u32, offset, points_offset) /* counts, then their prefix sums */ \
	ARG(OUT_PARTS_OPT, u64, keys, points_key) \
	ARG(OUT_PARTS_OPT, ts_point, points, points_record) \
	ARG(TALLY_OPT, i64, n_points, 0)   /* appended so far */ \
	ARG(VALUE, u64, room, none)        /* points that the arrays can hold */ \
	ARG(VALUE, i32, half_size, none)   /* of a lattice square, in 1/256: 129 safe, 128 exact, 0 only its centre */ \
	ARG(VALUE, u32, paper_splat, none) /* not 0: sub-pixel pieces get a splat of their own area */ \
	ARG(VALUE, u32, snap, none)        /* not 0: samples beside their piece move to its border */
TS_ARGS(ts_points_args);

#define TS_POINT_TINY 1u /* flag of points of pieces smaller than a sample */

/* Added to the indices of a sample, which are at least -2^15, so that each fits into 16 bits of a key. */
#define TS_SAMPLE_BIAS 32768

/* The sample touches the piece and is not cut away by its alpha mask. */
TS_FN bool ts_k_is_point(const ts_points_args *args, const ts_cover *cover, u64 piece, i32 x, i32 y)
{
	return ts_k_is_sample(&args->scene, &args->pieces[piece], &args->frames[piece], cover, x, y);
}

/* Number of points in a band of a piece. */
TS_FN u32 ts_k_points_of(const ts_points_args *args, const ts_band *band)
{
	u64 piece = band->item;
	if (!(args->frames[piece].s > 0.0f)) return 0u;
	ts_cover cover = ts_k_lattice_cover(&args->frames[piece], args->half_size);
	u32 count = 0u;
	for (i32 y = cover.touched.y0 + band->first; y <= cover.touched.y1; y += band->step) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			count += ts_k_is_point(args, &cover, piece, x, y) ? 1u : 0u;
		}
	}
	return count;
}

/* map over pieces: number of points */
TS_FN void ts_k_points_count_item(const ts_points_args *args, u64 i)
{
	ts_band all = ts_k_band(i, 0u);
	args->offset[i] = ts_k_points_of(args, &all);
}

/* The length of a splat: l = 1/s (EPR 4.1.1, eq. 4). A sub-pixel piece is tiny; by the paper its splat is a square of
 * its own area. */
TS_FN f32 ts_k_splat_length(const ts_points_args *args, TS_GLOBAL const ts_piece *piece, f32 s, u32 *flags)
{
	f32 area = ts_k_area(ts_load3(piece->a), ts_load3(piece->b), ts_load3(piece->c));
	bool tiny = (area * s) * s < 1.0f;
	*flags = tiny && args->paper_splat == 0u ? TS_POINT_TINY : 0u;
	return tiny && args->paper_splat != 0u ? ts_sqrt(area) : 1.0f / s;
}

/* The position of the point of sample (x, y). */
TS_FN ts_v3 ts_k_point_centre(const ts_points_args *args, u64 piece, i32 x, i32 y)
{
	return ts_k_sample_centre(&args->pieces[piece], &args->frames[piece], args->snap != 0u, x, y);
}

/* A point, whether read or made. */
typedef struct {
	u64 piece;
	i32 x, y; /* its sample */
	ts_v3 centre;
	f32 length;
	u32 flags;
	bool at_centre; /* the point is moved to the centre of its texel */
} ts_flight;

/* Sets what all points of a piece have in common; ts_k_flight_start sets the rest. */
TS_FN ts_flight ts_k_flight_of_piece(const ts_points_args *args, u64 piece)
{
	ts_flight r;
	r.piece = piece;
	r.x = 0;
	r.y = 0;
	r.centre = ts_v3_make(0.0f, 0.0f, 0.0f);
	r.at_centre = false;
	r.length = ts_put(ts_k_splat_length(args, &args->pieces[piece], args->frames[piece].s, &r.flags));
	return r;
}

/* Sets the sample and the centre of a point of a piece. */
TS_FN void ts_k_flight_start(const ts_points_args *args, ts_flight *point, i32 x, i32 y)
{
	ts_v3 centre = ts_k_point_centre(args, point->piece, x, y);
	point->x = x;
	point->y = y;
	point->centre = ts_v3_make(ts_put(centre.x), ts_put(centre.y), ts_put(centre.z));
}

TS_FN void ts_k_point_write(const ts_points_args *args, const ts_flight *point, u64 at)
{
	TS_GLOBAL ts_point *out = ts_at(args->points, at);
	ts_store3(out->centre, point->centre);
	out->length = ts_put(point->length);
	out->piece = (u32)point->piece;
	out->flags = point->flags;
	out->pad[0] = 0u;
	out->pad[1] = 0u;
	u64 sample = ((u64)(u32)(point->y + TS_SAMPLE_BIAS) << 16) | (u64)(u32)(point->x + TS_SAMPLE_BIAS);
	*ts_at(args->keys, at) = (point->piece << 32) | sample;
}

TS_FN void ts_k_point_put(const ts_points_args *args, ts_flight *point, i32 x, i32 y, u64 at)
{
	ts_k_flight_start(args, point, x, y);
	ts_k_point_write(args, point, at);
}

/* emit over pieces */
TS_FN void ts_k_points_item(const ts_points_args *args, u64 i)
{
	/* Leave out a piece without points. */
	u64 at = args->offset[i];
	if (args->offset[i + 1u] == (u32)at) return;
	/* Set what the piece's points have in common. */
	ts_cover cover = ts_k_lattice_cover(&args->frames[i], args->half_size);
	ts_flight point = ts_k_flight_of_piece(args, i);
	/* Write a point for each sample that touches the piece, row by row (EPR 3.3, 3.4; CONTRACT rule 21). */
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(args, &cover, i, x, y)) continue;
			if (at < args->room) ts_k_point_put(args, &point, x, y, at);
			at++;
		}
	}
}

/* scatter over pieces: the same points in the order of arrival, as the papers' GPUs append them. Points that find no
 * room are only counted. */
TS_FN void ts_k_points_append_item(const ts_points_args *args, u64 i)
{
	if (!(args->frames[i].s > 0.0f)) return;
	ts_cover cover = ts_k_lattice_cover(&args->frames[i], args->half_size);
	ts_flight point = ts_k_flight_of_piece(args, i);
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(args, &cover, i, x, y)) continue;
			u64 at = (u64)ts_next_i64(args->n_points);
			if (at < args->room) ts_k_point_put(args, &point, x, y, at);
		}
	}
}

#endif
