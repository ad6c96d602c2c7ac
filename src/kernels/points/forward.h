/* Forward shading: every point is lit once, however many texels it fills; a texel holds its colour beside its distance
 * (EPR section 3.5; METHODS 18). A colour has 32 bits, like the index of a point (colour_code.h). */
#ifndef TS_KERNELS_POINTS_FORWARD_H
#define TS_KERNELS_POINTS_FORWARD_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/points/colour_code.h"
#include "kernels/points/flight.h"
#include "kernels/raster/visibility.h"

#define TS_ROWS_ts_forward_args(ARG) \
	ARG(INNER, ts_points_args, from, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, ts_face, cubes, cube_size_face) \
	ARG(IN, u64, bits, visibility_bits) /* by triangle */ \
	ARG(OUT_PARTS, u32, colours, forward_colour) \
	ARG(VALUE, u32, n_cubes, none) \
	ARG(VALUE, u32, n_words, none) \
	ARG(VALUE, u32, for_eye, none) /* not 0: points are lit for the eye, not for the mirror of the shortest way */
TS_ARGS(ts_forward_args);

/* The centre of the mirror with the shortest way from the point to the eye, d_er + d_rt (eq. 2), of the mirrors that
 * may see the point; the eye itself where none does. */
TS_FN ts_v3 ts_k_forward_mirror(const ts_forward_args *args, const ts_flight *point)
{
	/* Begin with the eye, for points that no mirror sees. */
	TS_GLOBAL const u64 *words = args->bits + (u64)args->from.pieces[point->piece].triangle * args->n_words;
	ts_v3 eye = ts_load3(args->view->eye);
	ts_v3 nearest = eye;
	f32 shortest = 0.0f;
	bool any = false;
	for (u32 r = 0u; r < args->n_cubes; r++) {
		if (ts_k_cube_bits(words, r) == 0u) continue;
		/* Measure the way d_er + d_rt by the mirror's centre (EPR 4.1.1, eq. 2). */
		ts_v3 centre = ts_load3(args->cubes[r].centre);
		f32 way = ts_length(ts_sub(centre, eye)) + ts_length(ts_sub(point->centre, centre));
		/* Keep the shortest; of equal ways the first mirror's. */
		if (any && !(way < shortest)) continue;
		nearest = centre;
		shortest = way;
		any = true;
	}
	return nearest;
}

/* map over stored points: their colours */
TS_FN void ts_k_forward_item(const ts_forward_args *args, u64 i)
{
	ts_flight point = ts_k_flight_stored(&args->from, i);
	ts_surface surface = ts_k_flight_surface(&args->from, &point);
	ts_v3 viewer = args->for_eye != 0u ? ts_load3(args->view->eye) : ts_k_forward_mirror(args, &point);
	ts_v3 radiance = ts_k_shade(&args->from.scene, &surface, ts_normalize(ts_sub(viewer, surface.p)));
	*ts_at(args->colours, i) = ts_k_shared_code(radiance);
}

#endif
