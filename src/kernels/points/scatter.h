/* Scattering: writes every point into one texel of every off-screen view that may see it, by atomic minimum (iVIR
 * section 4; METHODS 9 and 10). A texel of a depth map is an axial depth; a texel of an environment map has 13 bits of
 * depth and 19 of colour, 6-7-6. The points are stored, or made on the spot.
 *
 * By the paper a texel takes the nearest of all points that fall anywhere into it, while MVR takes the triangle that
 * covers its centre. With `centre` a point stands for its triangle: it counts only if the triangle covers the texel's
 * centre, with the depth and colour of the triangle there. */
#ifndef TS_KERNELS_POINTS_SCATTER_H
#define TS_KERNELS_POINTS_SCATTER_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/points/colour_code.h"
#include "kernels/points/cull.h"
#include "kernels/points/flight.h"
#include "kernels/raster/draw.h"

#define TS_ROWS_ts_scatter_args(ARG) \
	ARG(INNER, ts_points_args, from, none) \
	ARG(IN, ts_offscreen, views, offscreen_view) \
	ARG(IN, u64, bits, visibility_bits)        /* by triangle */ \
	ARG(MIN_OPT, u32, depths, depth_map_depth) /* of the batch */ \
	ARG(MIN_OPT, u32, colours, scatter_colour) /* of the batch */ \
	ARG(TALLY, i64, n_points, 0) \
	ARG(TALLY, i64, n_scatters, 1) \
	ARG(TALLY, i64, n_writes, 2) /* points made; views that they were offered to; texels that they were offered to */ \
	ARG(VALUE, u32, first_view, none) \
	ARG(VALUE, u32, n_views, none) /* the batch */ \
	ARG(VALUE, u32, n_words, none) \
	ARG(VALUE, f32, exposure, none) /* of stored colours: the largest code is a radiance of 1 / exposure */ \
	ARG(VALUE, u32, centre, none)   /* not 0: points count at the centre of their texel */ \
	ARG(VALUE, u32, culled, none)   /* not 0: small pieces were dropped at random */ \
	ARG(VALUE, u32, others, none)   /* other items that share the rows: band.h */
TS_ARGS(ts_scatter_args);

/* The colour of a point at axial depth z in a view; textures are filtered for the view's texels. */
TS_CALL u32 ts_k_flight_colour(const ts_scatter_args *args, const ts_camera_k *view, const ts_flight *point, f32 z)
{
	u32 triangle = args->from.pieces[point->piece].triangle;
	ts_v3 way = ts_sub(point->centre, view->eye);
	f32 footprint = ts_k_footprint(z / view->focal, way, ts_k_corners(&args->from.scene, triangle).n);
	ts_surface s = ts_k_lattice_surface(&args->from.scene, &args->from.frames[point->piece], triangle, point->x,
	                                    point->y, point->centre, footprint);
	return ts_k_colour_code(ts_k_shade(&args->from.scene, &s, ts_normalize(ts_neg(way))), args->exposure);
}

/* Whether an offer at this depth may win. If not, its colour need not be computed. */
TS_FN bool ts_k_is_wanted(const ts_scatter_args *args, u32 depth, u64 texel)
{
	return depth <= ts_peek_u32(&args->colours[texel]);
}

TS_FN void ts_k_offer_colour(const ts_scatter_args *args, const ts_camera_k *view, const ts_flight *point, f32 z,
                             u64 texel)
{
	f32 distance = ts_length(ts_sub(point->centre, view->eye));
	u32 depth = ts_k_depth_code(distance, view->near) << 19;
	if (ts_k_is_wanted(args, depth, texel)) {
		u32 code = depth | ts_k_flight_colour(args, view, point, z);
		ts_min_u32(&args->colours[texel], code);
	}
}

/* Offers depth and colour of the point's triangle at the centre of texel (i, j). */
TS_CALL void ts_k_offer_centre(const ts_scatter_args *args, const ts_camera_k *view, u32 triangle,
                               const ts_fragment *fragment, u64 texel)
{
	ts_corners t = ts_k_corners(&args->from.scene, triangle);
	f32 footprint = ts_k_fragment_footprint(view, &t, fragment);
	ts_surface s = ts_k_surface(&args->from.scene, triangle, fragment->w, footprint);
	ts_v3 way = ts_sub(view->eye, s.p);
	u32 depth = ts_k_depth_code(ts_length(way), view->near) << 19;
	if (ts_k_is_wanted(args, depth, texel)) {
		ts_v3 radiance = ts_k_shade(&args->from.scene, &s, ts_normalize(way));
		ts_min_u32(&args->colours[texel], depth | ts_k_colour_code(radiance, args->exposure));
	}
}

/* Offers a point to texel (i, j), at its centre. Returns whether the point's triangle is drawn there. */
TS_FN bool ts_k_scatter_centre(const ts_scatter_args *args, const ts_camera_k *view, u32 triangle, i32 i, i32 j,
                               u64 texel)
{
	ts_fragment fragment = ts_k_fragment_drawn(&args->from.scene, view, triangle, i, j);
	if (!(fragment.z > 0.0f)) return false;
	if (args->depths != NULL) {
		ts_min_u32(&args->depths[texel], ts_f2u(ts_put(fragment.z)));
	} else {
		ts_k_offer_centre(args, view, triangle, &fragment, texel);
	}
	return true;
}

