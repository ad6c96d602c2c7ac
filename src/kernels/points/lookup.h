/* Eye-based deferred shading: the samples of reflective pixels look up points in cubes, samples that find a point on a
 * mirror are queued for the next bounce, and every sample takes the colour of its point (EPR sections 4.1.2 to 4.1.4;
 * METHODS 2). */
#ifndef TS_KERNELS_POINTS_LOOKUP_H
#define TS_KERNELS_POINTS_LOOKUP_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/points/colour_code.h"
#include "kernels/points/flight.h"
#include "kernels/points/samples.h"
#include "kernels/raster/cube.h"

#define TS_ROWS_ts_lookup_args(ARG) \
	ARG(INNER, ts_points_args, from, none) \
	ARG(IN_OPT, ts_view, view, eye_view) \
	ARG(IN, ts_face, cubes, cube_size_face) \
	ARG(IN_PARTS_OPT, u64, texels, splat_depth_index) \
	ARG(IN, ts_pixel, pixels, mirror_pixel_record) \
	ARG(IN_OPT, ts_bounce, queue, none) /* entries of this bounce; none at the first */ \
	ARG(OUT_OPT, u32, found, none)      /* points, or their colours, that the samples of this bounce see */ \
	ARG(OUT_OPT, u32, offset, none)     /* entries of the next bounce before each sample */ \
	ARG(OUT_OPT, ts_bounce, next_queue, none) \
	ARG(IN_OPT, f32, next_radiance, none) \
	ARG(OUT_OPT, f32, radiance, none)        /* of this bounce's entries */ \
	ARG(OUT_OPT, u32, used, shade_n_samples) /* samples shaded; first bounce only */ \
	ARG(VALUE, u32, n_pieces, none)          /* pieces from which points are made again; 0: points are stored */ \
	ARG(VALUE, u32, coloured, none)          /* not 0: texels hold colours */ \
	ARG(VALUE, u32, n_samples, none)         /* per entry: 25 at the first bounce, then 4 */ \
	ARG(VALUE, u32, first, none)             /* not 0: the first bounce, whose entries are pixels */ \
	ARG(VALUE, u32, follow, none)            /* not 0: there is a next bounce */ \
	ARG(VALUE, u32, adaptive, none)
TS_ARGS(ts_lookup_args);

/* What the texel in a direction from a cube's centre holds: a point, or its colour; TS_NONE where it is empty. */
TS_FN u32 ts_k_lookup(const ts_lookup_args *args, u32 cube_index, ts_v3 direction)
{
	TS_GLOBAL const ts_face *cube = &args->cubes[cube_index];
	if (cube->n == 0u) return TS_NONE;
	u64 texel = cube->offset + ts_k_cube_index(ts_k_cube_place(direction), cube->n);
	return (u32)*ts_at(args->texels, texel); /* an empty texel's low half is TS_NONE */
}

/* map over reflective pixels */
TS_FN void ts_k_lookup_item(const ts_lookup_args *args, u64 i)
{
	TS_GLOBAL const ts_pixel *pixel = &args->pixels[i];
	ts_v3 eye = ts_load3(args->view->eye);
	for (u32 k = 0u; k < args->n_samples; k++) {
		ts_ray ray = ts_k_sample_ray(pixel, eye, k);
		args->found[i * args->n_samples + k] = ts_k_lookup(args, pixel->reflector, ray.direction);
	}
}

/* The triangle of a point, stored or not. */
TS_FN u32 ts_k_point_triangle(const ts_lookup_args *args, u32 point)
{
	u32 piece = args->n_pieces != 0u ? ts_k_piece_of(&args->from, args->n_pieces, point)
	                                 : ts_at(args->from.points, point)->piece;
	return args->from.pieces[piece].triangle;
}

TS_FN ts_surface ts_k_point_surface(const ts_lookup_args *args, u32 point)
{
	ts_flight seen = ts_k_flight_at(&args->from, args->n_pieces, point);
	return ts_k_flight_surface(&args->from, &seen);
}

/* map over samples: 1 where the point that was found is on a mirror */
TS_FN void ts_k_bounce_count_item(const ts_lookup_args *args, u64 i)
{
	u32 point = args->found[i];
	u32 mirror = point == TS_NONE ? TS_NONE : ts_k_reflector_of(&args->from.scene, ts_k_point_triangle(args, point));
	args->offset[i] = mirror != TS_NONE ? 1u : 0u;
}

/* The cube that the samples of an entry look up: that of the mirror on which the entry lies. */
TS_FN u32 ts_k_cube_read(const ts_lookup_args *args, u64 entry)
{
	return args->first != 0u ? args->pixels[entry].reflector : args->queue[entry].reflector;
}

/* emit over samples: the queue of the next bounce */
TS_FN void ts_k_bounce_queue_item(const ts_lookup_args *args, u64 i)
{
	if (args->offset[i + 1u] == args->offset[i]) return;
	TS_GLOBAL ts_bounce *out = &args->next_queue[args->offset[i]];
	out->parent = (u32)i;
	out->point = args->found[i];
	out->reflector = ts_k_reflector_of(&args->from.scene, ts_k_point_triangle(args, args->found[i]));
	out->from = ts_k_cube_read(args, i / args->n_samples);
}

