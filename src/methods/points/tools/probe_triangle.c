/* Where a triangle or a point went, or which stage lost it. */
#include <inttypes.h>
#include <stdlib.h>
#include "kernels/raster/draw.h"
#include "kernels/raster/eye_sample.h"
#include "methods/points/tools/probe.h"
#include "methods/raster/raster.h"

enum { MOST_PIECES = 32, MOST_POINTS = 64 };

/* The triangle's remains after the stages of EPR. */
typedef struct {
	bool seen;
	const char *unseen;
	u64 n_pieces, n_kept, n_points, n_samples;
	ts_spread spread;
} fate;

static json_t *verdict(const char *stage, json_t *text) { return json_pack("{s:s,s:o}", "stage", stage, "why", text); }

static json_t *lost_at(const ts_probe *p, const fate *f)
{
	const char *splat = ts_pipeline_maker(p->trace->pipeline, TS_B_splat_depth_index)->stage;
	const char *tie = ts_pipeline_maker(p->trace->pipeline, TS_B_splat_tie)->stage;
	const ts_spread *s = &f->spread;
	const ts_rival *best = s->n_rivals > 0 ? &s->rival[0] : NULL;
	if (!f->seen) return verdict("visibility", json_sprintf("never visible: %s", f->unseen));
	if (f->n_pieces == 0) return verdict("split", json_string("no pieces: its density is 0"));
	if (f->n_kept == 0)
		return verdict("cull", json_sprintf("culled: none of %" PRIu64 " pieces was kept", f->n_pieces));
	if (f->n_points == 0)
		return verdict("points.count", json_string("no points: no sample touches it, or alpha cut all of them"));
	if (s->offered == 0) return verdict(splat, json_string("no texel touched: outside the faces, or behind near"));
	if (s->won == 0 && s->ties == s->lost && best != NULL) {
		return verdict(tie,
		               json_sprintf("all of %" PRIu64 " texels went to lower indices at the same distance, most to "
		                            "triangle %u",
		                            s->lost, (unsigned)best->triangle));
	}
	if (s->won == 0 && best != NULL) {
		return verdict(splat,
		               json_sprintf("hidden: nearer points hold all of %" PRIu64 " texels, most of triangle %u, %.9g "
		                            "nearer or more",
		                            s->lost, (unsigned)best->triangle, (double)best->least));
	}
	if (s->won == 0) return verdict(splat, json_string("the buffer holds none of its points, and nothing nearer"));
	if (f->n_samples == 0) {
		return verdict(
			"lookup",
			json_sprintf("face resolution: no sample of a reflective pixel fell into its %" PRIu64 " texels", s->won));
	}
	return NULL;
}

static void put_verdict(ts_probe *p, json_t *o, const fate *f)
{
	json_t *lost = lost_at(p, f);
	ts_probe_put(p, o, "lost_at", lost != NULL ? lost : json_string("no stage"));
	if (lost == NULL) {
		ts_probe_put(p, o, "shown", json_sprintf("%" PRIu64 " samples see it", f->n_samples));
	}
}

/* Draws the triangle alone into one view, and compares. */
static ts_status put_drawn(ts_probe *p, u32 triangle, const ts_camera_k *view, ts_buffer_id id, u64 first,
                           ts_spread *spread)
{
	ts_corners t = ts_k_corners(&p->scene, triangle);
	u64 n = (u64)view->width * (u64)view->height;
	if (ts_k_is_degenerate(t.n) || !ts_k_is_facing(&p->scene, triangle, &t, view->eye)) return TS_OK;
	if (ts_probe_textures(p, triangle) != TS_OK) return TS_ERROR;
	u64 *alone = ts_alloc((size_t)n, sizeof *alone, "a view");
	if (alone == NULL) return TS_ERROR;
	memset(alone, 0xff, (size_t)n * sizeof *alone);
	const ts_target target = ts_k_keys(alone);
	const ts_band all = ts_k_band(triangle, 0);
	ts_k_draw(&p->scene, view, &t, triangle, &all, &target);
	ts_status status = ts_probe_spread_add(p, spread, alone, n, id, first, triangle, NULL, 0, NULL);
	free(alone);
	return status;
}

