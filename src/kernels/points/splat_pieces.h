/* Splats the points of a piece together, with the bits of splat.h: what depends only on the piece and the face is
 * computed once. Edges become lines in (i, j). Since the axes of a cube's face are those of the world except for sign
 * and order, the corners of a square need no products. */
#ifndef TS_KERNELS_POINTS_SPLAT_PIECES_H
#define TS_KERNELS_POINTS_SPLAT_PIECES_H
#include "kernels/points/splat.h"

/* A piece in the view of one face. */
typedef struct {
	ts_camera_k view;
	ts_row right, up, ahead;
	ts_cover cover;
	ts_lines lines;
	ts_v3 u, v, n;
	ts_v3 du, dv; /* half a square's sides; all points of a piece have the same length */
	f32 slack;
	u64 first; /* texel */
} ts_piece_view;

/* One coordinate of a square's corners: ((c -+ du) -+ dv) - eye. */
TS_FN void ts_k_square_axis(f32 corner[4], const ts_piece_view *f, ts_row row, ts_v3 centre)
{
	f32 c = ts_k_along(centre, row.axis);
	f32 du = ts_k_along(f->du, row.axis);
	f32 dv = ts_k_along(f->dv, row.axis);
	f32 eye = ts_k_along(f->view.eye, row.axis);
	f32 low = c - du;
	f32 high = c + du;
	corner[0] = ((low - dv) - eye) * row.sign;
	corner[1] = ((high - dv) - eye) * row.sign;
	corner[2] = ((high + dv) - eye) * row.sign;
	corner[3] = ((low + dv) - eye) * row.sign;
}

/* ts_k_splat_box of a point of the piece. */
TS_FN ts_box ts_k_piece_box(const ts_piece_view *f, ts_v3 c, f32 length, f32 widest)
{
	f32 x[4], y[4], z[4];
	/* Leave a square that crosses the near plane to ts_k_splat_box, which clips. */
	ts_k_square_axis(z, f, f->ahead, c);
	f32 ahead = ts_min(ts_min(z[0], z[1]), ts_min(z[2], z[3]));
	if (ts_flush(ahead - f->view.near) < 0.0f) {
		ts_square square;
		square.c = c;
		square.u = f->u;
		square.v = f->v;
		square.length = length;
		square.slack = f->slack;
		return ts_k_splat_box(&f->view, &square, widest);
	}
	/* Project the corners, by ts_k_project's operations. */
	ts_k_square_axis(x, f, f->right, c);
	ts_k_square_axis(y, f, f->up, c);
	f32 size = (f32)f->view.width;
	f32 middle = size * 0.5f;
	for (u32 k = 0u; k < 4u; k++) {
		x[k] = middle + (f->view.focal * x[k]) / z[k];
		y[k] = middle - (f->view.focal * y[k]) / z[k];
	}
	/* Take texels whose centres lie in the box, as ts_k_splat_box does. */
	f32 inset = ts_k_box_inset(widest, f->view.focal, f->slack, ahead);
	ts_box r;
	r.x0 = ts_k_floor_within(ts_min(ts_min(x[0], x[1]), ts_min(x[2], x[3])) + inset, size);
	r.y0 = ts_k_floor_within(ts_min(ts_min(y[0], y[1]), ts_min(y[2], y[3])) + inset, size);
	r.x1 = ts_k_floor_within(ts_max(ts_max(x[0], x[1]), ts_max(x[2], x[3])) - inset, size);
	r.y1 = ts_k_floor_within(ts_max(ts_max(y[0], y[1]), ts_max(y[2], y[3])) - inset, size);
	return ts_k_box_meet(r, ts_k_view_box(&f->view));
}

