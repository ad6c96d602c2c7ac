/* Points that the method does not store, which stage `points` makes from the trace as if they were stored; and points
 * of one triangle, splatted again by themselves. */
#include <stdlib.h>
#include "kernels/points/splat.h"
#include "methods/points/points.h"
#include "methods/points/tools/probe.h"
#include "replay/replay.h"

/* A copy of the stage's buffer, instead of a file. */
static ts_status hold(ts_probe *p, ts_buffer_id id)
{
	const ts_buffer *made = &p->load->run.frame.buffer[id];
	ts_trace_item *item = &p->trace->item[id];
	size_t bytes = (size_t)made->n * ts_buffer_table[id].element_bytes;
	p->whole[id] = ts_alloc((size_t)made->n, ts_buffer_table[id].element_bytes, ts_buffer_table[id].name);
	if (p->whole[id] == NULL) return TS_ERROR;
	item->path = (char *)(uintptr_t)ts_buffer_table[id].name;
	memcpy(p->whole[id], made->data, bytes);
	item->memory = p->whole[id];
	item->npy = (ts_npy){.n = made->n, .n_dims = made->n_dims};
	memcpy(item->npy.shape, made->shape, sizeof made->shape);
	return TS_OK;
}

ts_status ts_probe_points_again(ts_probe *p)
{
	const ts_stage *points = ts_stage_find("points");
	bool counted = ts_probe_makes(p, TS_B_points_offset), stored = ts_probe_makes(p, TS_B_points_record);
	if (!counted || stored || ts_probe_has(p, TS_B_points_record)) return TS_OK;
	static const ts_buffer_id needed[] = {TS_B_points_offset, TS_B_align_frame, TS_B_split_piece, TS_N_BUFFERS};
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	if (ts_probe_load_for(p, (const char *const[]){points->name, NULL}) != TS_OK) return TS_ERROR;
	if (ts_replay_stage(&p->load->run, points) != TS_OK) return TS_ERROR;
	p->sizes.n[TS_DIM_points] = ts_frame_n(&p->load->run.frame, TS_B_points_record);
	return hold(p, TS_B_points_record) == TS_OK ? hold(p, TS_B_points_key) : TS_ERROR;
}

json_t *ts_probe_key(u64 key)
{
	return json_sprintf("%u,%d,%d", (unsigned)(key >> 32), (int)(key & 0xffff) - 32768,
	                    (int)(key >> 16 & 0xffff) - 32768);
}

ts_status ts_probe_fetch_point(ts_probe *p, u64 point, ts_point *record, ts_piece *piece)
{
	if (ts_probe_fetch(p, TS_B_points_record, point, 1, record) != TS_OK) return TS_ERROR;
	return ts_probe_fetch(p, TS_B_split_piece, record->piece, 1, piece);
}

static ts_status add_point(ts_probe_set *s, u32 index)
{
	void *array = s->index;
	if (ts_grow(&array, &s->capacity, s->n + 1, sizeof *s->index, "points") != TS_OK) return TS_ERROR;
	s->index = array;
	s->index[s->n++] = index;
	return TS_OK;
}