static ts_status put_eye(ts_probe *p, u32 triangle, json_t *o)
{
	ts_spread spread = {.n_rivals = 0};
	json_t *eye = json_object();
	ts_camera_k view = ts_k_view(&p->view);
	ts_corners t = ts_k_corners(&p->scene, triangle);
	bool whole = ts_probe_has(p, TS_B_eye_depth_triangle) && !p->trace->item[TS_B_eye_depth_triangle].cropped;
	u32 samples = whole ? ts_eye_samples(&p->trace->params) : 0;
	ts_status status = TS_OK;
	for (u32 k = 0; k < samples && status == TS_OK; k++) {
		ts_camera_k of_sample = ts_k_eye_view(&p->view, samples, k);
		u64 first = (u64)k * p->view.width * p->view.height;
		status = put_drawn(p, triangle, &of_sample, TS_B_eye_depth_triangle, first, &spread);
	}
	bool facing = ts_k_is_facing(&p->scene, triangle, &t, view.eye);
	ts_probe_put(p, eye, "facing", json_boolean(facing));
	if (whole) ts_probe_put_spread(p, eye, &spread);
	ts_probe_put(p, o, "eye", eye);
	ts_probe_spread_free(&spread);
	return status;
}

static ts_status put_pieces(ts_probe *p, json_t *o, u64 first, fate *f)
{
	json_t *list = json_array();
	ts_status status = TS_OK;
	for (u64 i = 0; i < f->n_pieces && status == TS_OK; i++) {
		json_t *piece = json_object();
		bool kept = false;
		status = ts_probe_piece(p, first + i, piece, &kept);
		f->n_kept += kept;
		if (i < MOST_PIECES) {
			ts_probe_append(p, list, piece);
		} else {
			json_decref(piece);
		}
	}
	ts_probe_put(p, o, "pieces", ts_probe_int(f->n_pieces));
	ts_probe_put(p, o, "pieces_kept", ts_probe_int(f->n_kept));
	if (f->n_pieces > MOST_PIECES) ts_probe_put(p, o, "pieces_listed", ts_probe_int(MOST_PIECES));
	ts_probe_put(p, o, "each_piece", list);
	return status;
}

static void put_each_point(ts_probe *p, json_t *o, const ts_probe_set *set)
{
	json_t *list = json_array();
	for (size_t i = 0; i < set->n && i < MOST_POINTS && set->won != NULL; i++) {
		ts_probe_append(p, list,
		                json_pack("{s:I,s:I,s:I}", "point", (json_int_t)set->index[i], "offered",
		                          (json_int_t)set->offered[i], "won", (json_int_t)set->won[i]));
	}
	if (set->n > MOST_POINTS) ts_probe_put(p, o, "points_listed", ts_probe_int(MOST_POINTS));
	ts_probe_put(p, o, "each_point", list);
}

/* The points, and their fates; only `only` unless that is TS_NONE. */
static ts_status put_points(ts_probe *p, json_t *o, u64 first, u64 n, u32 only, fate *f)
{
	ts_probe_set set;
	json_t *faces = json_array(), *went = json_object();
	ts_status status = ts_probe_set_make(p, &set, first, n, only);
	if (status == TS_OK) status = ts_probe_set_splat(p, &set, &f->spread, faces);
	f->n_points = set.n;
	u64 winners = 0;
	for (size_t i = 0; i < set.n && set.won != NULL; i++) winners += set.won[i] > 0;
	ts_probe_put(p, went, "points", ts_probe_int(set.n));
	ts_probe_put(p, went, "points_that_won_texels", ts_probe_int(winners));
	ts_probe_put_spread(p, went, &f->spread);
	ts_probe_put(p, went, "lost_to_its_own_triangle", ts_probe_int(f->spread.lost_to_own));
	if (status == TS_OK) status = ts_probe_put_lookups(p, went, &set, &f->n_samples);
	ts_probe_put(p, went, "faces", faces);
	put_each_point(p, went, &set);
	ts_probe_put(p, o, "cubes", went);
	ts_probe_set_free(&set);
	return status;
}

static ts_status visibility_and_density(ts_probe *p, u32 triangle, json_t *o, fate *f)
{
	json_t *visibility = json_object(), *density = json_object();
	u64 *bits = ts_alloc_zero(ts_probe_n_words(p) + (size_t)1, sizeof *bits, "visibility.bits");
	ts_status status =
		bits != NULL ? ts_probe_visibility(p, triangle, bits, visibility, &f->seen, &f->unseen) : TS_ERROR;
	if (status == TS_OK) status = ts_probe_density(p, triangle, bits, density);
	ts_probe_put(p, o, "visibility", visibility);
	ts_probe_put(p, o, "density", density);
	free(bits);
	return status;
}

