/* A pixel of surfels: the nearest, the blended and the hidden fragments, and the results of their sums. */
#include <inttypes.h>
#include <stdlib.h>
#include "kernels/surfels/surfel_blend_mean.h"
#include "kernels/surfels/surfel_blend_order.h"
#include "kernels/surfels/surfel_shade.h"
#include "methods/stages.h"
#include "methods/surfels/surfel.h"
#include "methods/surfels/tools/probe.h"

enum { MOST_LISTED = 16 };

/* Where the pixel is. */
typedef struct {
	ts_camera_k view;
	ts_filter filter;
	ts_surfel_shade_args shade; /* for methods that shade before they blend; otherwise .shading is 0 */
	i32 x, y;
	u64 pixel;
	f32 shift;
} place;

/* A surfel that covers the pixel. */
typedef struct {
	u32 surfel;
	f32 weight;
	ts_surfel_fragment is;
	ts_attributes adds;
} fragment;
typedef struct {
	fragment *fragment;
	size_t n, capacity;
} fragments;

static ts_status load(ts_probe *p, const char *const *stages)
{
	if (ts_probe_load_for(p, stages) != TS_OK) return TS_ERROR;
	memcpy(&p->view, ts_probe_loaded(p, TS_B_eye_view), sizeof p->view);
	return TS_OK;
}

static ts_surfel_shade_args shade_of(const ts_probe *p)
{
	ts_surfel_shade_args shade = ts_surfel_shading(&p->load->run);
	shade.of.surfels = ts_probe_loaded(p, TS_B_scene_surfel);
	if (shade.shading != 0) shade.lights = ts_probe_loaded(p, TS_B_lamp_light);
	if (shade.shading == TS_SHADING_PHONG) shade.slopes = ts_probe_loaded(p, TS_B_normal_field_slope);
	return shade;
}

static place place_of(const ts_probe *p, u32 x, u32 y)
{
	const f32 *epsilon = ts_probe_loaded(p, TS_B_surfel_setup_epsilon);
	place at = {.view = ts_k_view(&p->view), .filter = ts_surfel_filter(&p->load->run), .x = (i32)x, .y = (i32)y};
	at.shade = shade_of(p);
	at.pixel = (u64)y * p->view.width + x;
	at.shift = ts_k_pixel_shift(&at.view, *epsilon, at.x, at.y);
	return at;
}

static bool is_in_box(const ts_disc *disc, const place *at)
{
	return at->x >= disc->low[0] && at->x <= disc->high[0] && at->y >= disc->low[1] && at->y <= disc->high[1];
}

static ts_disc_hit hit_of(const ts_disc *disc, const place *at)
{
	ts_v2 d = ts_k_disc_offset(disc, at->x, at->y);
	return ts_k_disc_hit(disc, at->view.near, d.x, d.y);
}

/* Where the ray meets the plane, and its distance from the centre by either filter. */
static void put_hit(ts_probe *p, json_t *o, const ts_disc *disc, const place *at)
{
	ts_v2 d = ts_k_disc_offset(disc, at->x, at->y);
	ts_disc_hit hit = hit_of(disc, at);
	if (hit.meets) {
		ts_probe_put(p, o, "plane", json_pack("[o,o]", ts_probe_real(hit.a), ts_probe_real(hit.b)));
		ts_probe_put(p, o, "r3D", ts_probe_real(ts_sqrt(ts_flush(hit.r2))));
	} else {
		ts_probe_put(p, o, "plane", json_string("not met"));
	}
	if (at->filter.per_sigma2 > 0.0f && (disc->flags & TS_DISC_CROSSES) == 0) {
		f32 square = (d.x * d.x + d.y * d.y) * at->filter.per_sigma2;
		ts_probe_put(p, o, "r2D", ts_probe_real(ts_sqrt(ts_flush(square))));
	}
}

