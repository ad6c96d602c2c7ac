/* Splats points, made for the eye's resolution, into the depth maps of cubes (EPR section 5.1; METHODS 10). A point
 * whose splat is smaller than a texel is written into its texel (scatter.h), a larger one as a square of depths
 * (splat_box.h).
 *
 * The shadow test compares the depth of a receiver with that of each texel, so one depth for a splat of many texels
 * would throw shadows on the surface itself. Each texel therefore gets the depth of the piece's plane, clamped to the
 * depths of the piece's corners. */
#ifndef TS_KERNELS_POINTS_SHADOW_SPLAT_H
#define TS_KERNELS_POINTS_SHADOW_SPLAT_H
#include "kernels/base/args.h"
#include "kernels/points/plane.h"
#include "kernels/points/scatter.h"
#include "kernels/points/splat_box.h"

#define TS_ROWS_ts_shadow_splat_args(ARG) \
	ARG(INNER, ts_scatter_args, of, none) /* of depths; its n_writes are those of points smaller than a texel */ \
	ARG(TALLY, i64, n_splats, 3) \
	ARG(TALLY, i64, n_texels, 4) /* points larger than a texel; texels that these were offered to */ \
	ARG(VALUE, u32, clip, none) \
	ARG(VALUE, f32, inset, none) /* as of splat */ \
	ARG(VALUE, u32, plane_depth, none)
TS_ARGS(ts_shadow_splat_args);

typedef struct {
	ts_scatter_tally of;
	i64 splats, texels;
} ts_shadow_tally;

/* A piece in a depth map's view. The members after has_cover are made for the piece's first splat; points smaller than
 * a texel do not need them. */
typedef struct {
	TS_GLOBAL const ts_offscreen *offscreen;
	ts_camera_k view;
	bool misses, has_cover;
	ts_cover cover;
	ts_image_plane plane;
	f32 nearest, farthest;
} ts_shadow_caster;

/* Whether the whole piece lies so far outside one plane of the view that no point reaches in. Points and the corners of
 * their splats are within 1.5 cells of the piece, which is 1.5 sqrt(1 + reach^2) in x - reach z. */
TS_FN bool ts_k_misses(const ts_camera_k *view, TS_GLOBAL const ts_offscreen *offscreen,
                       TS_GLOBAL const ts_piece *piece, f32 cell)
{
	ts_corner corner[3];
	/* Move the corners into the view. */
	corner[0] = ts_k_to_view(view, ts_load3(piece->a));
	corner[1] = ts_k_to_view(view, ts_load3(piece->b));
	corner[2] = ts_k_to_view(view, ts_load3(piece->c));
	/* Allow for 1.5 sqrt(1 + reach^2) cells beside the piece, which is less than 2 (1 + reach) of them. */
	f32 x = offscreen->reach[0];
	f32 y = offscreen->reach[1];
	f32 past_x = (2.0f * cell) * (1.0f + x);
	f32 past_y = (2.0f * cell) * (1.0f + y);
	/* Keep the planes beyond which all corners lie, a bit each; 31 has all five. */
	u32 outside = 31u;
	for (u32 k = 0u; k < 3u; k++) {
		const ts_corner *p = &corner[k];
		u32 of = p->x - x * p->z > past_x ? 1u : 0u;
		of |= -p->x - x * p->z > past_x ? 2u : 0u;
		of |= p->y - y * p->z > past_y ? 4u : 0u;
		of |= -p->y - y * p->z > past_y ? 8u : 0u;
		of |= p->z < view->near - 2.0f * cell ? 16u : 0u;
		outside &= of;
	}
	return outside != 0u;
}

/* Begins a piece in the depth map of view v. */
TS_FN ts_shadow_caster ts_k_shadow_caster(const ts_scatter_args *args, u32 v, const ts_flight *point)
{
	ts_shadow_caster r;
	r.offscreen = &args->views[v];
	r.view = ts_k_offscreen(r.offscreen);
	f32 cell = 1.0f / args->from.frames[point->piece].s;
	r.misses = ts_k_misses(&r.view, r.offscreen, &args->from.pieces[point->piece], cell);
	r.has_cover = false;
	r.cover.n = 0u;
	r.nearest = 0.0f;
	r.farthest = 0.0f;
	return r;
}

