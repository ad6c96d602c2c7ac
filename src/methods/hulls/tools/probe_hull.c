/* A pixel of `hulls`: why it has its box, the light that the box's corners gathered, and each corner's share. */
#include <inttypes.h>
#include <stdlib.h>
#include "kernels/hulls/corner.h"
#include "methods/hulls/gloss.h"
#include "methods/hulls/tools/probe.h"
#include "methods/raster/tools/probe.h"

enum { MOST_LISTED = 8, N_CORNERS = 4 };

/* All boxes, and the grid's texel of the pixel. */
typedef struct {
	ts_choice_args args;
	const u32 *offset;
	const ts_segment *boxes;
	u64 n_boxes;
	ts_grid_place at;
} choice;

/* The box with its corners. */
typedef struct {
	ts_segment box;
	ts_moment moments[N_CORNERS];
	ts_lobes lobes[N_CORNERS];
	ts_corner_args source; /* the light that the corners gather */
	ts_hull_args args;     /* for this box alone */
	ts_shares weights, shares;
} hull;

static ts_status check_boxes(const ts_probe *p, const choice *c, u64 n_offsets)
{
	u32 grid = TS_PARAM(&p->trace->params, depth_grid_px);
	const char *path = p->trace->item[TS_B_segment_box_offset].path;
	if (ts_grid_check(&p->trace->params) != TS_OK) return TS_ERROR;
	if (n_offsets != (u64)grid * grid + 1) return ts_fail("%s: one a texel of the grid and one would be right", path);
	for (u64 i = 0; i < n_offsets; i++) {
		if (c->offset[i] <= c->n_boxes && (i == 0 || c->offset[i] >= c->offset[i - 1])) continue;
		return ts_fail("%s: element %" PRIu64 " is %u, after %u; there are %" PRIu64 " boxes", path, i,
		               (unsigned)c->offset[i], i > 0 ? (unsigned)c->offset[i - 1] : 0, c->n_boxes);
	}
	for (u64 b = 0; b < c->n_boxes; b++) {
		const ts_segment *s = &c->boxes[b];
		bool fits = s->low[0] <= s->high[0] && s->low[1] <= s->high[1] && s->high[0] < grid && s->high[1] < grid;
		if (fits) continue;
		return ts_fail("%s: element %" PRIu64 ": columns %u to %u, rows %u to %u of %u",
		               p->trace->item[TS_B_segment_box].path, b, (unsigned)s->low[0], (unsigned)s->high[0],
		               (unsigned)s->low[1], (unsigned)s->high[1], (unsigned)grid);
	}
	return TS_OK;
}

static ts_status read_choice(ts_probe *p, choice *c)
{
	const ts_params *params = &p->trace->params;
	c->offset = ts_probe_whole(p, TS_B_segment_box_offset);
	c->boxes = c->offset != NULL ? ts_probe_whole(p, TS_B_segment_box) : NULL;
	c->n_boxes = ts_probe_n(p, TS_B_segment_box);
	if (c->boxes == NULL) return TS_ERROR;
	c->args = (ts_choice_args){.offset = c->offset,
	                           .boxes = c->boxes,
	                           .grid = TS_PARAM(params, depth_grid_px),
	                           .robust = TS_PARAM(params, hull_surface) == TS_SURFACE_ROBUST,
	                           .step = TS_PARAM(params, segment_step)};
	return check_boxes(p, c, ts_probe_n(p, TS_B_segment_box_offset));
}

static ts_choice offer_of(const choice *c, u32 box)
{
	ts_choice offer = {.box = TS_NONE, .rank = 4};
	ts_k_choice_offer(&c->args, c->at, box, &offer);
	return offer;
}

static int by_rank(const void *a, const void *b)
{
	const ts_choice *s = a, *t = b;
	if (s->rank != t->rank) return s->rank < t->rank ? -1 : 1;
	if (s->measure != t->measure) return s->measure < t->measure ? -1 : 1;
	return (s->box > t->box) - (s->box < t->box);
}

