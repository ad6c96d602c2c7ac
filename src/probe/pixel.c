/* A pixel of the eye. */
#include <stdlib.h>
#include "parts.h"

static ts_status put_contest(ts_probe *p, json_t *o, u32 x, u32 y, u64 held)
{
	ts_offers offers = {.offer = NULL};
	ts_camera_k view = ts_k_view(&p->view);
	json_t *contest = json_object();
	ts_status status = ts_probe_contest(p, &view, TS_NONE, x, y, &offers);
	if (status == TS_OK) status = ts_probe_put_offers(p, contest, &offers, TS_B_eye_depth_triangle, held, false);
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

static ts_status put_mirror(ts_probe *p, json_t *o, u32 entry, u32 index, ts_v3 *total)
{
	ts_pixel pixel;
	if (ts_probe_fetch(p, TS_B_pixel_record, entry, 1, &pixel) != TS_OK) return TS_ERROR;
	if (pixel.index != index) {
		return ts_fail("%s: element %u is of pixel %u; pixel.offset names it for pixel %u",
		               p->trace->item[TS_B_pixel_record].path, (unsigned)entry, (unsigned)pixel.index, (unsigned)index);
	}
	json_t *record = json_object(), *mirror = json_object();
	ts_probe_put(p, record, "entry", ts_probe_int(entry));
	ts_probe_put(p, record, "reflector", ts_probe_int(pixel.reflector));
	ts_probe_put(p, record, "position", ts_probe_v3(ts_load3(pixel.position)));
	ts_probe_put(p, record, "normal", ts_probe_v3(ts_load3(pixel.normal)));
	ts_probe_put(p, record, "position_dx", ts_probe_v3(ts_load3(pixel.position_dx)));
	ts_probe_put(p, record, "position_dy", ts_probe_v3(ts_load3(pixel.position_dy)));
	ts_probe_put(p, record, "normal_dx", ts_probe_v3(ts_load3(pixel.normal_dx)));
	ts_probe_put(p, record, "normal_dy", ts_probe_v3(ts_load3(pixel.normal_dy)));
	ts_probe_put(p, o, "record", record);
	ts_status status = p->faces ? ts_probe_mip(p, entry, mirror, total) : ts_probe_mirror(p, entry, mirror, total);
	ts_probe_put(p, o, "reflection", mirror);
	return status;
}

static ts_status put_radiance(ts_probe *p, json_t *o, u32 x, u32 y, ts_v3 total)
{
	f32 computed[3], held[3];
	u8 srgb[3];
	bool there;
	json_t *result = json_object();
	ts_store3(computed, total);
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

/* Of what is no mirror. */
static ts_status put_light(ts_probe *p, json_t *o, u32 x, u32 y, u64 key, const ts_surface *surface, ts_v3 *total)
{
	if (p->gathers) return ts_probe_indirect(p, x, y, key, o, total);
	ts_camera_k view = ts_k_view(&p->view);
	ts_receiver at = ts_k_receiver(&p->scene, &view, key, (i32)x, (i32)y);
	if (p->has_lamps && ts_probe_shadow(p, x, y, &at, o) != TS_OK) return TS_ERROR;
	ts_v3 v = ts_normalize(ts_sub(ts_load3(p->view.eye), surface->p));
	ts_probe_put(p, o, "shading", ts_probe_shading(p, surface, v, total));
	return TS_OK;
}

static ts_status describe(ts_probe *p, json_t *o, u32 x, u32 y, u64 key, const u32 offset[2])
{
	ts_surface surface;
	ts_v3 total = ts_k_background();
	ts_status status = put_contest(p, o, x, y, key);
	bool mirror = offset[1] != offset[0];
	if (status == TS_OK && key != TS_EMPTY) status = put_surface(p, o, (u32)key, x, y, &surface);
	if (status == TS_OK && mirror) {
		status = put_mirror(p, o, offset[0], y * p->view.width + x, &total);
	} else if (status == TS_OK && key != TS_EMPTY) {
		status = put_light(p, o, x, y, key, &surface, &total);
	} else if (status == TS_OK) {
		ts_probe_put(p, o, "shading", json_string("nothing is here: background"));
	}
	return status == TS_OK ? put_radiance(p, o, x, y, total) : status;
}

static ts_status describe_surfels(ts_probe *p, json_t *o, u32 x, u32 y)
{
	ts_v3 total;
	if (ts_probe_surfels(p, x, y, o) != TS_OK || ts_probe_deferred(p, x, y, o, &total) != TS_OK) return TS_ERROR;
	return put_radiance(p, o, x, y, total);
}

static ts_status describe_triangles(ts_probe *p, json_t *o, u32 x, u32 y)
{
	u64 key;
	u32 offset[2] = {0, 0};
	bool there;
	if (ts_probe_fetch_pixel(p, TS_B_eye_depth_triangle, x, y, 1, &key, &there) != TS_OK) return TS_ERROR;
	if (!there) {
		return ts_fail("%s: pixel (%u, %u) is outside its crop", p->trace->item[TS_B_eye_depth_triangle].path,
		               (unsigned)x, (unsigned)y);
	}
	if (p->mirrors && ts_probe_fetch(p, TS_B_pixel_offset, (u64)y * p->view.width + x, 2, offset) != TS_OK)
		return TS_ERROR;
	return describe(p, o, x, y, key, offset);
}

/* What the description of a pixel begins with. */
static ts_status begin(ts_probe *p)
{
	static const ts_buffer_id mirrors[] = {TS_B_eye_depth_triangle, TS_B_pixel_offset, TS_B_pixel_record, TS_N_BUFFERS};
	static const ts_buffer_id shadows[] = {TS_B_eye_depth_triangle, TS_B_scatter_depth, TS_N_BUFFERS};
	static const ts_buffer_id indirect[] = {TS_B_eye_depth_triangle, TS_B_rsm_patch, TS_N_BUFFERS};
	static const ts_buffer_id particles[] = {TS_B_eye_depth_triangle, TS_B_vpl_light, TS_N_BUFFERS};
	if (p->surfels) return ts_probe_load_surfels(p);
	if (ts_probe_scene(p) != TS_OK) return TS_ERROR;
	if (p->gathers) return ts_probe_require(p, p->has_lamps ? indirect : particles);
	return ts_probe_require(p, p->has_lamps ? shadows : mirrors);
}

ts_status ts_probe_pixel(ts_probe *p, u32 x, u32 y, json_t **answer)
{
	*answer = NULL;
	if (begin(p) != TS_OK) return TS_ERROR;
	if (x >= p->view.width || y >= p->view.height) {
		return ts_fail("%s: no pixel (%u, %u); the eye has %u x %u", p->trace->dir, (unsigned)x, (unsigned)y,
		               (unsigned)p->view.width, (unsigned)p->view.height);
	}
	json_t *o = json_object();
	ts_probe_put(p, o, "pixel", ts_probe_pair(x, y));
	ts_probe_put(p, o, "method", json_string(p->trace->pipeline->name));
	ts_status status = p->surfels ? describe_surfels(p, o, x, y) : describe_triangles(p, o, x, y);
	return ts_probe_answer(p, o, status, answer);
}
