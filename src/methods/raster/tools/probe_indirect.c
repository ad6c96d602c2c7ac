/* A pixel of indirect light: its place in the G-buffer, the light that arrives, and what is sent on. */
#include "../../../kernels/raster/indirect.h"
#include "probe.h"

static ts_status put_gbuffer(ts_probe *p, json_t *o, u32 x, u32 y, u64 key, ts_gpixel *pixel)
{
	bool there;
	ts_gpixel held;
	json_t *g = json_object();
	ts_camera_k view = ts_k_view(&p->view);
	ts_k_gpixel(pixel, &p->scene, &view, key, (i32)x, (i32)y);
	ts_probe_put(p, g, "position", ts_probe_v3(ts_load3(pixel->position)));
	ts_probe_put(p, g, "zn", ts_probe_bits(pixel->depth));
	ts_probe_put(p, g, "normal", ts_probe_v3_bits(ts_load3(pixel->normal)));
	ts_probe_put(p, g, "albedo", ts_probe_v3_bits(ts_load3(pixel->albedo)));
	ts_status status = ts_probe_fetch_pixel(p, TS_B_gbuffer_pixel, x, y, 1, &held, &there);
	if (status == TS_OK && there) ts_probe_put_record_check(p, g, TS_B_gbuffer_pixel, pixel, &held);
	ts_probe_put(p, o, "gbuffer", g);
	return status;
}

static ts_status put_irradiance(ts_probe *p, json_t *o, u32 x, u32 y, const f32 irradiance[3])
{
	bool there;
	f32 held[3];
	json_t *e = json_object();
	ts_probe_put(p, e, "irradiance", ts_probe_v3_bits(ts_load3(irradiance)));
	ts_status status = ts_probe_fetch_pixel(p, TS_B_indirect_irradiance, x, y, 3, held, &there);
	if (status == TS_OK && there) ts_probe_put_check(p, e, TS_B_indirect_irradiance, irradiance, held, 3);
	ts_probe_put(p, o, "light", e);
	return status;
}

ts_status ts_probe_put_indirect(ts_probe *p, const ts_probe_seen *at, ts_probe_irradiance *put_from, json_t *o,
                                ts_v3 *radiance)
{
	ts_gpixel pixel;
	f32 irradiance[3], sent[3];
	u8 srgb[3];
	if (put_gbuffer(p, o, at->x, at->y, at->key, &pixel) != TS_OK) return TS_ERROR;
	if (put_from(p, at, &pixel, o, irradiance) != TS_OK) return TS_ERROR;
	if (put_irradiance(p, o, at->x, at->y, irradiance) != TS_OK) return TS_ERROR;
	ts_indirect_args args = {.pixels = &pixel,
	                         .irradiance = irradiance,
	                         .radiance = sent,
	                         .srgb = srgb,
	                         .exposure = TS_PARAM(&p->trace->params, image_exposure)};
	ts_k_image_indirect_item(&args, 0);
	*radiance = ts_load3(sent);
	return TS_OK;
}
