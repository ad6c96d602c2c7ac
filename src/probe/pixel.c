/* A pixel of an eye that sees triangles: which cover it, and the winner's surface. The families add its light. */
#include <stdlib.h>
#include "kernels/raster/image.h"
#include "probe/parts.h"

static ts_status put_contest(ts_probe *p, json_t *o, const ts_probe_seen *at)
{
	ts_offers offers = {.offer = NULL};
	json_t *contest = json_object();
	ts_status status = ts_probe_contest(p, &at->view, TS_NONE, at->x, at->y, &offers);
	if (status == TS_OK) status = ts_probe_put_offers(p, contest, &offers, TS_B_eye_depth_triangle, at->key, NULL);
	ts_probe_put(p, o, "coverage", contest);
	free(offers.offer);
	return status;
}

static ts_status put_surface(ts_probe *p, json_t *o, ts_probe_seen *at)
{
	u32 triangle = (u32)at->key;
	ts_corners t = ts_k_corners(&p->scene, triangle);
	ts_fragment f = ts_k_fragment_at(&at->view, &t, (i32)at->x, (i32)at->y);
	if (ts_probe_textures(p, triangle) != TS_OK) return TS_ERROR;
	at->surface = ts_k_surface_seen(&p->scene, &at->view, triangle, (i32)at->x, (i32)at->y);
	f32 footprint = ts_k_fragment_footprint(&at->view, &t, &f);
	ts_probe_put(p, o, "surface", ts_probe_surface(p, triangle, &at->surface, f.w, footprint));
	return TS_OK;
}

ts_status ts_probe_put_image(ts_probe *p, json_t *o, u32 x, u32 y, ts_v3 radiance)
{
	f32 computed[3], held[3];
	u8 srgb[3];
	bool there;
	json_t *result = json_object();
	ts_store3(computed, radiance);
	ts_probe_put(p, result, "radiance", ts_probe_v3_bits(ts_load3(computed)));
	ts_status status = ts_probe_fetch_pixel(p, TS_B_image_radiance, x, y, 3, held, &there);
	if (status == TS_OK && there) ts_probe_put_check(p, result, TS_B_image_radiance, computed, held, 3);
	if (status == TS_OK) status = ts_probe_fetch_pixel(p, TS_B_image_srgb, x, y, 3, srgb, &there);
	if (status == TS_OK && there) {
		ts_probe_put(p, result, "srgb", json_pack("[i,i,i]", (int)srgb[0], (int)srgb[1], (int)srgb[2]));
	}
	ts_probe_put(p, o, "image", result);
	return status;
}

void ts_probe_put_shading(ts_probe *p, const ts_probe_seen *at, const u32 *lit, const ts_lamp *lamps, json_t *o,
                          ts_v3 *radiance)
{
	ts_v3 v = ts_normalize(ts_sub(ts_load3(p->view.eye), at->surface.p));
	ts_probe_put(p, o, "shading", ts_probe_shading(p, &at->surface, v, lit, lamps, radiance));
}

ts_status ts_probe_put_pixel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	if (q->x >= p->view.width || q->y >= p->view.height) {
		return ts_fail("%s: no pixel (%u, %u); the eye has %u x %u", p->trace->dir, (unsigned)q->x, (unsigned)q->y,
		               (unsigned)p->view.width, (unsigned)p->view.height);
	}
	ts_probe_put(p, o, "pixel", ts_probe_pair(q->x, q->y));
	ts_probe_put_method(p, o);
	return TS_OK;
}

static ts_status fetch_key(ts_probe *p, ts_probe_seen *at)
{
	bool there;
	if (ts_probe_fetch_pixel(p, TS_B_eye_depth_triangle, at->x, at->row, 1, &at->key, &there) != TS_OK) return TS_ERROR;
	if (there) return TS_OK;
	return ts_fail("%s: pixel (%u, %u) is outside its crop", p->trace->item[TS_B_eye_depth_triangle].path,
	               (unsigned)at->x, (unsigned)at->y);
}