/* Makes what the splats of a piece share in a view. */
TS_FN void ts_k_shadow_cover(const ts_scatter_args *args, ts_shadow_caster *caster, u64 index)
{
	/* Clip the piece; of a piece behind the view nothing is drawn. */
	TS_GLOBAL const ts_piece *piece = &args->from.pieces[index];
	TS_GLOBAL const ts_align *frame = &args->from.frames[index];
	caster->has_cover = true;
	ts_polygon t = ts_k_polygon(&caster->view, ts_load3(piece->a), ts_load3(piece->b), ts_load3(piece->c));
	ts_k_clip_to_range(&caster->view, &t);
	if (t.n == 0u) return;
	/* Snap the outline, and find the plane, by the lattice's axes. */
	caster->cover = ts_k_cover_of(&caster->view, &t, TS_SAFE_HALF);
	caster->plane =
		ts_k_image_plane(&caster->view, ts_load3(piece->a), ts_cross(ts_load3(frame->u), ts_load3(frame->v)));
	/* Bound the depths of the corners. */
	caster->nearest = t.corner[0].z;
	caster->farthest = t.corner[0].z;
	for (u32 k = 1u; k < t.n; k++) {
		caster->nearest = ts_min(caster->nearest, t.corner[k].z);
		caster->farthest = ts_max(caster->farthest, t.corner[k].z);
	}
}

/* Whether the splat is no longer than a texel from corner to corner, at a scale from the plane to the image of at most
 * f d / z^2; then the lattice has a point in each texel. A reserve of 1/128 covers rounding and the change of the scale
 * from a texel's middle to its border, which is at most 1/(4 f): on faces under 64 texels some points at the border are
 * written alone that should be splats. */
TS_FN bool ts_k_is_within_texel(const ts_camera_k *view, const ts_corner *p, f32 length)
{
	if (p->z < view->near) return false;
	f32 over_z = 1.0f / p->z;
	f32 d = ts_length(ts_v3_make(p->x, p->y, p->z)) * over_z;
	f32 scale = view->focal * (over_z * d);
	return (length * 1.42526209354400634765625f) * scale <= 1.0f;
}

/* The depth of a texel: that of the piece's plane, within the depths of the piece's corners; or the point's own. */
TS_FN f32 ts_k_shadow_depth(const ts_shadow_splat_args *args, const ts_shadow_caster *caster, f32 own, i32 i, i32 j)
{
	if (args->plane_depth == 0u) return own;
	f32 z = ts_k_plane_depth(&caster->view, &caster->plane, (f32)i + 0.5f, (f32)j + 0.5f, own);
	return ts_clamp(z, caster->nearest, caster->farthest);
}

/* Splats one point as a square about its place in the lattice; the squares tile the plane. Returns the number of texels
 * offered to. */
TS_FN u32 ts_k_shadow_square(const ts_shadow_splat_args *args, const ts_shadow_caster *caster, const ts_flight *point,
                             f32 own)
{
	/* Bound the projected square; with clipping, or if tiny, within the piece's box. */
	TS_GLOBAL const ts_align *frame = &args->of.from.frames[point->piece];
	const ts_camera_k *view = &caster->view;
	ts_v3 c = ts_k_lattice_point(frame, point->x, point->y);
	ts_square square = ts_k_square(&args->of.from.pieces[point->piece], frame, c, point->length);
	ts_box box = ts_k_splat_box(view, &square, args->inset);
	if (args->clip != 0u || (point->flags & TS_POINT_TINY) != 0u) box = ts_k_box_meet(box, caster->cover.touched);
	/* Use the point's own depth where the plane is not met, but none before the near plane. */
	u64 first = caster->offscreen->offset - args->of.views[args->of.first_view].offset;
	f32 least = ts_max(own, view->near);
	u32 count = 0u;
	for (i32 j = box.y0; j <= box.y1; j++) {
		for (i32 i = box.x0; i <= box.x1; i++) {
			/* Clip against the triangle's edges, and offer the depth (EPR 3.5). */
			if (args->clip != 0u && !ts_k_touches(&caster->cover, i, j)) continue;
			f32 z = ts_k_shadow_depth(args, caster, least, i, j);
			ts_min_u32(&args->of.depths[first + (u64)j * (u64)view->width + (u64)i], ts_f2u(ts_put(z)));
			count++;
		}
	}
	return count;
}

/* Splats one point into one view. */
TS_CALL void ts_k_shadow_splat_into(const ts_shadow_splat_args *args, ts_shadow_caster *caster, const ts_flight *point,
                                    ts_shadow_tally *tally)
{
	/* Write a point whose splat is within a texel alone (EPR 5.1). */
	ts_corner p = ts_k_to_view(&caster->view, point->centre);
	tally->of.scatters++;
	if (ts_k_is_within_texel(&caster->view, &p, point->length)) {
		u64 first = args->of.views[args->of.first_view].offset;
		tally->of.writes += ts_k_scatter_into(&args->of, caster->offscreen, point, first);
		return;
	}
	/* Draw a larger splat as a square of depths. */
	if (!caster->has_cover) ts_k_shadow_cover(&args->of, caster, point->piece);
	if (caster->cover.n == 0u) return;
	u32 texels = ts_k_shadow_square(args, caster, point, p.z);
	tally->splats += texels != 0u ? 1 : 0;
	tally->texels += texels;
}

