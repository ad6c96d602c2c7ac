/* Which faces may see a triangle, how densely it is sampled, and for which cube; and of a piece of it, how dense it is,
 * kept or dropped. The kernels run again for one reflector at a time. */
#include <stdlib.h>
#include "kernels/points/cull.h"
#include "kernels/points/density.h"
#include "methods/points/points.h"
#include "methods/points/tools/probe.h"
#include "methods/stages.h"
#include "trace/where.h"

/* Planes that all three corners lie beyond, as ts_k_outside_plane tests them. */
static json_t *planes_of(const ts_face *cube, u32 face, const ts_corners *t)
{
	ts_v3 centre = ts_load3(cube->centre);
	ts_v3 v[3] = {ts_k_face_axes(face, ts_sub(t->a, centre)), ts_k_face_axes(face, ts_sub(t->b, centre)),
	              ts_k_face_axes(face, ts_sub(t->c, centre))};
	bool right = true, left = true, top = true, bottom = true, near = true;
	for (u32 i = 0; i < 3; i++) {
		right &= v[i].x > v[i].z;
		left &= -v[i].x > v[i].z;
		top &= v[i].y > v[i].z;
		bottom &= -v[i].y > v[i].z;
		near &= v[i].z < cube->near;
	}
	return json_sprintf("%s%s%s%s%s", right ? "right " : "", left ? "left " : "", top ? "top " : "",
	                    bottom ? "bottom " : "", near ? "near" : "");
}

static json_t *faces_of(u32 bits)
{
	json_t *list = json_array();
	for (u32 face = 0; face < 6; face++) {
		if ((bits >> face & 1) != 0) json_array_append_new(list, json_string(ts_where_face(face)));
	}
	return list;
}

/* Why a cube does not see it. */
static json_t *unseen(ts_probe *p, u32 triangle, const ts_corners *t, u32 r, const char **why)
{
	const ts_face *cube = &ts_probe_cubes(p)[r];
	json_t *o = json_object();
	const char *reason = "no face sees it: beyond planes of all six";
	if (cube->n == 0) reason = "the reflector has no cube: the eye does not see it";
	if (!ts_k_is_facing(&p->scene, triangle, t, ts_load3(cube->centre)))
		reason = "it turns its back to the cube's centre";
	if (r == ts_k_reflector_of(&p->scene, triangle)) reason = "it belongs to this reflector";
	ts_probe_put(p, o, "reflector", ts_probe_int(r));
	ts_probe_put(p, o, "reason", json_string(reason));
	*why = reason;
	if (reason[0] != 'n' || TS_PARAM(&p->trace->params, visibility_test) == TS_VISIBILITY_VERTEX) return o;
	for (u32 face = 0; face < 6; face++) ts_probe_put(p, o, ts_where_face(face), planes_of(cube, face, t));
	return o;
}

/* Checks that with the kernel. */
static void put_check(ts_probe *p, u32 triangle, const u64 *bits, json_t *o)
{
	ts_visibility_args args = {.scene = p->scene,
	                           .cubes = ts_probe_cubes(p),
	                           .n_cubes = ts_probe_n_cubes(p),
	                           .n_words = ts_probe_n_words(p),
	                           .vertex_mode = TS_PARAM(&p->trace->params, visibility_test) == TS_VISIBILITY_VERTEX};
	ts_corners t = ts_k_corners(&p->scene, triangle);
	bool same = true;
	for (u32 r = 0; r < ts_probe_n_cubes(p); r++) {
		u32 faces = ts_k_is_degenerate(t.n) ? 0 : ts_k_visibility(&args, triangle, &t, r);
		same &= faces == ts_k_cube_bits(bits, r);
	}
	ts_probe_put(p, o, "check",
	             json_string(same ? "bits agree with visibility.bits" : "bits differ from visibility.bits"));
}

ts_status ts_probe_visibility(ts_probe *p, u32 triangle, u64 *bits, json_t *o, bool *seen, const char **why)
{
	ts_corners t = ts_k_corners(&p->scene, triangle);
	json_t *by = json_array(), *not_by = json_array();
	bool degenerate = ts_k_is_degenerate(t.n);
	*seen = false;
	*why = ts_probe_n_cubes(p) == 0 ? "there are no reflectors" : "it has no area";
	ts_status status = ts_probe_fetch_bits(p, triangle, bits);
	for (u32 r = 0; r < ts_probe_n_cubes(p) && status == TS_OK; r++) {
		const char *reason;
		u32 faces = ts_k_cube_bits(bits, r);
		*seen |= faces != 0;
		if (faces != 0) {
			ts_probe_append(p, by, json_pack("{s:I,s:o}", "reflector", (json_int_t)r, "faces", faces_of(faces)));
		} else if (!degenerate) {
			bool first = json_array_size(not_by) == 0;
			ts_probe_append(p, not_by, unseen(p, triangle, &t, r, &reason));
			*why = first || reason == *why ? reason : "not_seen_by tells each reflector's reason";
		}
	}
	ts_probe_put(p, o, "seen_by", by);
	ts_probe_put(p, o, "not_seen_by", not_by);
	if (status == TS_OK) put_check(p, triangle, bits, o);
	return status;
}

/* The density for one reflector alone, or for all. */
static f32 density(const ts_density_args *args, const ts_corners *t, const u64 *bits, u32 only, u64 *words)
{
	for (u32 w = 0; w < args->n_words; w++) words[w] = only == TS_NONE ? bits[w] : 0;
	for (u32 face = 0; face < 6 && only != TS_NONE; face++) {
		u32 bit = 6 * only + face;
		words[bit / 64] |= bits[bit / 64] & (u64)1 << (bit % 64);
	}
	return ts_put(ts_k_density(args, words, t->a, t->b, t->c).s);
}