/* Points may stand in any order, so this searches all. */
static ts_status find_points(ts_probe *p, ts_probe_set *s, u32 only)
{
	u64 first = only != TS_NONE ? only : 0, end = only != TS_NONE ? (u64)only + 1 : ts_probe_n(p, TS_B_points_record);
	for (u64 i = first; i < end; i++) {
		ts_point record;
		if (ts_probe_fetch(p, TS_B_points_record, i, 1, &record) != TS_OK) return TS_ERROR;
		if (record.piece < s->first_piece || record.piece - s->first_piece >= s->n_pieces) continue;
		if (add_point(s, (u32)i) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static ts_status load_points(ts_probe *p, ts_probe_set *s)
{
	s->point = ts_alloc(s->n, sizeof *s->point, "points");
	s->offered = s->point != NULL ? ts_alloc_zero(s->n, sizeof *s->offered, "points") : NULL;
	s->won = s->offered != NULL ? ts_alloc_zero(s->n, sizeof *s->won, "points") : NULL;
	if (s->won == NULL) return TS_ERROR;
	for (size_t i = 0; i < s->n; i++) {
		if (ts_probe_fetch(p, TS_B_points_record, s->index[i], 1, &s->point[i]) != TS_OK) return TS_ERROR;
		s->point[i].piece -= (u32)s->first_piece;
	}
	return TS_OK;
}

ts_status ts_probe_set_make(ts_probe *p, ts_probe_set *s, u64 first_piece, u64 n_pieces, u32 only)
{
	*s = (ts_probe_set){.first_piece = first_piece, .n_pieces = n_pieces};
	s->piece = ts_alloc((size_t)n_pieces, sizeof *s->piece, "pieces");
	s->frame = s->piece != NULL ? ts_alloc((size_t)n_pieces, sizeof *s->frame, "pieces") : NULL;
	if (s->frame == NULL) return TS_ERROR;
	if (n_pieces == 0) return TS_OK;
	if (ts_probe_fetch(p, TS_B_split_piece, first_piece, n_pieces, s->piece) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_align_frame, first_piece, n_pieces, s->frame) != TS_OK) return TS_ERROR;
	s->triangle = s->piece[0].triangle;
	ts_status status = find_points(p, s, only);
	return status == TS_OK ? load_points(p, s) : status;
}

void ts_probe_set_free(ts_probe_set *s)
{
	free(s->index);
	free(s->point);
	free(s->offered);
	free(s->won);
	free(s->piece);
	free(s->frame);
	*s = (ts_probe_set){.index = NULL};
}

/* Splats all points into one empty face. */
static u64 splat_face(const ts_probe *p, ts_probe_set *s, const ts_camera_k *view, u64 *texels)
{
	u64 sum = 0;
	ts_splat_args args = {.from = {.pieces = s->piece, .frames = s->frame, .points = s->point},
	                      .texels = texels,
	                      .clip = TS_PARAM(&p->trace->params, splat_clip),
	                      .inset = ts_splat_inset(&p->trace->params),
	                      .plane_depth = TS_PARAM(&p->trace->params, splat_plane_depth)};
	for (size_t i = 0; i < s->n; i++) {
		ts_cover cover = ts_k_splat_triangle(view, &s->piece[s->point[i].piece]);
		ts_flight point = ts_k_flight_record(&args.from, i);
		u32 offered = cover.n != 0 ? ts_k_splat(&args, view, &cover, &point, (u32)i, 0) : 0;
		s->offered[i] += offered;
		sum += offered;
	}
	return sum;
}

static ts_status try_face(ts_probe *p, ts_probe_set *s, u32 r, u32 face, ts_spread *spread, json_t *faces)
{
	const ts_face *cube = &ts_probe_cubes(p)[r];
	ts_camera_k view = ts_k_cube_view(cube, face);
	u64 n = (u64)cube->n * cube->n;
	ts_spread before = *spread;
	u64 *texels = ts_alloc((size_t)n, sizeof *texels, "a face");
	if (texels == NULL) return TS_ERROR;
	memset(texels, 0xff, (size_t)n * sizeof *texels);
	ts_status status = TS_OK;
	if (splat_face(p, s, &view, texels) > 0) {
		status = ts_probe_spread_add(p, spread, texels, n, TS_B_splat_depth_index, cube->offset + face * n, s->triangle,
		                             s->index, s->n, s->won);
		ts_probe_append(p, faces,
		                json_pack("{s:o,s:I,s:I,s:I}", "face", ts_probe_face_name(r, face), "offered",
		                          (json_int_t)(spread->offered - before.offered), "won",
		                          (json_int_t)(spread->won - before.won), "lost",
		                          (json_int_t)(spread->lost - before.lost)));
	}
	free(texels);
	return status;
}

ts_status ts_probe_set_splat(ts_probe *p, ts_probe_set *s, ts_spread *spread, json_t *faces)
{
	if (s->n == 0) return TS_OK;
	u64 *words = ts_alloc_zero(ts_probe_n_words(p) + (size_t)1, sizeof *words, "visibility.bits");
	if (words == NULL) return TS_ERROR;
	ts_status status = ts_probe_fetch_bits(p, s->triangle, words);
	for (u32 r = 0; r < ts_probe_n_cubes(p) && status == TS_OK; r++) {
		u32 bits = ts_probe_cubes(p)[r].n != 0 ? ts_k_cube_bits(words, r) : 0;
		for (u32 face = 0; face < 6 && status == TS_OK; face++) {
			if ((bits >> face & 1) != 0) status = try_face(p, s, r, face, spread, faces);
		}
	}
	free(words);
	return status;
}

static ts_status count_found(ts_probe *p, ts_buffer_id id, const ts_probe_set *s, u64 *n_found, u64 *first)
{
	*n_found = 0;
	for (u64 i = 0; s->n > 0 && i < ts_probe_n(p, id); i++) {
		u32 point;
		if (ts_probe_fetch(p, id, i, 1, &point) != TS_OK) return TS_ERROR;
		if (point == TS_NONE || ts_probe_place(s->index, s->n, point) == s->n) continue;
		if (*n_found == 0) *first = i;
		++*n_found;
	}
	return TS_OK;
}

ts_status ts_probe_put_lookups(ts_probe *p, json_t *o, const ts_probe_set *s, u64 *n_samples)
{
	static const struct {
		ts_buffer_id id;
		const char *key;
	} founds[] = {
		{TS_B_lookup_point, "samples"},
		{TS_B_lookup_second_point, "samples_bounce2"},
		{TS_B_lookup_third_point, "samples_bounce3"},
	};
	*n_samples = 0;
	for (u32 b = 0; b < 3; b++) {
		u64 n, first = 0;
		ts_pixel pixel;
		if (!ts_probe_has(p, founds[b].id)) continue;
		if (count_found(p, founds[b].id, s, &n, &first) != TS_OK) return TS_ERROR;
		*n_samples += n;
		ts_probe_put(p, o, founds[b].key, ts_probe_int(n));
		if (b > 0 || n == 0) continue;
		if (ts_probe_fetch(p, TS_B_mirror_pixel_record, first / 25, 1, &pixel) != TS_OK) return TS_ERROR;
		ts_probe_put(p, o, "first_sample",
		             json_pack("{s:o,s:I}", "pixel",
		                       ts_probe_pair(pixel.index % p->view.width, pixel.index / p->view.width % p->view.height),
		                       "k", (json_int_t)(first % 25)));
	}
	return TS_OK;
}