static ts_status describe_epr(ts_probe *p, u32 triangle, json_t *o)
{
	fate f = {.n_pieces = 0};
	u32 offset[2];
	ts_status status = visibility_and_density(p, triangle, o, &f);
	if (status == TS_OK) status = ts_probe_fetch(p, TS_B_split_offset, triangle, 2, offset);
	if (status == TS_OK && (offset[1] < offset[0] || offset[1] > ts_probe_n(p, TS_B_split_piece))) {
		status = ts_fail("%s: elements %u and %u are %u and %u; there are %" PRIu64 " pieces",
		                 p->trace->item[TS_B_split_offset].path, (unsigned)triangle, (unsigned)triangle + 1,
		                 (unsigned)offset[0], (unsigned)offset[1], ts_probe_n(p, TS_B_split_piece));
	}
	if (status != TS_OK) return status;
	f.n_pieces = offset[1] - offset[0];
	status = put_pieces(p, o, offset[0], &f);
	if (status == TS_OK) status = put_points(p, o, offset[0], f.n_pieces, TS_NONE, &f);
	put_verdict(p, o, &f);
	ts_probe_spread_free(&f.spread);
	return status;
}

static ts_status describe_mvr(ts_probe *p, u32 triangle, json_t *o)
{
	ts_spread spread = {.n_rivals = 0};
	json_t *cubes = json_object(), *lost = NULL;
	ts_status status = TS_OK;
	u32 own = ts_k_reflector_of(&p->scene, triangle);
	for (u32 i = 0; i < ts_probe_n_cubes(p) * 6 && status == TS_OK; i++) {
		const ts_face *cube = &ts_probe_cubes(p)[i / 6];
		ts_camera_k view = ts_k_cube_view(cube, i % 6);
		u64 first = cube->offset + (u64)(i % 6) * cube->n * cube->n;
		if (i / 6 == own || cube->n == 0) continue;
		status = put_drawn(p, triangle, &view, TS_B_cube_face_depth_triangle, first, &spread);
	}
	ts_probe_put_spread(p, cubes, &spread);
	ts_probe_put(p, o, "cubes", cubes);
	if (spread.offered == 0)
		lost = verdict("cube_face", json_string("it covers no texel: no face sees it, or it is too small"));
	if (spread.offered > 0 && spread.won == 0 && spread.n_rivals > 0) {
		lost = verdict("cube_face",
		               json_sprintf("hidden: most texels went to triangle %u", (unsigned)spread.rival[0].triangle));
	}
	ts_probe_put(p, o, "lost_at", lost != NULL ? lost : json_string("no stage"));
	ts_probe_spread_free(&spread);
	return status;
}

static ts_status require_epr(const ts_probe *p)
{
	static const ts_buffer_id needed[] = {TS_B_visibility_bits,     TS_B_split_triangle_density, TS_B_split_offset,
	                                      TS_B_split_piece,         TS_B_split_density,          TS_B_cull_keep,
	                                      TS_B_align_frame,         TS_B_points_record,          TS_B_splat_depth_index,
	                                      TS_B_mirror_pixel_record, TS_B_lookup_point,           TS_N_BUFFERS};
	return ts_probe_require(p, needed);
}

static ts_status require_mvr(const ts_probe *p)
{
	static const ts_buffer_id needed[] = {TS_B_cube_face_depth_triangle, TS_N_BUFFERS};
	return ts_probe_require(p, needed);
}

static void put_corners(ts_probe *p, json_t *o, u32 triangle)
{
	ts_corners t = ts_k_corners(&p->scene, triangle);
	json_t *corners = json_array();
	ts_probe_append(p, corners, ts_probe_v3(t.a));
	ts_probe_append(p, corners, ts_probe_v3(t.b));
	ts_probe_append(p, corners, ts_probe_v3(t.c));
	ts_probe_put_triangle(p, o, triangle);
	ts_probe_put_method(p, o);
	ts_probe_put(p, o, "corners", corners);
	ts_probe_put(p, o, "degenerate", json_boolean(ts_k_is_degenerate(t.n)));
}

