/* A texel of a face of a cube. */
#include <stdlib.h>
#include "../../../kernels/points/illuminate.h"
#include "../../../kernels/points/splat.h"
#include "../../../probe/parts.h"
#include "../../../trace/where.h"

typedef struct {
	u32 reflector, face, x, y;
	ts_camera_k view;
	u64 inside, texel; /* in the face; in the buffer */
} place;

/* A piece, and whether it can reach the face. */
typedef struct { u64 index; ts_piece piece; ts_align frame; ts_cover cover; bool reaches; } state;

static ts_status enter_piece(ts_probe *p, const place *at, u32 index, state *s)
{
	u32 bit = 6 * at->reflector + at->face;
	u64 word;
	s->index = index;
	s->reaches = false;
	if (ts_probe_fetch(p, TS_B_split_triangle, index, 1, &s->piece) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_visibility_bits, (u64)s->piece.triangle * p->n_words + bit / 64, 1, &word) != TS_OK)
		return TS_ERROR;
	if ((word >> (bit % 64) & 1) == 0) return TS_OK;
	s->cover = ts_k_splat_triangle(&at->view, &s->piece);
	s->reaches = s->cover.n != 0;
	return s->reaches ? ts_probe_fetch(p, TS_B_align_frame, index, 1, &s->frame) : TS_OK;
}

/* The kernel splats the point alone; what it leaves in the texel is its offer. */
static ts_status offer_point(const ts_probe *p, const place *at, const state *s, const ts_point *record, u32 index,
                             u64 *texels, ts_offers *offers)
{
	ts_point point = *record;
	ts_box box =
		ts_k_splat_box(&at->view, ts_load3(point.centre), ts_load3(s->frame.u), ts_load3(s->frame.v), point.length);
	i32 x = (i32)at->x, y = (i32)at->y;
	if (x < box.x0 || x > box.x1 || y < box.y0 || y > box.y1) return TS_OK;
	point.piece = 0;
	ts_splat_args args = {.pieces = &s->piece,
	                      .frames = &s->frame,
	                      .points = &point,
	                      .texels = texels,
	                      .clip = TS_PARAM(&p->trace->params, clip),
	                      .plane_depth = TS_PARAM(&p->trace->params, planedepth)};
	texels[at->inside] = TS_EMPTY;
	ts_k_splat(&args, &at->view, &s->cover, 0, 0);
	u64 key = texels[at->inside];
	if (key == TS_EMPTY) return TS_OK;
	void *array = offers->offer;
	if (ts_grow(&array, &offers->capacity, offers->n + 1, sizeof *offers->offer, "who competed") != TS_OK)
		return TS_ERROR;
	offers->offer = array;
	offers->offer[offers->n++] = (ts_offer){.key = (key & ~(u64)0xffffffffu) | index, .triangle = s->piece.triangle};
	return TS_OK;
}

/* All points, in whatever order they stand. */
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

static ts_status put_points(ts_probe *p, const place *at, json_t *o)
{
	static const ts_buffer_id needed[] = {TS_B_splat_depth_index, TS_B_points_record, TS_B_split_triangle,
		TS_B_align_frame, TS_B_visibility_bits, TS_N_BUFFERS};
	u64 held, n = (u64)at->view.width * (u64)at->view.width;
	u8 tied;
	ts_offers offers = {.offer = NULL};
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_splat_depth_index, at->texel, 1, &held) != TS_OK) return TS_ERROR;
	u64 *texels = ts_alloc((size_t)n, sizeof *texels, "a face");
	if (texels == NULL) return TS_ERROR;
	memset(texels, 0xff, (size_t)n * sizeof *texels);
	ts_status status = find_points(p, at, texels, &offers);
	ts_probe_offers_sort(&offers);
	if (status == TS_OK) status = ts_probe_put_offers(p, o, &offers, TS_B_splat_depth_index, held, true);
	if (status == TS_OK && ts_probe_has(p, TS_B_splat_tie)) {
		status = ts_probe_fetch(p, TS_B_splat_tie, at->texel, 1, &tied);
		if (status == TS_OK) ts_probe_put(p, o, "tied", json_boolean(tied != 0));
	}
	free(offers.offer);
	free(texels);
	return status;
}