/* Splats point `index` of the piece. Returns the number of texels offered to. */
TS_FN u32 ts_k_piece_point(const ts_splat_args *args, const ts_piece_view *f, u32 index)
{
	/* Bound the projected square (EPR 3.5); with clipping, or if tiny (splat.size=safe), within the piece's box. */
	TS_GLOBAL const ts_point *point = ts_at(args->from.points, index);
	ts_v3 c = ts_load3(point->centre);
	f32 length = point->length;
	bool clip = args->clip != 0u;
	ts_box box = ts_k_piece_box(f, c, length, args->inset);
	if (clip || (point->flags & TS_POINT_TINY) != 0u) box = ts_k_box_meet(box, f->cover.touched);
	/* Give the splat one distance: radial, of its centre (CONTRACT rule 26). */
	f32 distance = ts_put(ts_length(ts_sub(c, f->view.eye)));
	u32 word = ts_k_splat_word(args, index);
	u32 count = 0u;
	for (i32 j = box.y0; j <= box.y1; j++) {
		u64 row = f->first + (u64)j * (u64)f->view.width;
		for (i32 i = box.x0; i <= box.x1; i++) {
			/* Clip against the triangle's edges (EPR 3.5). */
			if (clip && !ts_k_inside_lines(&f->lines, i, j)) continue;
			/* Offer the distance and the point; the least key wins (CONTRACT rule 24). */
			f32 d = distance;
			if (args->plane_depth != 0u) d = ts_put(ts_k_plane_distance(&f->view, f->n, c, distance, length, i, j));
			ts_min_u64(ts_at(args->texels, row + (u64)i), ((u64)ts_f2u(d) << 32) | word);
			count++;
		}
	}
	return count;
}

/* Returns false if the face does not see the piece, or no splat reaches a texel. *scatters: number of splats, as the
 * kernel splat counts them. */
TS_FN bool ts_k_piece_view(ts_piece_view *f, const ts_splat_args *args, u64 piece, u32 r, u32 face, i64 *scatters)
{
	/* Clip the piece to the range of snapping (rule 16); if nothing is left, its points have no splat. */
	TS_GLOBAL const ts_face *cube = &args->cubes[r];
	f->view = ts_k_cube_view(cube, face);
	f->cover = ts_k_splat_triangle(&f->view, &args->from.pieces[piece]);
	if (f->cover.n == 0u) return false;
	*scatters += args->from.offset[piece + 1u] - args->from.offset[piece];
	/* Leave out a piece that clipping keeps off the face. */
	ts_box box = ts_k_box_meet(f->cover.touched, ts_k_view_box(&f->view));
	if (args->clip != 0u && (box.x1 < box.x0 || box.y1 < box.y0)) return false;
	/* Name the face's axes, and write the edges as lines. */
	f->right = ts_k_row(f->view.right);
	f->up = ts_k_row(f->view.up);
	f->ahead = ts_k_row(ts_neg(f->view.back));
	ts_k_lines(&f->lines, &f->cover);
	/* Set what the squares of the piece's points share. */
	f->u = ts_load3(args->from.frames[piece].u);
	f->v = ts_load3(args->from.frames[piece].v);
	f->n = ts_cross(f->u, f->v);
	f32 half_length = ts_at(args->from.points, args->from.offset[piece])->length * 0.5f;
	f->du = ts_scale(f->u, half_length);
	f->dv = ts_scale(f->v, half_length);
	f->slack = ts_k_piece_slack(&args->from.pieces[piece]);
	f->first = cube->offset + (u64)face * cube->n * cube->n;
	return true;
}

/* scatter over pieces: does what the kernel splat does to their points, which args->from.offset finds */
TS_FN void ts_k_splat_pieces_item(const ts_splat_args *args, u64 i)
{
	/* Leave out a piece without points. */
	u32 begin = args->from.offset[i];
	u32 end = args->from.offset[i + 1u];
	if (begin == end) return;
	/* Find the faces whose bits the triangle has. */
	TS_GLOBAL const u64 *words = args->bits + (u64)args->from.pieces[i].triangle * args->n_words;
	i64 scatters = 0;
	i64 writes = 0;
	for (u32 r = 0u; r < args->n_cubes; r++) {
		u32 faces = ts_k_cube_bits(words, r);
		for (u32 face = 0u; faces != 0u; face++, faces >>= 1) {
			/* Prepare the piece in the face's view, and splat its points. */
			ts_piece_view f;
			if ((faces & 1u) == 0u || !ts_k_piece_view(&f, args, i, r, face, &scatters)) continue;
			for (u32 p = begin; p < end; p++) writes += ts_k_piece_point(args, &f, p);
		}
	}
	ts_add_i64(args->n_scatters, scatters);
	ts_add_i64(args->n_writes, writes);
}

#endif