/* The common beginning of both methods' answers. */
static ts_status put_triangle(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	if (q->index >= p->scene.n_triangles) {
		return ts_fail("%s: no triangle %" PRIu64 "; there are %u, from 0", p->trace->dir, q->index,
		               (unsigned)p->scene.n_triangles);
	}
	put_corners(p, o, (u32)q->index);
	return put_eye(p, (u32)q->index, o);
}

ts_status ts_probe_epr_triangle(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	if (ts_probe_read_cubes(p) != TS_OK || require_epr(p) != TS_OK || put_triangle(p, q, o) != TS_OK) return TS_ERROR;
	return describe_epr(p, (u32)q->index, o);
}

ts_status ts_probe_mvr_triangle(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	if (ts_probe_read_cubes(p) != TS_OK || require_mvr(p) != TS_OK || put_triangle(p, q, o) != TS_OK) return TS_ERROR;
	return describe_mvr(p, (u32)q->index, o);
}

static ts_status put_key(ts_probe *p, u32 point, json_t *o)
{
	u64 key;
	if (!ts_probe_has(p, TS_B_points_key)) return TS_OK;
	if (ts_probe_fetch(p, TS_B_points_key, point, 1, &key) != TS_OK) return TS_ERROR;
	ts_probe_put(p, o, "key", ts_probe_key(key));
	return TS_OK;
}

static ts_status describe_point(ts_probe *p, u32 point, const ts_point *record, const ts_piece *piece, json_t *o)
{
	fate f = {.seen = true, .n_pieces = 1, .n_kept = 1};
	ts_probe_put(p, o, "point", ts_probe_int(point));
	if (put_key(p, point, o) != TS_OK) return TS_ERROR;
	json_t *made = json_object();
	bool kept;
	ts_probe_put(p, o, "centre", ts_probe_v3_bits(ts_load3(record->centre)));
	ts_probe_put(p, o, "splat_length", ts_probe_bits(record->length));
	ts_probe_put(p, o, "tiny", json_boolean((record->flags & 1) != 0));
	put_corners(p, o, piece->triangle);
	ts_status status = ts_probe_piece(p, record->piece, made, &kept);
	ts_probe_put(p, o, "piece", made);
	if (status == TS_OK) status = put_points(p, o, record->piece, 1, point, &f);
	json_t *lost =
		f.spread.won == 0 && f.spread.lost > 0 && f.spread.lost_to_own == f.spread.lost
			? verdict("splat", json_string("face resolution: nearer points of its own triangle hold all its texels"))
			: NULL;
	if (lost != NULL) {
		ts_probe_put(p, o, "lost_at", lost);
	} else {
		put_verdict(p, o, &f);
	}
	ts_probe_spread_free(&f.spread);
	return status;
}

static ts_status find_key(ts_probe *p, const i64 key[3], u64 *point)
{
	static const ts_buffer_id needed[] = {TS_B_points_key, TS_N_BUFFERS};
	u64 held;
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	for (*point = 0; *point < ts_probe_n(p, TS_B_points_key); ++*point) {
		if (ts_probe_fetch(p, TS_B_points_key, *point, 1, &held) != TS_OK) return TS_ERROR;
		i64 x = (i64)(held & 0xffff) - 32768, y = (i64)(held >> 16 & 0xffff) - 32768;
		if ((i64)(held >> 32) == key[0] && x == key[1] && y == key[2]) return TS_OK;
	}
	return ts_fail("%s: no point of key %" PRId64 ",%" PRId64 ",%" PRId64, p->trace->item[TS_B_points_key].path, key[0],
	               key[1], key[2]);
}

ts_status ts_probe_epr_point(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	ts_point record;
	ts_piece piece;
	u64 point = q->index;
	if (ts_probe_read_cubes(p) != TS_OK) return TS_ERROR;
	if (q->key != NULL && find_key(p, q->key, &point) != TS_OK) return TS_ERROR;
	if (require_epr(p) != TS_OK) return TS_ERROR;
	if (point >= ts_probe_n(p, TS_B_points_record) || point >= TS_NONE) {
		return ts_fail("%s: no point %" PRIu64 "; there are %" PRIu64 ", from 0", p->trace->dir, point,
		               ts_probe_n(p, TS_B_points_record));
	}
	if (ts_probe_fetch_point(p, point, &record, &piece) != TS_OK) return TS_ERROR;
	return describe_point(p, (u32)point, &record, &piece, o);
}