static void put_setter(ts_probe *p, json_t *o, const ts_density_args *args, const ts_corners *t, const u64 *bits,
                       u64 *words)
{
	ts_density_args wanted = *args, needed = *args;
	f32 most_wanted = 0.0f, most_needed = 0.0f;
	u32 setter = TS_NONE, limiter = TS_NONE;
	wanted.cap = 0;
	needed.cap = 1;
	needed.rho = 1.2676506002282294e30f; /* 2^100: so that only the limit counts */
	for (u32 r = 0; r < ts_probe_n_cubes(p); r++) {
		if (ts_k_cube_bits(bits, r) == 0) continue;
		f32 a = density(&wanted, t, bits, r, words), b = density(&needed, t, bits, r, words);
		if (setter == TS_NONE || a > most_wanted) {
			most_wanted = a;
			setter = r;
		}
		if (limiter == TS_NONE || b > most_needed) {
			most_needed = b;
			limiter = r;
		}
	}
	f32 scale = density(args, t, bits, TS_NONE, words);
	bool capped = args->cap != 0 && scale < most_wanted;
	ts_probe_put(p, o, "wanted", ts_probe_bits(most_wanted));
	if (setter != TS_NONE) ts_probe_put(p, o, "wanted_by_reflector", ts_probe_int(setter));
	ts_probe_put(p, o, "limit", ts_probe_bits(most_needed));
	if (limiter != TS_NONE) ts_probe_put(p, o, "limit_by_reflector", ts_probe_int(limiter));
	ts_probe_put(p, o, "cap",
	             json_string(args->cap == 0 ? "off"
	                         : capped       ? "lowered the density"
	                                        : "did not lower it"));
}

ts_status ts_probe_density(ts_probe *p, u32 triangle, const u64 *bits, json_t *o)
{
	const ts_params *params = &p->trace->params;
	ts_density_args args = {.scene = p->scene,
	                        .cubes = ts_probe_cubes(p),
	                        .view = &p->view,
	                        .rho = ts_samples_a_pixel(params),
	                        .n_cubes = ts_probe_n_cubes(p),
	                        .n_words = ts_probe_n_words(p),
	                        .paper = TS_PARAM(params, density_path) == TS_DENSITY_PAPER,
	                        .cap = TS_PARAM(params, density_cap) != TS_DENSITY_CAP_OFF,
	                        .greatest = ts_greatest_side(params),
	                        .ball = TS_PARAM(params, density_mirror) == TS_MIRROR_BALL,
	                        .offaxis = TS_PARAM(params, density_off_axis),
	                        .split = TS_PARAM(params, points_split)};
	f32 held, scale;
	if (ts_probe_fetch(p, TS_B_split_triangle_density, triangle, 1, &held) != TS_OK) return TS_ERROR;
	u64 *words = ts_alloc_zero(ts_probe_n_words(p) + (size_t)1, sizeof *words, "visibility.bits");
	if (words == NULL) return TS_ERROR;
	ts_corners t = ts_k_corners(&p->scene, triangle);
	put_setter(p, o, &args, &t, bits, words);
	scale = density(&args, &t, bits, TS_NONE, words);
	ts_probe_put(p, o, "scale", ts_probe_bits(scale));
	ts_probe_put_check(p, o, TS_B_split_triangle_density, &scale, &held, 1);
	free(words);
	return TS_OK;
}

ts_status ts_probe_piece(ts_probe *p, u64 index, json_t *o, bool *kept)
{
	const ts_params *params = &p->trace->params;
	ts_piece piece;
	ts_align frame;
	f32 scale;
	u32 keep, again;
	if (ts_probe_fetch(p, TS_B_split_piece, index, 1, &piece) != TS_OK ||
	    ts_probe_fetch(p, TS_B_split_density, index, 1, &scale) != TS_OK ||
	    ts_probe_fetch(p, TS_B_cull_keep, index, 1, &keep) != TS_OK ||
	    ts_probe_fetch(p, TS_B_align_frame, index, 1, &frame) != TS_OK)
		return TS_ERROR;
	ts_cull_args args = {.pieces = &piece,
	                     .scale = &scale,
	                     .keep = &again,
	                     .seed = TS_PARAM(params, seed),
	                     .unit = ts_cull_unit(params),
	                     .enabled = TS_PARAM(params, points_cull)};
	ts_k_cull_item(&args, 0);
	f32 pixels = ts_k_cull_pixels(&args, 0);
	*kept = keep != 0;
	ts_probe_put(p, o, "piece", ts_probe_int(index));
	ts_probe_put(p, o, "path", ts_probe_int(piece.path));
	ts_probe_put(p, o, "scale", ts_probe_bits(scale));
	ts_probe_put(p, o, "area", ts_probe_real(ts_k_area(ts_load3(piece.a), ts_load3(piece.b), ts_load3(piece.c))));
	ts_probe_put(p, o, "cull_pixels", ts_probe_bits(pixels));
	ts_probe_put(p, o, "cull_threshold", ts_probe_int((u64)ts_k_cull_threshold(pixels)));
	ts_probe_put(p, o, "cull_chance", ts_probe_int((u64)ts_k_cull_chance(&args, 0)));
	ts_probe_put(p, o, "cull",
	             json_string(TS_PARAM(params, points_cull) == 0 ? "off"
	                         : keep != 0                        ? "kept"
	                                                            : "dropped"));
	ts_probe_put(p, o, "frame_scale", ts_probe_bits(frame.s));
	ts_probe_put(p, o, "check",
	             json_string(again == keep ? "bits agree with cull.keep" : "bits differ from cull.keep"));
	return TS_OK;
}
