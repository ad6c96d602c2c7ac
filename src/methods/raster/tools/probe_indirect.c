/* A pixel of indirect light: its place in the G-buffer, the light that arrives, and the light that it reflects;
 * triangles of light, and the texels of reflective shadow maps that hold them. */
#include "kernels/raster/gbuffer.h"
#include "kernels/raster/indirect.h"
#include "kernels/raster/rsm.h"
#include "methods/raster/tools/probe.h"

void ts_probe_put_shining(ts_probe *p, json_t *o, const ts_patch *patch)
{
	ts_v3 third = ts_v3_make(1.0f / 3.0f, 1.0f / 3.0f, 1.0f / 3.0f);
	ts_v3 a = ts_load3(patch->a), b = ts_load3(patch->b), c = ts_load3(patch->c);
	ts_probe_put(p, o, "middle", ts_probe_v3(ts_blend(third, a, b, c)));
	ts_probe_put(p, o, "area", ts_probe_real(0.5f * ts_length(ts_cross(ts_sub(b, a), ts_sub(c, a)))));
	ts_probe_put(p, o, "exitance", ts_probe_v3_bits(ts_load3(patch->exitance)));
}

ts_status ts_probe_put_patch(ts_probe *p, json_t *o, const ts_probe_lamps *lamps, u32 index, const ts_patch *patch)
{
	u64 key;
	const ts_offscreen *view = &lamps->views[ts_k_view_of_texel(lamps->views, lamps->n_views, index)];
	u32 texel = index - (u32)view->offset;
	ts_probe_put(p, o, "patch", ts_probe_int(index));
	ts_probe_put(p, o, "light", ts_probe_int(view->light));
	ts_probe_put(p, o, "view", ts_probe_int((u64)(view - lamps->views)));
	ts_probe_put(p, o, "texel", ts_probe_pair(texel % view->width, texel / view->width));
	if (ts_probe_has(p, TS_B_rsm_depth_triangle)) {
		if (ts_probe_fetch(p, TS_B_rsm_depth_triangle, index, 1, &key) != TS_OK) return TS_ERROR;
		if (key != TS_EMPTY) ts_probe_put_triangle(p, o, (u32)key);
	}
	ts_probe_put_shining(p, o, patch);
	return TS_OK;
}

static ts_status put_gbuffer(ts_probe *p, json_t *o, const ts_probe_seen *at, ts_gpixel *pixel)
{
	bool there;
	ts_gpixel held;
	json_t *g = json_object();
	ts_k_gpixel(pixel, &p->scene, &at->view, at->key, (i32)at->x, (i32)at->y);
	ts_probe_put(p, g, "position", ts_probe_v3(ts_load3(pixel->position)));
	ts_probe_put(p, g, "zn", ts_probe_bits(pixel->depth));
	ts_probe_put(p, g, "normal", ts_probe_v3_bits(ts_load3(pixel->normal)));
	ts_probe_put(p, g, "albedo", ts_probe_v3_bits(ts_load3(pixel->albedo)));
	ts_status status = ts_probe_fetch_pixel(p, TS_B_gbuffer_pixel, at->x, at->row, 1, &held, &there);
	if (status == TS_OK && there) ts_probe_put_record_check(p, g, TS_B_gbuffer_pixel, pixel, &held);
	ts_probe_put(p, o, "gbuffer", g);
	return status;
}

static ts_status put_held(ts_probe *p, json_t *o, const ts_probe_seen *at, const char *name, ts_buffer_id id,
                          const f32 light[3])
{
	bool there;
	f32 held[3];
	json_t *e = json_object();
	ts_probe_put(p, e, name, ts_probe_v3_bits(ts_load3(light)));
	ts_status status = ts_probe_fetch_pixel(p, id, at->x, at->row, 3, held, &there);
	if (status == TS_OK && there) ts_probe_put_check(p, e, id, light, held, 3);
	ts_probe_put(p, o, id == TS_B_indirect_specular ? "reflected" : "light", e);
	return status;
}

static ts_status put_gathered(ts_probe *p, json_t *o, const ts_probe_seen *at, const ts_probe_gathered *from)
{
	ts_status status = put_held(p, o, at, "irradiance", TS_B_indirect_irradiance, from->irradiance);
	if (status != TS_OK || !from->reflects) return status;
	return put_held(p, o, at, "radiance", TS_B_indirect_specular, from->specular);
}

ts_status ts_probe_put_indirect(ts_probe *p, const ts_probe_seen *at, ts_probe_irradiance *put_from, json_t *o,
                                ts_v3 *radiance)
{
	ts_gpixel pixel;
	ts_probe_gathered from = {.reflects = false};
	f32 sent[3];
	u8 srgb[3];
	if (put_gbuffer(p, o, at, &pixel) != TS_OK) return TS_ERROR;
	if (put_from(p, at, &pixel, o, &from) != TS_OK) return TS_ERROR;
	if (put_gathered(p, o, at, &from) != TS_OK) return TS_ERROR;
	ts_indirect_args args = {.pixels = &pixel,
	                         .irradiance = from.irradiance,
	                         .specular = from.reflects ? from.specular : NULL,
	                         .radiance = sent,
	                         .srgb = srgb,
	                         .exposure = TS_PARAM(&p->trace->params, image_exposure)};
	ts_k_image_indirect_item(&args, 0);
	*radiance = ts_load3(sent);
	return TS_OK;
}