TS_FN ts_shadow_tally ts_k_shadow_none(void)
{
	ts_shadow_tally r;
	r.of = ts_k_scatter_none();
	r.splats = 0;
	r.texels = 0;
	return r;
}

TS_FN void ts_k_shadow_count(const ts_shadow_splat_args *args, const ts_shadow_tally *tally)
{
	ts_k_scatter_count(&args->of, &tally->of);
	ts_add_i64(args->n_splats, tally->splats);
	ts_add_i64(args->n_texels, tally->texels);
}

/* scatter over stored points */
TS_FN void ts_k_shadow_splat_item(const ts_shadow_splat_args *args, u64 i)
{
	ts_flight point = ts_k_flight_stored(&args->of.from, i);
	TS_GLOBAL const u64 *words = args->of.bits + (u64)args->of.from.pieces[point.piece].triangle * args->of.n_words;
	ts_shadow_tally tally = ts_k_shadow_none();
	tally.of.points = 1;
	for (u32 v = args->of.first_view; v < args->of.first_view + args->of.n_views; v++) {
		if (!ts_k_offscreen_bit(words, v)) continue;
		ts_shadow_caster caster = ts_k_shadow_caster(&args->of, v, &point);
		if (!caster.misses) ts_k_shadow_splat_into(args, &caster, &point, &tally);
	}
	ts_k_shadow_count(args, &tally);
}

/* Number of views for which a piece's points are made at a time. */
#define TS_SHADOW_GROUP 8u
typedef struct {
	ts_shadow_caster caster[TS_SHADOW_GROUP];
	u32 n;
} ts_shadow_group;

/* Splats all points of a band of a piece into the views of a group, and empties the group. */
TS_FN void ts_k_shadow_piece_into(const ts_shadow_splat_args *args, const ts_cover *cover, ts_flight *point,
                                  const ts_band *band, ts_shadow_group *group, ts_shadow_tally *tally)
{
	if (group->n == 0u) return;
	for (i32 y = cover->touched.y0 + band->first; y <= cover->touched.y1; y += band->step) {
		for (i32 x = cover->touched.x0; x <= cover->touched.x1; x++) {
			if (!ts_k_is_point(&args->of.from, cover, point->piece, x, y)) continue;
			ts_k_flight_start(&args->of.from, point, x, y);
			for (u32 k = 0u; k < group->n; k++) ts_k_shadow_splat_into(args, &group->caster[k], point, tally);
		}
	}
	group->n = 0u;
}

/* scatter over pieces: their points are made for some views at a time and not stored; the first batch counts them */
TS_FN void ts_k_shadow_splat_pieces_item(const ts_shadow_splat_args *args, u64 i)
{
	/* Leave out a piece without points. */
	ts_band band = ts_k_band(i, args->of.others);
	u64 piece = band.item;
	TS_GLOBAL const ts_align *frame = &args->of.from.frames[piece];
	if (!(frame->s > 0.0f)) return;
	/* Set what the piece's points have in common. */
	TS_GLOBAL const u64 *words = args->of.bits + (u64)args->of.from.pieces[piece].triangle * args->of.n_words;
	ts_cover cover = ts_k_lattice_cover(frame, args->of.from.half_size);
	ts_flight point = ts_k_flight_of_piece(&args->of.from, piece);
	ts_shadow_tally tally = ts_k_shadow_none();
	ts_shadow_group group;
	group.n = 0u;
	/* Gather the views that may see the piece, and splat into each full group. */
	for (u32 v = args->of.first_view; v < args->of.first_view + args->of.n_views; v++) {
		if (!ts_k_offscreen_bit(words, v)) continue;
		group.caster[group.n] = ts_k_shadow_caster(&args->of, v, &point);
		if (!group.caster[group.n].misses) group.n++;
		if (group.n == TS_SHADOW_GROUP) ts_k_shadow_piece_into(args, &cover, &point, &band, &group, &tally);
	}
	/* Splat into the last group; count the points in the first batch of views alone. */
	ts_k_shadow_piece_into(args, &cover, &point, &band, &group, &tally);
	if (args->of.first_view == 0u) tally.of.points = ts_k_points_of(&args->of.from, &band);
	ts_k_shadow_count(args, &tally);
}

#endif
