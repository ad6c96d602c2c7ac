/* A pixel of an eye that sees triangles: who covers it, and what the winner's surface is. Its light is told by the
 * families. */
#include <stdlib.h>
#include "parts.h"

static ts_status put_contest(ts_probe *p, json_t *o, u32 x, u32 y, u64 held)
{
	ts_offers offers = {.offer = NULL};
	ts_camera_k view = ts_k_view(&p->view);
	json_t *contest = json_object();
	ts_status status = ts_probe_contest(p, &view, TS_NONE, x, y, &offers);
	if (status == TS_OK) status = ts_probe_put_offers(p, contest, &offers, TS_B_eye_depth_triangle, held, NULL);
	ts_probe_put(p, o, "coverage", contest);
	free(offers.offer);
	return status;
}

static ts_status put_surface(ts_probe *p, json_t *o, u32 triangle, u32 x, u32 y, ts_surface *surface)
{
	ts_camera_k view = ts_k_view(&p->view);
	ts_corners t = ts_k_corners(&p->scene, triangle);
	ts_fragment f = ts_k_fragment_at(&view, &t, (i32)x, (i32)y);
	if (ts_probe_textures(p, triangle) != TS_OK) return TS_ERROR;
	*surface = ts_k_surface_seen(&p->scene, &view, triangle, (i32)x, (i32)y);
	ts_probe_put(p, o, "surface", ts_probe_surface(p, triangle, surface, f.w, ts_k_fragment_footprint(&view, &t, &f)));
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

static ts_status fetch_key(ts_probe *p, u32 x, u32 y, u64 *key)
{
	bool there;
	if (ts_probe_fetch_pixel(p, TS_B_eye_depth_triangle, x, y, 1, key, &there) != TS_OK) return TS_ERROR;
	if (there) return TS_OK;
	return ts_fail("%s: pixel (%u, %u) is outside its crop", p->trace->item[TS_B_eye_depth_triangle].path, (unsigned)x,
	               (unsigned)y);
}

ts_status ts_probe_eye_pixel(ts_probe *p, const ts_probe_question *q, const ts_buffer_id *needed, ts_probe_light *light,
                             json_t *o)
{
	ts_probe_seen at = {.x = q->x, .y = q->y};
	ts_v3 radiance = ts_k_background();
	if (ts_probe_scene(p) != TS_OK || ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	if (ts_probe_put_pixel(p, q, o) != TS_OK || fetch_key(p, q->x, q->y, &at.key) != TS_OK) return TS_ERROR;
	ts_status status = put_contest(p, o, q->x, q->y, at.key);
	if (status == TS_OK && at.key != TS_EMPTY) {
		status = put_surface(p, o, (u32)at.key, q->x, q->y, &at.surface);
		if (status == TS_OK) status = light(p, &at, o, &radiance);
	} else if (status == TS_OK) {
		ts_probe_put(p, o, "shading", json_string("nothing is here: background"));
	}
	return status == TS_OK ? ts_probe_put_image(p, o, q->x, q->y, radiance) : status;
}