static void put_offer(ts_probe *p, json_t *list, const choice *c, const ts_choice *offer)
{
	static const char *const fits[] = {"holds the pixel", "holds it within the step", "covers it at another depth",
	                                   "lies elsewhere"};
	json_t *o = json_object();
	const ts_segment *box = &c->boxes[offer->box];
	ts_probe_put(p, o, "box", ts_probe_int(offer->box));
	ts_probe_put(p, o, "block", ts_probe_int(box->label / TS_BLOCK_TEXELS));
	ts_probe_put(p, o, "label", ts_probe_int(box->label % TS_BLOCK_TEXELS));
	ts_probe_put(p, o, "fit", json_string(fits[offer->rank]));
	ts_probe_put(p, o, offer->rank < 2 ? "thickness" : "gap", ts_probe_real(offer->measure));
	ts_probe_put(p, o, "low", ts_probe_pair(box->low[0], box->low[1]));
	ts_probe_put(p, o, "high", ts_probe_pair(box->high[0], box->high[1]));
	ts_probe_put(p, o, "nearest", ts_probe_bits(box->nearest));
	ts_probe_put(p, o, "farthest", ts_probe_bits(box->farthest));
	ts_probe_append(p, list, o);
}

/* The boxes of the pixel's block in the order of their claims, and the chosen one if it is from another block. */
static ts_status put_offers(ts_probe *p, json_t *o, const choice *c, u32 block, u32 chosen)
{
	u32 first = c->offset[(u64)block * TS_BLOCK_TEXELS], n = c->offset[((u64)block + 1) * TS_BLOCK_TEXELS] - first;
	json_t *list = json_array();
	ts_choice *offers = ts_alloc(n + (size_t)1, sizeof *offers, "boxes");
	if (offers == NULL) return TS_ERROR;
	for (u32 i = 0; i < n; i++) offers[i] = offer_of(c, first + i);
	qsort(offers, n, sizeof *offers, by_rank);
	for (u32 i = 0; i < n && i < MOST_LISTED; i++) put_offer(p, list, c, &offers[i]);
	free(offers);
	ts_probe_put(p, o, "boxes", ts_probe_int(n));
	if (n > MOST_LISTED) ts_probe_put(p, o, "listed", ts_probe_int(MOST_LISTED));
	if (chosen != TS_NONE && (chosen < first || chosen - first >= n)) {
		ts_choice offer = offer_of(c, chosen);
		put_offer(p, list, c, &offer);
	}
	ts_probe_put(p, o, "by_claim", list);
	return TS_OK;
}

static ts_status put_choice(ts_probe *p, json_t *o, const choice *c, const ts_probe_seen *at, u32 *chosen)
{
	u32 held, block = ts_k_block_of(c->args.grid, c->at.x, c->at.y);
	bool there;
	*chosen = ts_k_choose_box(&c->args, c->at);
	ts_probe_put(p, o, "texel", ts_probe_pair(c->at.x, c->at.y));
	ts_probe_put(p, o, "block", ts_probe_int(block));
	ts_status status = put_offers(p, o, c, block, *chosen);
	ts_probe_put(p, o, "box", *chosen != TS_NONE ? ts_probe_int(*chosen) : json_string("none: the pixel stays dark"));
	if (status == TS_OK) status = ts_probe_fetch_pixel(p, TS_B_hull_box, at->x, at->row, 1, &held, &there);
	if (status == TS_OK && there) ts_probe_put_record_check(p, o, TS_B_hull_box, chosen, &held);
	return status;
}

