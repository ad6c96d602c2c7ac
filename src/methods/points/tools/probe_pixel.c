/* A pixel of the eye in a picture with mirrors: its light, or the mirror's reflection. */
#include "methods/points/tools/probe.h"

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