/* Offers one point to one view. Returns the number of texels offered to: 0 before the near plane, outside the image,
 * and where the point's triangle does not cover the texel's centre. */
TS_CALL u32 ts_k_scatter_into(const ts_scatter_args *args, TS_GLOBAL const ts_offscreen *offscreen,
                              const ts_flight *point, u64 first_texel)
{
	/* Project the point, unless it lies before the near plane. */
	ts_camera_k view = ts_k_offscreen(offscreen);
	ts_corner p = ts_k_to_view(&view, point->centre);
	if (!(p.z >= view.near)) return 0u;
	ts_v2 at = ts_k_project(&view, &p);
	/* Find the texel that the point falls into, if it is in the image. */
	i32 i = ts_floor_i32(at.x);
	i32 j = ts_floor_i32(at.y);
	if (i < 0 || j < 0 || i >= view.width || j >= view.height) return 0u;
	u64 texel = (offscreen->offset - first_texel) + (u64)j * (u64)view.width + (u64)i;
	/* Let the point stand for its triangle at the texel's centre, where that is asked for. */
	if (point->at_centre) {
		return ts_k_scatter_centre(args, &view, args->from.pieces[point->piece].triangle, i, j, texel) ? 1u : 0u;
	}
	/* Offer the point's own depth or colour (iVIR 4 and 5). */
	if (args->depths != NULL) {
		ts_min_u32(&args->depths[texel], ts_f2u(ts_put(p.z)));
	} else {
		ts_k_offer_colour(args, &view, point, p.z, texel);
	}
	return 1u;
}

/* Whether the piece's points count at the centre of their texel. A piece so small that others of its size were dropped
 * at random stands for these too, so its points count at their own place. */
TS_FN bool ts_k_is_at_centre(const ts_scatter_args *args, u64 index)
{
	if (args->centre == 0u || args->culled == 0u) return args->centre != 0u;
	TS_GLOBAL const ts_piece *piece = &args->from.pieces[index];
	f32 s = args->from.frames[index].s;
	f32 area = ts_k_area(ts_load3(piece->a), ts_load3(piece->b), ts_load3(piece->c));
	return ts_k_cull_threshold((area * s) * s) == 0;
}

typedef struct {
	i64 points, scatters, writes;
} ts_scatter_tally;

/* Offers one point to every view of the batch that may see its triangle. */
TS_FN void ts_k_scatter_point(const ts_scatter_args *args, const ts_flight *point, ts_scatter_tally *tally)
{
	TS_GLOBAL const u64 *words = args->bits + (u64)args->from.pieces[point->piece].triangle * args->n_words;
	u64 first_texel = args->views[args->first_view].offset;
	tally->points++;
	for (u32 v = args->first_view; v < args->first_view + args->n_views; v++) {
		if (!ts_k_offscreen_bit(words, v)) continue;
		tally->scatters++;
		tally->writes += ts_k_scatter_into(args, &args->views[v], point, first_texel);
	}
}

TS_FN void ts_k_scatter_count(const ts_scatter_args *args, const ts_scatter_tally *tally)
{
	ts_add_i64(args->n_points, tally->points);
	ts_add_i64(args->n_scatters, tally->scatters);
	ts_add_i64(args->n_writes, tally->writes);
}

TS_FN ts_scatter_tally ts_k_scatter_none(void)
{
	ts_scatter_tally r;
	r.points = 0;
	r.scatters = 0;
	r.writes = 0;
	return r;
}

/* scatter over stored points */
TS_FN void ts_k_scatter_item(const ts_scatter_args *args, u64 i)
{
	ts_scatter_tally tally = ts_k_scatter_none();
	ts_flight point = ts_k_flight_stored(&args->from, i);
	point.at_centre = ts_k_is_at_centre(args, point.piece);
	ts_k_scatter_point(args, &point, &tally);
	ts_k_scatter_count(args, &tally);
}

/* scatter over pieces: their points are made and not stored */
TS_FN void ts_k_scatter_pieces_item(const ts_scatter_args *args, u64 i)
{
	/* Leave out a piece without points. */
	ts_band band = ts_k_band(i, args->others);
	TS_GLOBAL const ts_align *frame = &args->from.frames[band.item];
	if (!(frame->s > 0.0f)) return;
	/* Set what the piece's points have in common. */
	ts_cover cover = ts_k_lattice_cover(frame, args->from.half_size);
	ts_scatter_tally tally = ts_k_scatter_none();
	ts_flight point = ts_k_flight_of_piece(&args->from, band.item);
	point.at_centre = ts_k_is_at_centre(args, band.item);
	/* Make each point of the band's rows, and scatter it at once. */
	for (i32 y = cover.touched.y0 + band.first; y <= cover.touched.y1; y += band.step) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(&args->from, &cover, band.item, x, y)) continue;
			ts_k_flight_start(&args->from, &point, x, y);
			ts_k_scatter_point(args, &point, &tally);
		}
	}
	ts_k_scatter_count(args, &tally);
}

#endif