static ts_status read_hull(ts_probe *p, hull *h, u32 box)
{
	const ts_params *params = &p->trace->params;
	ts_direct_args from;
	if (ts_probe_read_source(p, &from) != TS_OK) return TS_ERROR;
	h->source = (ts_corner_args){.patches = from.patches,
	                             .lamps = from.lamps,
	                             .shapes = from.shapes,
	                             .n_patches = from.n_patches,
	                             .n_lamps = from.n_lamps,
	                             .paper = TS_PARAM(params, corner_facing) == TS_FACING_PAPER};
	if (ts_probe_fetch(p, TS_B_segment_box, box, 1, &h->box) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_corner_moment, (u64)box * N_CORNERS, N_CORNERS, h->moments) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_corner_lobes, (u64)box * N_CORNERS, N_CORNERS, h->lobes) != TS_OK) return TS_ERROR;
	h->args = (ts_hull_args){.choice = {.boxes = &h->box, .grid = TS_PARAM(params, depth_grid_px)},
	                         .moments = h->moments,
	                         .lobes = h->lobes,
	                         .width = p->view.width,
	                         .height = p->view.height,
	                         .cosine = TS_PARAM(params, hull_cosine),
	                         .by_moments = TS_PARAM(params, hull_interpolation) == TS_INTERPOLATION_MOMENTS,
	                         .vmf = TS_PARAM(params, hull_sharpness) == TS_SHARPNESS_VMF,
	                         .printed = TS_PARAM(params, hull_integrals) == TS_INTEGRALS_PRINTED,
	                         .rectangle = TS_PARAM(params, hull_corners) == TS_CORNERS_RECTANGLE};
	return TS_OK;
}

/* Computes the corner's gathering again, where the G-buffer holds its pixel. */
static ts_status put_gathered(ts_probe *p, json_t *o, const hull *h, u32 k)
{
	bool there;
	ts_gpixel pixel;
	ts_moment made;
	json_t *gathered = json_object();
	const ts_moment *held = &h->moments[k];
	ts_camera_k view = ts_k_view(&p->view);
	ts_corner_pixel at = ts_k_corner_pixel(&view, &h->box, h->args.choice.grid, h->args.rectangle, k);
	ts_probe_put(p, o, "pixel", ts_probe_pair(at.x, at.y));
	ts_probe_put(p, gathered, "position", ts_probe_v3(ts_load3(held->position)));
	ts_probe_put(p, gathered, "sum_of_weights", ts_probe_v3_bits(ts_load3(held->sum)));
	ts_status status = ts_probe_fetch_pixel(p, TS_B_gbuffer_pixel, at.x, at.y, 1, &pixel, &there);
	if (status == TS_OK && there) {
		bool seen = pixel.depth >= h->box.nearest && pixel.depth <= h->box.farthest;
		ts_probe_put(p, o, "place",
		             json_string(seen ? "as the G-buffer has it" : "corrected to the middle of the box"));
		ts_k_gather_all(&made, &h->source, ts_k_box_corner(&view, &h->box, &pixel, at));
		ts_probe_put_record_check(p, gathered, TS_B_corner_moment, &made, held);
	}
	ts_probe_put(p, o, "gathered", gathered);
	return status;
}

static void put_fitted(ts_probe *p, json_t *o, const hull *h, u32 k)
{
	ts_lobes made;
	static const char *const phis[] = {"phi_red", "phi_green", "phi_blue"};
	json_t *fitted = json_object();
	const ts_lobes *held = &h->lobes[k];
	ts_corner_lobes_args args = {.moments = &h->moments[k], .lobes = &made, .vmf = h->args.vmf};
	ts_k_corner_lobes_item(&args, 0);
	ts_probe_put(p, fitted, "mu", ts_probe_v3_bits(ts_load3(held->mu)));
	ts_probe_put(p, fitted, "lambda", ts_probe_v3_bits(ts_load3(held->lambda)));
	for (u32 c = 0; c < 3; c++) ts_probe_put(p, fitted, phis[c], ts_probe_v3(ts_load3(held->phi + c * 3)));
	ts_probe_put_record_check(p, fitted, TS_B_corner_lobes, &made, held);
	ts_probe_put(p, o, "fitted", fitted);
}

static ts_status put_corners(ts_probe *p, json_t *object, const hull *h)
{
	static const char *const names[] = {"top left", "top right", "bottom left", "bottom right"};
	json_t *list = json_array();
	ts_status status = TS_OK;
	for (u32 k = 0; k < N_CORNERS && status == TS_OK; k++) {
		json_t *o = json_object();
		ts_probe_put(p, o, "corner", json_string(names[k]));
		ts_probe_put(p, o, "zn", ts_probe_bits(h->moments[k].depth));
		ts_probe_put(p, o, "weight", ts_probe_bits(h->weights.of[k]));
		ts_probe_put(p, o, "share", ts_probe_bits(h->shares.of[k]));
		status = put_gathered(p, o, h, k);
		put_fitted(p, o, h, k);
		ts_probe_append(p, list, o);
	}
	ts_probe_put(p, object, "corners", list);
	return status;
}

