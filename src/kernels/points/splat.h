/* Splatting: draws every point as a square into every face that may see it, by the 64-bit minimum of distance << 32 |
 * point (EPR section 3.5; METHODS 2). A splat has one distance, unless plane_depth asks for that of its plane. The
 * kernels do not read the members pixels, view and n_pixels, which serve the fast path of C that leaves texels out, and
 * n_pieces, the number of items of splat_pieces. */
#ifndef TS_KERNELS_POINTS_SPLAT_H
#define TS_KERNELS_POINTS_SPLAT_H
#include "kernels/base/args.h"
#include "kernels/points/flight.h"
#include "kernels/points/splat_box.h"
#include "kernels/raster/visibility.h"

#define TS_ROWS_ts_splat_args(ARG) \
	ARG(INNER, ts_points_args, from, none) /* points; offset NULL: they are in no order */ \
	ARG(IN, ts_face, cubes, cube_size_face) \
	ARG(IN, u64, bits, visibility_bits)             /* by triangle */ \
	ARG(IN_PARTS_OPT, u32, colours, forward_colour) /* of the points */ \
	ARG(MIN_PARTS, u64, texels, splat_depth_index) \
	ARG(SUM_PARTS_OPT, u8, tie, splat_tie) \
	ARG(IN_OPT, ts_pixel, pixels, \
	    mirror_pixel_record) /* their samples alone read the texels, so others may stay empty */ \
	ARG(IN_OPT, ts_view, view, eye_view) \
	ARG(TALLY, i64, n_scatters, 0) \
	ARG(TALLY, i64, n_writes, 1) /* splats; texels that these were offered to */ \
	ARG(VALUE, u32, n_cubes, none) \
	ARG(VALUE, u32, n_words, none) \
	ARG(VALUE, u32, n_pieces, none) \
	ARG(VALUE, u32, clip, none) \
	ARG(VALUE, f32, inset, none) /* of a square's box, TS_SPLAT_INSET; 0: texels that the box touches belong */ \
	ARG(VALUE, u32, n_pixels, none) \
	ARG(VALUE, u32, plane_depth, none) \
	ARG(VALUE, u32, coloured, none) /* not 0: texels hold the points' colours, not their indices */ \
	ARG(VALUE, u32, mark, none)     /* not 0: the texels are complete; mark ties */
TS_ARGS(ts_splat_args);

/* Offers a key to a texel; the least key wins. The pass that marks ties marks a texel where a key lost only by its
 * index. */
TS_FN void ts_k_splat_offer(const ts_splat_args *args, u64 texel, u64 key)
{
	TS_GLOBAL u64 *least = ts_at(args->texels, texel);
	if (args->mark == 0u) {
		ts_min_u64(least, key);
	} else if (key != *least && (key >> 32) == (*least >> 32)) {
		ts_mark_u8(ts_at(args->tie, texel));
	}
}

/* The low half of a key: the index of a point, or its colour. */
TS_FN u32 ts_k_splat_word(const ts_splat_args *args, u32 index)
{
	return args->coloured != 0u ? *ts_at(args->colours, index) : index;
}

/* Splats one point into the face whose texels begin at `first`. Returns the number of texels offered to. */
TS_FN u32 ts_k_splat(const ts_splat_args *args, const ts_camera_k *view, const ts_cover *triangle,
                     const ts_flight *point, u32 word, u64 first)
{
	/* Bound the projected square (EPR 3.5); with clipping, or if tiny (splat.size=safe), within the piece's box. */
	ts_v3 c = point->centre;
	ts_square square =
		ts_k_square(&args->from.pieces[point->piece], &args->from.frames[point->piece], c, point->length);
	ts_box box = ts_k_splat_box(view, &square, args->inset);
	if (args->clip != 0u || (point->flags & TS_POINT_TINY) != 0u) box = ts_k_box_meet(box, triangle->touched);
	/* Give the splat one distance: radial, of its centre (CONTRACT rule 26). */
	f32 distance = ts_put(ts_length(ts_sub(c, view->eye)));
	ts_v3 n = ts_cross(square.u, square.v);
	u32 count = 0u;
	for (i32 j = box.y0; j <= box.y1; j++) {
		for (i32 i = box.x0; i <= box.x1; i++) {
			/* Clip against the triangle's edges (EPR 3.5). */
			if (args->clip != 0u && !ts_k_touches(triangle, i, j)) continue;
			/* Offer the distance and the point; the least key wins (CONTRACT rule 24). */
			f32 d = distance;
			if (args->plane_depth != 0u) d = ts_put(ts_k_plane_distance(view, n, c, distance, point->length, i, j));
			ts_k_splat_offer(args, first + (u64)j * (u64)view->width + (u64)i, ((u64)ts_f2u(d) << 32) | word);
			count++;
		}
	}
	return count;
}

/* Splats one point into every face that may see its triangle; *scatters: number of these faces. Returns the number of
 * texels offered to. */
TS_CALL i64 ts_k_splat_everywhere(const ts_splat_args *args, const ts_flight *point, u32 word, i64 *scatters)
{
	/* Find the faces whose bits the triangle has. */
	TS_GLOBAL const ts_piece *piece = &args->from.pieces[point->piece];
	TS_GLOBAL const u64 *words = args->bits + (u64)piece->triangle * args->n_words;
	i64 writes = 0;
	for (u32 r = 0u; r < args->n_cubes; r++) {
		u32 faces = ts_k_cube_bits(words, r);
		TS_GLOBAL const ts_face *cube = &args->cubes[r];
		for (u32 face = 0u; faces != 0u; face++, faces >>= 1) {
			if ((faces & 1u) == 0u) continue;
			/* Clip the piece to the range of snapping (rule 16); if nothing is left, its points have no splat. */
			ts_camera_k view = ts_k_cube_view(cube, face);
			ts_cover triangle = ts_k_splat_triangle(&view, piece);
			if (triangle.n == 0u) continue;
			/* Splat into the face's texels. */
			u64 offset = cube->offset + (u64)face * cube->n * cube->n;
			*scatters += 1;
			writes += ts_k_splat(args, &view, &triangle, point, word, offset);
		}
	}
	return writes;
}

/* scatter over stored points */
TS_FN void ts_k_splat_item(const ts_splat_args *args, u64 i)
{
	i64 scatters = 0;
	ts_flight point = ts_k_flight_record(&args->from, i);
	i64 writes = ts_k_splat_everywhere(args, &point, ts_k_splat_word(args, (u32)i), &scatters);
	ts_add_i64(args->n_scatters, scatters);
	ts_add_i64(args->n_writes, writes);
}

/* scatter over pieces: their points are made, splatted and not stored; texels hold the indices that stored points would
 * have */
TS_FN void ts_k_splat_fragments_item(const ts_splat_args *args, u64 i)
{
	/* Leave out a piece without points. */
	u32 index = args->from.offset[i];
	if (args->from.offset[i + 1u] == index) return;
	/* Set what the piece's points have in common. */
	ts_cover cover = ts_k_lattice_cover(&args->from.frames[i], args->from.half_size);
	ts_flight point = ts_k_flight_of_piece(&args->from, i);
	i64 scatters = 0;
	i64 writes = 0;
	/* Make each point, and splat it at once (EPR 3.4). */
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(&args->from, &cover, i, x, y)) continue;
			ts_k_flight_start(&args->from, &point, x, y);
			writes += ts_k_splat_everywhere(args, &point, index, &scatters);
			index++;
		}
	}
	ts_add_i64(args->n_scatters, scatters);
	ts_add_i64(args->n_writes, writes);
}

#endif