/* The least key, and how many surfels' ellipses cover the pixel. */
static u64 nearest_of(const ts_probe *p, const place *at, u64 *n_inside)
{
	u64 least = TS_EMPTY, n = ts_frame_n(&p->load->run.frame, TS_B_surfel_setup_disc);
	const ts_disc *discs = ts_probe_loaded(p, TS_B_surfel_setup_disc);
	*n_inside = 0;
	for (u64 i = 0; i < n; i++) {
		if (!is_in_box(&discs[i], at)) continue;
		ts_disc_hit hit = hit_of(&discs[i], at);
		u64 key = (u64)ts_f2u(ts_put(hit.z + at->shift)) << 32 | i;
		*n_inside += hit.inside;
		if (hit.inside && key < least) least = key;
	}
	return least;
}

static void put_visibility(ts_probe *p, json_t *object, const place *at)
{
	json_t *o = json_object();
	u64 n_inside, nearest = nearest_of(p, at, &n_inside);
	u64 held = ((const u64 *)ts_probe_loaded(p, TS_B_surfel_depth_surfel))[at->pixel];
	ts_probe_put(p, o, "surfels", ts_probe_int(n_inside));
	if (nearest != TS_EMPTY) {
		const ts_disc *disc = (const ts_disc *)ts_probe_loaded(p, TS_B_surfel_setup_disc) + (u32)nearest;
		ts_probe_put(p, o, "nearest", ts_probe_int((u32)nearest));
		put_hit(p, o, disc, at);
		ts_probe_put(p, o, "depth", ts_probe_bits(hit_of(disc, at).z));
		ts_probe_put(p, o, "epsilon", ts_probe_real(*(const f32 *)ts_probe_loaded(p, TS_B_surfel_setup_epsilon)));
		ts_probe_put(p, o, "epsilon_in_depth", ts_probe_bits(at->shift));
		ts_probe_put(p, o, "visible_to", ts_probe_bits(ts_u2f((u32)(nearest >> 32))));
	}
	ts_probe_put_record_check(p, o, TS_B_surfel_depth_surfel, &nearest, &held);
	ts_probe_put(p, object, "visibility", o);
}

static ts_status add(fragments *list, fragment f)
{
	void *array = list->fragment;
	if (ts_grow(&array, &list->capacity, list->n + 1, sizeof f, "fragments") != TS_OK) return TS_ERROR;
	list->fragment = array;
	list->fragment[list->n++] = f;
	return TS_OK;
}

static int by_weight(const void *a, const void *b)
{
	const fragment *s = a, *t = b;
	if (s->weight != t->weight) return s->weight > t->weight ? -1 : 1;
	return (s->surfel > t->surfel) - (s->surfel < t->surfel);
}

/* As the kernels compute them. */
static ts_attributes attributes_of(const place *at, const ts_disc *disc, u32 surfel)
{
	const ts_surfel_shade_args *shade = &at->shade;
	const ts_surfel *of = &shade->of.surfels[surfel];
	if (shade->shading == 0) return ts_k_attributes(of, disc);
	ts_shading_place where = ts_k_centre_place(of, disc);
	if (shade->shading == TS_SHADING_PHONG) {
		const f32 *slopes = shade->slopes + (u64)surfel * TS_FIELD_SLOPES;
		where = ts_k_fragment_place(of, disc, slopes, at->view.near, at->x, at->y);
	}
	return ts_k_shaded_colour(shade, &at->view, surfel, &where);
}

/* The fates of fragments. */
enum { BLENDED, HIDDEN, NOT_NEAREST, N_FATES };

static u32 fate_of(const place *at, u64 key, const fragment *f)
{
	if (!ts_k_is_visible(&at->filter, key, f->is.z)) return HIDDEN;
	return ts_k_shows(at->shade.shading, key, f->surfel) ? BLENDED : NOT_NEAREST;
}

