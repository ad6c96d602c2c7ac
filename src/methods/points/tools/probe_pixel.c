/* A pixel of the eye: in a picture with mirrors its light, or the mirror's reflection; the light that reaches it by
 * percentage-closer soft shadows. */
#include "kernels/points/pcss.h"
#include "methods/points/tools/probe.h"
#include "methods/raster/tools/probe.h"

static void put_record(ts_probe *p, json_t *o, u32 entry, const ts_pixel *pixel)
{
	json_t *record = json_object();
	ts_probe_put(p, record, "entry", ts_probe_int(entry));
	ts_probe_put(p, record, "reflector", ts_probe_int(pixel->reflector));
	ts_probe_put(p, record, "position", ts_probe_v3(ts_load3(pixel->position)));
	ts_probe_put(p, record, "normal", ts_probe_v3(ts_load3(pixel->normal)));
	ts_probe_put(p, record, "position_dx", ts_probe_v3(ts_load3(pixel->position_dx)));
	ts_probe_put(p, record, "position_dy", ts_probe_v3(ts_load3(pixel->position_dy)));
	ts_probe_put(p, record, "normal_dx", ts_probe_v3(ts_load3(pixel->normal_dx)));
	ts_probe_put(p, record, "normal_dy", ts_probe_v3(ts_load3(pixel->normal_dy)));
	ts_probe_put(p, o, "record", record);
}

/* Pixel `index` is reflective and has that entry of mirror_pixel.record. */
static ts_status put_mirror(ts_probe *p, json_t *o, u32 entry, u32 index, ts_probe_reflection *put, ts_v3 *total)
{
	ts_pixel pixel;
	if (ts_probe_fetch(p, TS_B_mirror_pixel_record, entry, 1, &pixel) != TS_OK) return TS_ERROR;
	if (pixel.index != index) {
		return ts_fail("%s: element %u is of pixel %u; mirror_pixel.offset names it for pixel %u",
		               p->trace->item[TS_B_mirror_pixel_record].path, (unsigned)entry, (unsigned)pixel.index,
		               (unsigned)index);
	}
	json_t *mirror = json_object();
	put_record(p, o, entry, &pixel);
	ts_status status = put(p, entry, mirror, total);
	ts_probe_put(p, o, "reflection", mirror);
	return status;
}

static ts_status put_light(ts_probe *p, const ts_probe_seen *at, ts_probe_reflection *put, json_t *o, ts_v3 *radiance)
{
	u32 offset[2], index = at->row * p->view.width + at->x;
	if (ts_probe_fetch(p, TS_B_mirror_pixel_offset, index, 2, offset) != TS_OK) return TS_ERROR;
	if (offset[1] != offset[0]) return put_mirror(p, o, offset[0], index, put, radiance);
	ts_probe_put_shading(p, at, NULL, NULL, o, radiance);
	return TS_OK;
}

static ts_status put_epr(ts_probe *p, const ts_probe_seen *at, json_t *o, ts_v3 *radiance)
{
	return put_light(p, at, ts_probe_mirror, o, radiance);
}

static ts_status put_mvr(ts_probe *p, const ts_probe_seen *at, json_t *o, ts_v3 *radiance)
{
	return put_light(p, at, ts_probe_mip, o, radiance);
}

static ts_status put_forward(ts_probe *p, const ts_probe_seen *at, json_t *o, ts_v3 *radiance)
{
	return put_light(p, at, ts_probe_colours, o, radiance);
}

static ts_status answer(ts_probe *p, const ts_probe_question *q, ts_probe_light *put, json_t *o)
{
	static const ts_buffer_id needed[] = {TS_B_eye_depth_triangle, TS_B_mirror_pixel_offset, TS_B_mirror_pixel_record,
	                                      TS_N_BUFFERS};
	return ts_probe_read_cubes(p) == TS_OK ? ts_probe_eye_pixel(p, q, needed, put, o) : TS_ERROR;
}

ts_status ts_probe_epr_pixel(ts_probe *p, const ts_probe_question *q, json_t *o) { return answer(p, q, put_epr, o); }
ts_status ts_probe_forward_pixel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	return answer(p, q, put_forward, o);
}
ts_status ts_probe_mvr_pixel(ts_probe *p, const ts_probe_question *q, json_t *o) { return answer(p, q, put_mvr, o); }

/* By percentage-closer soft shadows: one view per light, whose blockers set how widely its taps are spread. */

static ts_status put_taps(ts_probe *p, json_t *o, ts_probe_shadow *q, u32 light)
{
	const ts_lamp *lamp = &q->lamps.lamps[light];
	const ts_offscreen *view = &q->lamps.views[lamp->first];
	ts_pcss_args args = {.lamps = q->lamps.lamps, .near = TS_PARAM(&p->trace->params, pcss_near)};
	if (ts_probe_read_rows(p, q, view, 0, view->height) != TS_OK) return TS_ERROR;
	args.of = q->args;
	args.of.first_view = lamp->first;
	ts_shaded r = ts_k_shaded(&args.of, view, &q->at);
	q->lit[light] = ts_k_pcss(&args, view, &q->at);
	ts_probe_put(p, o, "view", ts_probe_lamp_view_name(&q->lamps, view, light));
	ts_probe_put(p, o, "depth", ts_probe_bits(r.z));
	ts_probe_put(p, o, "place", json_pack("[o,o]", ts_probe_real(r.place.x), ts_probe_real(r.place.y)));
	ts_probe_put(p, o, "bias", ts_probe_bits(r.bias));
	if (!(r.z >= r.view.near)) return TS_OK;
	f32 radius = ts_k_search_radius(&r, lamp->radius, args.near * r.z), depth = ts_k_blocker_depth(&r, radius);
	ts_probe_put(p, o, "search_radius", ts_probe_real(radius));
	if (!(depth > 0.0f)) return TS_OK;
	ts_probe_put(p, o, "blocker_depth", ts_probe_bits(depth));
	ts_probe_put(p, o, "filter_radius", ts_probe_real(ts_k_filter_radius(&r, lamp->radius, depth)));
	return TS_OK;
}

static ts_status put_shadowed(ts_probe *p, const ts_probe_seen *at, json_t *o, ts_v3 *radiance)
{
	return ts_probe_put_shadowed(p, at, TS_PROBE_TAPS, put_taps, o, radiance);
}

ts_status ts_probe_pcss_pixel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	static const ts_buffer_id needed[] = {TS_B_eye_depth_triangle, TS_B_depth_map_depth, TS_N_BUFFERS};
	return ts_probe_eye_pixel(p, q, needed, put_shadowed, o);
}
