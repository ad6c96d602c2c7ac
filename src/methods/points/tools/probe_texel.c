/* A texel of a face of a cube. */
#include <inttypes.h>
#include <stdlib.h>
#include "kernels/points/forward.h"
#include "kernels/points/splat.h"
#include "kernels/raster/illuminate.h"
#include "methods/points/points.h"
#include "methods/points/tools/probe.h"
#include "trace/where.h"

typedef struct {
	u32 reflector, face, x, y;
	ts_camera_k view;
	u64 inside, texel; /* in the face; in the buffer */
	bool coloured;     /* keys have colours of points, not their indices */
} place;

/* A piece, and whether it can reach the face. */
typedef struct {
	u64 index;
	ts_piece piece;
	ts_align frame;
	ts_cover cover;
	bool reaches;
} state;

static ts_status enter_piece(ts_probe *p, const place *at, u32 index, state *s)
{
	u32 bit = 6 * at->reflector + at->face;
	u64 word, words = ts_probe_n_words(p);
	s->index = index;
	s->reaches = false;
	if (ts_probe_fetch(p, TS_B_split_piece, index, 1, &s->piece) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_visibility_bits, s->piece.triangle * words + bit / 64, 1, &word) != TS_OK)
		return TS_ERROR;
	if ((word >> (bit % 64) & 1) == 0) return TS_OK;
	s->cover = ts_k_splat_triangle(&at->view, &s->piece);
	s->reaches = s->cover.n != 0;
	return s->reaches ? ts_probe_fetch(p, TS_B_align_frame, index, 1, &s->frame) : TS_OK;
}

/* The kernel splats the point alone, and its offer is the result in the texel. */
static ts_status offer_point(ts_probe *p, const place *at, const state *s, const ts_point *record, u32 index,
                             u64 *texels, ts_offers *offers)
{
	u32 word = index;
	ts_point point = *record;
	f32 inset = ts_splat_inset(&p->trace->params);
	ts_square square = ts_k_square(&s->piece, &s->frame, ts_load3(point.centre), point.length);
	ts_box box = ts_k_splat_box(&at->view, &square, inset);
	i32 x = (i32)at->x, y = (i32)at->y;
	if (x < box.x0 || x > box.x1 || y < box.y0 || y > box.y1) return TS_OK;
	point.piece = 0;
	ts_splat_args args = {.from = {.pieces = &s->piece, .frames = &s->frame, .points = &point},
	                      .texels = texels,
	                      .clip = TS_PARAM(&p->trace->params, splat_clip),
	                      .inset = inset,
	                      .plane_depth = TS_PARAM(&p->trace->params, splat_plane_depth)};
	texels[at->inside] = TS_EMPTY;
	ts_flight flight = ts_k_flight_record(&args.from, 0);
	ts_k_splat(&args, &at->view, &s->cover, &flight, 0, 0);
	u64 key = texels[at->inside];
	if (key == TS_EMPTY) return TS_OK;
	if (at->coloured && ts_probe_fetch(p, TS_B_forward_colour, index, 1, &word) != TS_OK) return TS_ERROR;
	key = (key & ~(u64)0xffffffffu) | word;
	return ts_probe_offers_add(offers, (ts_offer){.key = key, .triangle = s->piece.triangle});
}

/* Finds all points, in any order. */
static ts_status find_points(ts_probe *p, const place *at, u64 *texels, ts_offers *offers)
{
	state s = {.index = UINT64_MAX};
	ts_status status = TS_OK;
	for (u64 i = 0; i < ts_probe_n(p, TS_B_points_record) && status == TS_OK; i++) {
		ts_point point;
		status = ts_probe_fetch(p, TS_B_points_record, i, 1, &point);
		if (status == TS_OK && point.piece != s.index) status = enter_piece(p, at, point.piece, &s);
		if (status == TS_OK && s.reaches) status = offer_point(p, at, &s, &point, (u32)i, texels, offers);
	}
	return status;
}

static ts_status put_point(ts_probe *p, json_t *o, u32 point)
{
	u64 key;
	ts_point record;
	ts_piece piece;
	if (ts_probe_fetch_point(p, point, &record, &piece) != TS_OK) return TS_ERROR;
	ts_probe_put(p, o, "point", ts_probe_int(point));
	if (ts_probe_has(p, TS_B_points_key)) {
		if (ts_probe_fetch(p, TS_B_points_key, point, 1, &key) != TS_OK) return TS_ERROR;
		ts_probe_put(p, o, "key", ts_probe_key(key));
	}
	ts_probe_put(p, o, "splat_length", ts_probe_real(record.length));
	return TS_OK;
}

static ts_status put_colour(ts_probe *p, json_t *o, u32 colour)
{
	ts_probe_put(p, o, "colour", json_sprintf("%08x", (unsigned)colour));
	ts_probe_put(p, o, "radiance", ts_probe_v3_bits(ts_k_shared_radiance(colour)));
	return TS_OK;
}

static ts_status put_competition(ts_probe *p, const place *at, json_t *o, ts_buffer_id id, ts_probe_put_index *put)
{
	const ts_buffer_id needed[] = {
		id, TS_B_points_record, TS_B_split_piece, TS_B_align_frame, TS_B_visibility_bits, TS_N_BUFFERS};
	u64 held, n = (u64)at->view.width * (u64)at->view.width;
	ts_offers offers = {.offer = NULL};
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, id, at->texel, 1, &held) != TS_OK) return TS_ERROR;
	u64 *texels = ts_alloc((size_t)n, sizeof *texels, "a face");
	if (texels == NULL) return TS_ERROR;
	memset(texels, 0xff, (size_t)n * sizeof *texels);
	ts_status status = find_points(p, at, texels, &offers);
	ts_probe_offers_sort(&offers);
	if (status == TS_OK) status = ts_probe_put_offers(p, o, &offers, id, held, put);
	free(offers.offer);
	free(texels);
	return status;
}