static ts_status put_hull(ts_probe *p, json_t *object, hull *h, u32 x, u32 y, const ts_gpixel *pixel, f32 irradiance[3])
{
	json_t *lobes = json_array();
	h->weights = ts_k_box_weights(&h->args, 0, x, y);
	h->shares = ts_k_box_shares(&h->args, 0, x, y);
	ts_status status = put_corners(p, object, h);
	for (u32 channel = 0; channel < 3; channel++) {
		ts_sg g = ts_k_hull_lobe(&h->args, 0, &h->shares, channel);
		ts_probe_append(p, lobes, ts_probe_lobe(p, &h->args, &g, ts_load3(pixel->normal), channel));
		irradiance[channel] = ts_k_lobe_irradiance(&h->args, &g, ts_load3(pixel->normal));
	}
	ts_probe_put(p, object, "lobes", lobes);
	return status;
}

/* The specular reflection of the lobes. */
static ts_status put_specular(ts_probe *p, const ts_probe_seen *at, json_t *object, const hull *h,
                              const ts_gpixel *pixel, f32 specular[3])
{
	ts_glossy glossy;
	json_t *o = json_object(), *lobes = json_array();
	ts_status status = ts_probe_put_gloss(p, at, pixel, o, &glossy);
	for (u32 channel = 0; channel < 3; channel++) {
		json_t *lobe = json_object();
		ts_sg light = ts_k_hull_lobe(&h->args, 0, &h->shares, channel);
		ts_v3 sent = ts_probe_put_reflected(p, lobe, &glossy, &light);
		specular[channel] = (&sent.x)[channel];
		ts_probe_append(p, lobes, lobe);
	}
	ts_probe_put(p, o, "lobes", lobes);
	ts_probe_put(p, object, "gloss", o);
	return status;
}

/* The light by hulls. */
static ts_status put_light_from(ts_probe *p, const ts_probe_seen *at, const ts_gpixel *pixel, json_t *object,
                                ts_probe_gathered *gathered)
{
	static const ts_buffer_id needed[] = {TS_B_segment_box_offset, TS_B_segment_box, TS_B_corner_moment,
	                                      TS_B_corner_lobes, TS_N_BUFFERS};
	u32 box = TS_NONE, grid = TS_PARAM(&p->trace->params, depth_grid_px);
	json_t *o = json_object();
	hull h;
	choice c = {.at = {.x = ts_k_resample(at->x, p->view.width, grid),
	                   .y = ts_k_resample(at->y, p->view.height, grid),
	                   .depth = pixel->depth}};
	ts_status status = ts_probe_require(p, needed);
	if (status == TS_OK) status = read_choice(p, &c);
	if (status == TS_OK) status = put_choice(p, o, &c, at, &box);
	ts_probe_put(p, object, "hull", o);
	*gathered = (ts_probe_gathered){.reflects = ts_gloss_is_asked(&p->trace->params)};
	if (status != TS_OK || box == TS_NONE) return status;
	if (read_hull(p, &h, box) != TS_OK) return TS_ERROR;
	if (put_hull(p, object, &h, at->x, at->y, pixel, gathered->irradiance) != TS_OK) return TS_ERROR;
	return gathered->reflects ? put_specular(p, at, object, &h, pixel, gathered->specular) : TS_OK;
}

static ts_status put_light(ts_probe *p, const ts_probe_seen *at, json_t *o, ts_v3 *radiance)
{
	return ts_probe_put_indirect(p, at, put_light_from, o, radiance);
}

ts_status ts_probe_hull_pixel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	return ts_probe_eye_pixel(p, q, ts_probe_source_needed(p), put_light, o);
}
