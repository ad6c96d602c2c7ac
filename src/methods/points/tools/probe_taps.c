/* The light that reaches a pixel by percentage-closer soft shadows: one view per light, whose blockers set how widely
 * its taps are spread. */
#include "kernels/points/pcss.h"
#include "methods/points/tools/probe.h"
#include "methods/raster/tools/probe.h"

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