static ts_status put_points(ts_probe *p, const place *at, json_t *o)
{
	u8 tied;
	if (put_competition(p, at, o, TS_B_splat_depth_index, put_point) != TS_OK) return TS_ERROR;
	if (!ts_probe_has(p, TS_B_splat_tie)) return TS_OK;
	if (ts_probe_fetch(p, TS_B_splat_tie, at->texel, 1, &tied) != TS_OK) return TS_ERROR;
	ts_probe_put(p, o, "tied", json_boolean(tied != 0));
	return TS_OK;
}

static ts_status put_colours(ts_probe *p, const place *at, json_t *o)
{
	static const ts_buffer_id needed[] = {TS_B_forward_colour, TS_N_BUFFERS};
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	place of = *at;
	of.coloured = true;
	return put_competition(p, &of, o, TS_B_splat_depth_colour, put_colour);
}

static ts_status put_radiance(ts_probe *p, const place *at, json_t *o, u64 held)
{
	ts_texel_place where = {.cube = 0, .face = at->face, .x = at->x, .y = at->y, .inside = 0};
	const ts_face *cubes = ts_probe_cubes(p);
	ts_illuminate_args args = {.scene = p->scene, .cubes = &cubes[at->reflector]};
	ts_v3 radiance = ts_k_background(), total;
	f32 computed[3], mip[3];
	if (held != TS_EMPTY) {
		if (ts_probe_textures(p, (u32)held) != TS_OK) return TS_ERROR;
		ts_surface s = ts_k_surface_seen(&p->scene, &at->view, (u32)held, (i32)at->x, (i32)at->y);
		radiance = ts_k_texel_radiance(&args, &where, (u32)held);
		ts_v3 v = ts_normalize(ts_sub(at->view.eye, s.p));
		ts_probe_put(p, o, "shading", ts_probe_shading(p, &s, v, NULL, NULL, &total));
	}
	json_t *result = json_object();
	ts_store3(computed, radiance);
	ts_probe_put(p, result, "radiance", ts_probe_v3_bits(ts_load3(computed)));
	u64 first = ts_k_mip_first(cubes, 0, at->reflector) + at->texel - cubes[at->reflector].offset;
	ts_status status =
		ts_probe_has(p, TS_B_cube_face_mip) ? ts_probe_fetch(p, TS_B_cube_face_mip, first * 4, 3, mip) : TS_OK;
	if (status == TS_OK && ts_probe_has(p, TS_B_cube_face_mip))
		ts_probe_put_check(p, result, TS_B_cube_face_mip, computed, mip, 3);
	ts_probe_put(p, o, "face_mip", result);
	return status;
}

static ts_status put_triangles(ts_probe *p, const place *at, json_t *o)
{
	static const ts_buffer_id needed[] = {TS_B_cube_face_depth_triangle, TS_N_BUFFERS};
	u64 held;
	ts_offers offers = {.offer = NULL};
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_cube_face_depth_triangle, at->texel, 1, &held) != TS_OK) return TS_ERROR;
	ts_status status = ts_probe_contest(p, &at->view, at->reflector, at->x, at->y, &offers);
	if (status == TS_OK) status = ts_probe_put_offers(p, o, &offers, TS_B_cube_face_depth_triangle, held, NULL);
	free(offers.offer);
	return status == TS_OK ? put_radiance(p, at, o, held) : status;
}

typedef ts_status put_texel(ts_probe *p, const place *at, json_t *o);

static ts_status answer(ts_probe *p, const ts_probe_question *q, put_texel *put, json_t *o)
{
	if (ts_probe_read_cubes(p) != TS_OK) return TS_ERROR;
	if (q->index >= ts_probe_n_cubes(p)) {
		return ts_fail("%s: no face %" PRIu64 ".%u; there are %u reflectors, from 0, of faces 0 to 5", p->trace->dir,
		               q->index, (unsigned)q->side, (unsigned)ts_probe_n_cubes(p));
	}
	u32 reflector = (u32)q->index;
	const ts_face *cube = &ts_probe_cubes(p)[reflector];
	if (q->x >= cube->n || q->y >= cube->n) {
		return ts_fail("%s: no texel (%u, %u); the faces of reflector %u have %u x %u%s", p->trace->dir, (unsigned)q->x,
		               (unsigned)q->y, (unsigned)reflector, (unsigned)cube->n, (unsigned)cube->n,
		               cube->n == 0 ? ": the eye does not see it" : "");
	}
	place at = {.reflector = reflector, .face = q->side, .x = q->x, .y = q->y, .view = ts_k_cube_view(cube, q->side)};
	at.inside = (u64)q->y * cube->n + q->x;
	at.texel = cube->offset + (u64)q->side * cube->n * cube->n + at.inside;
	ts_probe_put(p, o, "face", ts_probe_face_name(reflector, q->side));
	ts_probe_put(p, o, "texel", ts_probe_pair(q->x, q->y));
	ts_probe_put(p, o, "element", ts_probe_int(at.texel));
	ts_probe_put_method(p, o);
	return put(p, &at, o);
}

const ts_probe_view ts_probe_face = {
	.form = "REFLECTOR.FACE, for instance 3.+X or 3.0",
	.prefix = "",
	.side = ts_where_face,
	.n_sides = 6,
};

ts_status ts_probe_epr_texel(ts_probe *p, const ts_probe_question *q, json_t *o) { return answer(p, q, put_points, o); }
ts_status ts_probe_forward_texel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	return answer(p, q, put_colours, o);
}
ts_status ts_probe_mvr_texel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	return answer(p, q, put_triangles, o);
}