/* Puts sample `sample` of `samples` of a pixel, and its radiance. */
static ts_status put_seen(ts_probe *p, ts_probe_seen *at, u32 samples, u32 sample, ts_probe_light *light, json_t *o,
                          ts_v3 *radiance)
{
	at->row = sample * p->view.height + at->y;
	at->view = ts_k_eye_view(&p->view, samples, sample);
	*radiance = ts_k_background();
	if (fetch_key(p, at) != TS_OK || put_contest(p, o, at) != TS_OK) return TS_ERROR;
	if (at->key != TS_EMPTY) return put_surface(p, o, at) == TS_OK ? light(p, at, o, radiance) : TS_ERROR;
	ts_probe_put(p, o, "shading", json_string("nothing is here: background"));
	return TS_OK;
}

/* Puts a sample with its radiance, which is also stored. */
static ts_status put_sample(ts_probe *p, ts_probe_seen *at, u32 sample, ts_probe_light *light, json_t *list,
                            f32 radiance[3])
{
	bool there;
	f32 held[3];
	ts_v3 computed;
	json_t *o = json_object();
	f32 x = (f32)ts_eye_sample[sample][0] * 0.00390625f, y = (f32)ts_eye_sample[sample][1] * 0.00390625f;
	ts_probe_put(p, o, "place", json_pack("[o,o]", ts_probe_real(x), ts_probe_real(y)));
	ts_status status = put_seen(p, at, TS_N_EYE_SAMPLES, sample, light, o, &computed);
	if (status == TS_OK) {
		status = ts_probe_fetch_pixel(p, TS_B_image_sample_radiance, at->x, at->row, 3, held, &there);
		ts_store3(radiance, computed);
		ts_probe_put(p, o, "radiance", ts_probe_v3_bits(ts_load3(radiance)));
	}
	if (status == TS_OK && there) ts_probe_put_check(p, o, TS_B_image_sample_radiance, radiance, held, 3);
	ts_probe_append(p, list, o);
	return status;
}

/* All samples of a pixel, and their mean. */
static ts_status put_samples(ts_probe *p, ts_probe_seen *at, ts_probe_light *light, json_t *o, ts_v3 *radiance)
{
	f32 samples[TS_N_EYE_SAMPLES * 3], mean[3];
	u64 keys[TS_N_EYE_SAMPLES];
	u8 srgb[3];
	json_t *list = json_array();
	ts_status status = TS_OK;
	for (u32 sample = 0; sample < TS_N_EYE_SAMPLES && status == TS_OK; sample++) {
		status = put_sample(p, at, sample, light, list, samples + (size_t)sample * 3);
		keys[sample] = at->key;
	}
	ts_probe_put(p, o, "samples", list);
	if (status != TS_OK) return status;
	ts_resolve_args args = {
		.samples = samples, .depth_triangle = keys, .radiance = mean, .srgb = srgb, .n_pixels = 1, .gain = 1.0f};
	ts_k_image_resolve_item(&args, 0);
	*radiance = ts_load3(mean);
	return TS_OK;
}

ts_status ts_probe_eye_pixel(ts_probe *p, const ts_probe_question *q, const ts_buffer_id *needed, ts_probe_light *light,
                             json_t *o)
{
	ts_probe_seen at = {.x = q->x, .y = q->y};
	ts_v3 radiance;
	if (ts_probe_scene(p) != TS_OK || ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	if (ts_probe_put_pixel(p, q, o) != TS_OK) return TS_ERROR;
	bool several = p->sizes.n[TS_DIM_eye_rows] > p->sizes.n[TS_DIM_height];
	ts_status status = several ? put_samples(p, &at, light, o, &radiance) : put_seen(p, &at, 1, 0, light, o, &radiance);
	return status == TS_OK ? ts_probe_put_image(p, o, q->x, q->y, radiance) : status;
}