static ts_status put_radiance(ts_probe *p, const place *at, json_t *o, u64 held)
{
	ts_texel_place where = {.cube = 0, .face = at->face, .x = at->x, .y = at->y, .inside = 0};
	ts_illuminate_args args = {.scene = p->scene, .cubes = &p->cubes[at->reflector]};
	ts_v3 radiance = ts_k_background(), total;
	f32 computed[3], mip[3];
	if (held != TS_EMPTY) {
		if (ts_probe_textures(p, (u32)held) != TS_OK) return TS_ERROR;
		ts_surface s = ts_k_surface_seen(&p->scene, &at->view, (u32)held, (i32)at->x, (i32)at->y);
		radiance = ts_k_texel_radiance(&args, &where, (u32)held);
		ts_probe_put(p, o, "shading", ts_probe_shading(p, &s, ts_normalize(ts_sub(at->view.eye, s.p)), &total));
	}
	json_t *result = json_object();
	ts_store3(computed, radiance);
	ts_probe_put(p, result, "radiance", ts_probe_v3_bits(ts_load3(computed)));
	u64 first = ts_k_mip_first(p->cubes, 0, at->reflector) + at->texel - p->cubes[at->reflector].offset;
	ts_status status = ts_probe_has(p, TS_B_face_mip) ? ts_probe_fetch(p, TS_B_face_mip, first * 4, 3, mip) : TS_OK;
	if (status == TS_OK && ts_probe_has(p, TS_B_face_mip))
		ts_probe_put_check(p, result, TS_B_face_mip, computed, mip, 3);
	ts_probe_put(p, o, "face_mip", result);
	return status;
}

static ts_status put_triangles(ts_probe *p, const place *at, json_t *o)
{
	static const ts_buffer_id needed[] = {TS_B_face_depth_triangle, TS_N_BUFFERS};
	u64 held;
	ts_offers offers = {.offer = NULL};
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_face_depth_triangle, at->texel, 1, &held) != TS_OK) return TS_ERROR;
	ts_status status = ts_probe_contest(p, &at->view, at->reflector, at->x, at->y, &offers);
	if (status == TS_OK) status = ts_probe_put_offers(p, o, &offers, TS_B_face_depth_triangle, held, false);
	free(offers.offer);
	return status == TS_OK ? put_radiance(p, at, o, held) : status;
}

ts_status ts_probe_texel(ts_probe *p, u32 reflector, u32 face, u32 x, u32 y, json_t **answer)
{
	*answer = NULL;
	if (ts_probe_of_reflections(p) != TS_OK || ts_probe_scene(p) != TS_OK) return TS_ERROR;
	if (reflector >= p->n_cubes || face >= 6) {
		return ts_fail("%s: no face %u.%u; there are %u reflectors, from 0, of faces 0 to 5", p->trace->dir,
		               (unsigned)reflector, (unsigned)face, (unsigned)p->n_cubes);
	}
	const ts_face *cube = &p->cubes[reflector];
	if (x >= cube->n || y >= cube->n) {
		return ts_fail("%s: no texel (%u, %u); the faces of reflector %u have %u x %u%s", p->trace->dir, (unsigned)x,
		               (unsigned)y, (unsigned)reflector, (unsigned)cube->n, (unsigned)cube->n,
		               cube->n == 0 ? ": the eye does not see it" : "");
	}
	place at = {.reflector = reflector, .face = face, .x = x, .y = y, .view = ts_k_cube_view(cube, face)};
	at.inside = (u64)y * cube->n + x;
	at.texel = cube->offset + (u64)face * cube->n * cube->n + at.inside;
	json_t *o = json_object();
	ts_probe_put(p, o, "face", ts_probe_face_name(reflector, face));
	ts_probe_put(p, o, "texel", ts_probe_pair(x, y));
	ts_probe_put(p, o, "element", ts_probe_int(at.texel));
	ts_probe_put(p, o, "method", json_string(p->trace->pipeline->name));
	return ts_probe_answer(p, o, p->faces ? put_triangles(p, &at, o) : put_points(p, &at, o), answer);
}