/* map over queue entries */
TS_FN void ts_k_bounce_item(const ts_lookup_args *args, u64 i)
{
	TS_GLOBAL const ts_bounce *entry = &args->queue[i];
	ts_flight point = ts_k_flight_at(&args->from, args->n_pieces, entry->point);
	TS_GLOBAL const ts_align *frame = &args->from.frames[point.piece];
	ts_surface surface = ts_k_flight_surface(&args->from, &point);
	ts_v3 from = ts_load3(args->cubes[entry->from].centre);
	ts_v3 n = ts_k_facing_normal(&surface, ts_sub(from, surface.p));
	f32 radius = args->cubes[entry->reflector].radius;
	f32 spread = radius > 0.0f ? point.length / radius : 0.0f;
	for (u32 k = 0u; k < args->n_samples; k++) {
		ts_v3 direction = ts_k_bounce_direction(surface.p, n, ts_load3(frame->u), ts_load3(frame->v), from, spread, k);
		args->found[i * args->n_samples + k] = ts_k_lookup(args, entry->reflector, direction);
	}
}

/* Whether the sample gets its colour from the next bounce. */
TS_FN bool ts_k_is_followed(const ts_lookup_args *args, u64 sample)
{
	return args->follow != 0u && args->offset[sample + 1u] != args->offset[sample];
}

/* The colour of one sample: that of the next bounce, that of its point as seen from the cube's centre, or the
 * background. */
TS_FN ts_v3 ts_k_sample_radiance(const ts_lookup_args *args, u64 sample, ts_v3 centre)
{
	u32 point = args->found[sample];
	if (point == TS_NONE) return ts_k_background();
	if (args->coloured != 0u) return ts_k_shared_radiance(point);
	if (ts_k_is_followed(args, sample)) return ts_load3(args->next_radiance + (u64)args->offset[sample] * 3u);
	ts_surface surface = ts_k_point_surface(args, point);
	return ts_k_shade(&args->from.scene, &surface, ts_normalize(ts_sub(centre, surface.p)));
}

/* The colour of sample k. Samples of an entry that see the same point and are not followed have the same colour; `seen`
 * holds the colours of the samples before k. */
TS_FN ts_v3 ts_k_next_radiance(const ts_lookup_args *args, u64 first, u32 k, ts_v3 centre, const ts_v3 *seen)
{
	u32 same = ts_k_is_followed(args, first + k) ? k : 0u;
	while (same < k && (args->found[first + same] != args->found[first + k] || ts_k_is_followed(args, first + same)))
		same++;
	return same < k ? seen[same] : ts_k_sample_radiance(args, first + k, centre);
}

/* The variance of n numbers r + g + b, from their sum and the sum of their squares (EPR 4.1.3: "until color variance
 * stopped declining"). */
TS_FN f32 ts_k_variance(f32 sum, f32 squares, u32 n)
{
	f32 count = (f32)n;
	f32 mean = sum / count;
	return ts_flush(squares / count - mean * mean);
}

/* The mean of an entry's samples in ascending order; adaptively in batches of four. *used: number of samples that were
 * used. */
TS_FN ts_v3 ts_k_mean_radiance(const ts_lookup_args *args, u64 entry, ts_v3 centre, u32 *used)
{
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	f32 grey_sum = 0.0f;
	f32 grey_squares = 0.0f;
	f32 before = 0.0f;
	ts_v3 seen[TS_N_SAMPLES];
	u32 n = 0u;
	while (n < args->n_samples) {
		/* Add the colour of the next sample. */
		ts_v3 radiance = ts_k_next_radiance(args, entry * args->n_samples, n, centre, seen);
		sum = ts_add(sum, radiance);
		seen[n] = radiance;
		n++;
		/* Add to the sums for the variance of r + g + b. */
		f32 grey = ts_flush((radiance.x + radiance.y) + radiance.z);
		grey_sum = grey_sum + grey;
		grey_squares = grey_squares + ts_flush(grey * grey);
		/* Stop after a batch of four in which the variance stopped declining (EPR 4.1.3). */
		if (args->adaptive == 0u || (n & 3u) != 0u) continue;
		f32 variance = ts_k_variance(grey_sum, grey_squares, n);
		if (n > 4u && !(variance < before)) break;
		before = variance;
	}
	/* Divide once, by the number of samples used (CONTRACT rule 39). */
	*used = n;
	f32 count = (f32)n;
	return ts_v3_make(sum.x / count, sum.y / count, sum.z / count);
}

/* Stores the mean of an entry's samples, tinted by its mirror. */
TS_FN void ts_k_shade_put(const ts_lookup_args *args, u64 entry, ts_v3 mean, u32 used)
{
	ts_v3 tint;
	if (args->first != 0u) {
		TS_GLOBAL const ts_pixel *pixel = &args->pixels[entry];
		tint = ts_v3_make(pixel->tint_r, pixel->tint_g, pixel->tint_b);
		args->used[entry] = used;
	} else {
		tint = ts_k_point_surface(args, args->queue[entry].point).base;
	}
	ts_store3(args->radiance + entry * 3u, ts_mul(mean, tint));
}

/* map over entries: pixels at the first bounce, queue entries after it */
TS_FN void ts_k_shade_item(const ts_lookup_args *args, u64 i)
{
	ts_v3 centre = ts_load3(args->cubes[ts_k_cube_read(args, i)].centre);
	u32 used;
	ts_v3 mean = ts_k_mean_radiance(args, i, centre, &used);
	ts_k_shade_put(args, i, mean, used);
}

#endif