/* All fragments, in the order of their surfels. Release all by free(), also on failure. */
static ts_status find(const ts_probe *p, const place *at, u64 key, fragments of[N_FATES])
{
	u64 n = ts_frame_n(&p->load->run.frame, TS_B_surfel_setup_disc);
	const ts_disc *discs = ts_probe_loaded(p, TS_B_surfel_setup_disc);
	for (u64 i = 0; i < n; i++) {
		if (!is_in_box(&discs[i], at)) continue;
		fragment f = {.surfel = (u32)i,
		              .is = ts_k_surfel_fragment(&discs[i], &at->filter, at->view.near, at->x, at->y),
		              .adds = attributes_of(at, &discs[i], (u32)i)};
		if (!f.is.covers) continue;
		f.weight = ts_k_fragment_weight(&f.is);
		if (add(&of[fate_of(at, key, &f)], f) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static void put_fragment(ts_probe *p, json_t *list, const fragment *f, const place *at, u64 key)
{
	json_t *o = json_object();
	f32 limit = ts_u2f((u32)(key >> 32));
	const ts_disc *disc = (const ts_disc *)ts_probe_loaded(p, TS_B_surfel_setup_disc) + f->surfel;
	ts_probe_put(p, o, "surfel", ts_probe_int(f->surfel));
	ts_probe_put(p, o, "weight", ts_probe_bits(f->weight));
	if (at->shade.shading != 0) {
		const f32 *adds = f->adds.value;
		ts_probe_put(p, o, "normal", ts_probe_v3_bits(ts_load3(adds + 3)));
		ts_probe_put(p, o, "shaded", ts_probe_v3_bits(ts_load3(adds)));
	}
	put_hit(p, o, disc, at);
	if (at->filter.filter == TS_FILTER_EWA) {
		ts_probe_put(p, o, "peak", ts_probe_real(f->is.peak));
		ts_probe_put(p, o, "exponent", ts_probe_real(f->is.exponent));
	}
	ts_probe_put(p, o, "depth", ts_probe_bits(f->is.z));
	if (!f->is.inside) ts_probe_put(p, o, "depth_of", json_string("its centre"));
	if (key != TS_EMPTY && f->is.z <= limit) {
		ts_probe_put(p, o, "before", json_real((double)limit - (double)f->is.z));
	} else if (key != TS_EMPTY) {
		ts_probe_put_margin(p, o, limit, f->is.z);
	}
	ts_probe_append(p, list, o);
}

/* The heaviest are listed, the rest summed up. */
static void put_fragments(ts_probe *p, json_t *object, const char *name, fragments *all, const place *at, u64 key)
{
	json_t *o = json_object(), *list = json_array(), *others = json_object();
	f32 rest = 0.0f;
	if (all->n > 0) qsort(all->fragment, all->n, sizeof *all->fragment, by_weight);
	for (size_t i = 0; i < all->n; i++) {
		if (i < MOST_LISTED) {
			put_fragment(p, list, &all->fragment[i], at, key);
		} else {
			rest += all->fragment[i].weight;
		}
	}
	ts_probe_put(p, o, "fragments", ts_probe_int(all->n));
	ts_probe_put(p, o, "heaviest", list);
	if (all->n > MOST_LISTED) {
		ts_probe_put(p, others, "fragments", ts_probe_int(all->n - MOST_LISTED));
		ts_probe_put(p, others, "weight", ts_probe_real(rest));
		ts_probe_put(p, o, "others", others);
	} else {
		json_decref(others);
	}
	ts_probe_put(p, object, name, o);
}

/* Adds them as the kernels do, into the sums and the heaviest of this pixel alone. */
static void sum_up(const ts_probe *p, const place *at, const fragments *blended, i64 *sums, u64 *heaviest)
{
	const ts_params *params = &p->trace->params;
	bool ordered = at->shade.shading == 0 && ts_accumulates_in_order(params);
	ts_surfel_blend_args args = {.sums = sums, .heaviest = heaviest};
	ts_blend_target target = ts_k_blend_none();
	for (size_t i = 0; i < blended->n; i++) {
		const fragment *f = &blended->fragment[i];
		ts_k_blend_add(&args, 0, f->surfel, &f->adds, f->weight);
		if (ordered) ts_k_blend_next(TS_PARAM(params, surfel_blend_accumulation), &target, &f->adds, f->weight);
	}
	if (ordered) ts_k_blend_end(TS_PARAM(params, surfel_blend_accumulation), &target, (u32)blended->n, sums);
}

static json_t *real_of(i64 sum) { return json_real((double)sum / (1 << TS_BLEND_BITS)); }

static json_t *real3_of(const i64 *sums)
{
	return json_pack("[o,o,o]", real_of(sums[0]), real_of(sums[1]), real_of(sums[2]));
}

static void put_sums(ts_probe *p, json_t *object, const i64 *sums, const i64 *held)
{
	json_t *o = json_object();
	u32 k = 0;
	while (k < TS_BLEND_SUMS && sums[k] == held[k]) k++;
	ts_probe_put(p, o, "colour", real3_of(sums));
	ts_probe_put(p, o, "normal", real3_of(sums + 3));
	ts_probe_put(p, o, "weight", real_of(sums[TS_BLEND_WEIGHT]));
	ts_probe_put(p, o, "fragments", json_integer((json_int_t)sums[TS_BLEND_FRAGMENTS]));
	ts_probe_put(p, o, "check",
	             k == TS_BLEND_SUMS
	                 ? json_string("bits agree with surfel_blend.sum")
	                 : json_sprintf("bits differ from surfel_blend.sum, whose sum %u is %" PRId64 ", not %" PRId64,
	                                (unsigned)k, held[k], sums[k]));
	ts_probe_put(p, object, "sums", o);
}

static void put_heaviest(ts_probe *p, json_t *object, u64 heaviest, u64 held)
{
	json_t *o = json_object();
	if (heaviest != TS_EMPTY) {
		ts_probe_put(p, o, "surfel", ts_probe_int((u32)heaviest));
		ts_probe_put(p, o, "weight", ts_probe_bits(ts_u2f(~(u32)(heaviest >> 32))));
	}
	ts_probe_put_record_check(p, o, TS_B_surfel_blend_heaviest, &heaviest, &held);
	ts_probe_put(p, object, "heaviest", o);
}

static ts_status put_blend(ts_probe *p, json_t *o, const place *at)
{
	i64 sums[TS_BLEND_SUMS] = {0};
	u64 heaviest = TS_EMPTY, key = ((const u64 *)ts_probe_loaded(p, TS_B_surfel_depth_surfel))[at->pixel];
	fragments of[N_FATES] = {{.fragment = NULL}};
	ts_status status = find(p, at, key, of);
	if (status == TS_OK) {
		sum_up(p, at, &of[BLENDED], sums, &heaviest);
		put_fragments(p, o, "blended", &of[BLENDED], at, key);
		put_fragments(p, o, "hidden_by_epsilon", &of[HIDDEN], at, key);
		if (at->shade.shading == TS_SHADING_FLAT) put_fragments(p, o, "not_the_nearest", &of[NOT_NEAREST], at, key);
		put_sums(p, o, sums, (const i64 *)ts_probe_loaded(p, TS_B_surfel_blend_sum) + at->pixel * TS_BLEND_SUMS);
		put_heaviest(p, o, heaviest, ((const u64 *)ts_probe_loaded(p, TS_B_surfel_blend_heaviest))[at->pixel]);
	}
	for (u32 fate = 0; fate < N_FATES; fate++) free(of[fate].fragment);
	return status;
}

/* The mean from the stored sums. */
static ts_status put_mean(ts_probe *p, json_t *object, const place *at)
{
	json_t *o = json_object();
	u64 n = (u64)p->view.width * p->view.height;
	const i64 *sums = (const i64 *)ts_probe_loaded(p, TS_B_surfel_blend_sum) + at->pixel * TS_BLEND_SUMS;
	const ts_gpixel *held = (const ts_gpixel *)ts_probe_loaded(p, TS_B_gbuffer_pixel) + at->pixel;
	ts_gpixel *pixels = ts_alloc_zero((size_t)n, sizeof *pixels, "a G-buffer");
	ts_surfel_blend_mean_args args = {.view = &p->view,
	                                  .discs = ts_probe_loaded(p, TS_B_surfel_setup_disc),
	                                  .epsilon = ts_probe_loaded(p, TS_B_surfel_setup_epsilon),
	                                  .keys = ts_probe_loaded(p, TS_B_surfel_depth_surfel),
	                                  .sums = ts_probe_loaded(p, TS_B_surfel_blend_sum),
	                                  .heaviest = ts_probe_loaded(p, TS_B_surfel_blend_heaviest),
	                                  .pixels = pixels};
	if (pixels == NULL) return TS_ERROR;
	ts_k_surfel_blend_mean_item(&args, at->pixel);
	const ts_gpixel *made = &pixels[at->pixel];
	if (made->depth != TS_SKY) {
		f32 length = ts_length(ts_k_mean(sums + 3, (f32)sums[TS_BLEND_WEIGHT]));
		const char *colour = at->shade.shading == 0 ? "albedo" : "colour";
		ts_probe_put(p, o, colour, ts_probe_v3_bits(ts_load3(made->albedo)));
		ts_probe_put(p, o, "mean_of_normals", ts_probe_real(length));
		ts_probe_put(p, o, "normal_of",
		             json_string(length < TS_LEAST_NORMAL ? "the heaviest: they cancel" : "their mean"));
		ts_probe_put(p, o, "normal", ts_probe_v3_bits(ts_load3(made->normal)));
		const char *of = args.keys[at->pixel] != TS_EMPTY ? "the nearest" : "the heaviest's centre";
		ts_probe_put(p, o, "depth_of", json_string(of));
		ts_probe_put(p, o, "depth", ts_probe_bits(ts_k_pixel_depth(&args, &at->view, at->pixel, at->x, at->y)));
		ts_probe_put(p, o, "position", ts_probe_v3_bits(ts_load3(made->position)));
	}
	ts_probe_put(p, o, "zn", ts_probe_bits(made->depth));
	ts_probe_put_record_check(p, o, TS_B_gbuffer_pixel, made, held);
	free(pixels);
	ts_probe_put(p, object, "mean", o);
	return TS_OK;
}

static ts_status put_surfels(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	if (ts_probe_put_pixel(p, q, o) != TS_OK) return TS_ERROR;
	place at = place_of(p, q->x, q->y);
	put_visibility(p, o, &at);
	return put_blend(p, o, &at) == TS_OK ? put_mean(p, o, &at) : TS_ERROR;
}

/* Without shadows there are no lamps, and shapes that depend on texels stay unchecked. */
ts_status ts_probe_surfel_pixel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	static const char *const stages[] = {"surfel_depth", "surfel_blend", "surfel_blend.mean", "deferred", NULL};
	ts_v3 total;
	ts_probe_lamps lamps;
	bool shadows = ts_shader_has_shadows(&p->trace->params);
	if (load(p, stages) != TS_OK) return TS_ERROR;
	ts_status status = shadows ? ts_probe_read_lamps(p, TS_PROBE_VIEW_OR_CUBE, &lamps) : ts_probe_shapes(p, TS_UNKNOWN);
	if (status != TS_OK || put_surfels(p, q, o) != TS_OK) return TS_ERROR;
	if (ts_probe_put_deferred(p, shadows ? &lamps : NULL, q->x, q->y, o, &total) != TS_OK) return TS_ERROR;
	return ts_probe_put_image(p, o, q->x, q->y, total);
}

ts_status ts_probe_shaded_pixel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	static const char *const stages[] = {"surfel_depth", "surfel_blend", "surfel_blend.mean", "surfel_shade.image",
	                                     NULL};
	if (load(p, stages) != TS_OK || ts_probe_shapes(p, TS_UNKNOWN) != TS_OK) return TS_ERROR;
	if (put_surfels(p, q, o) != TS_OK) return TS_ERROR;
	const ts_gpixel *pixels = ts_probe_loaded(p, TS_B_gbuffer_pixel);
	f32 exposure = TS_PARAM(&p->trace->params, image_exposure);
	ts_v3 total = ts_k_surfel_shown(&pixels[(u64)q->y * p->view.width + q->x], exposure);
	return ts_probe_put_image(p, o, q->x, q->y, total);
}
