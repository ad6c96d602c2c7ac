/* A piece of a triangle: how dense, kept or dropped. */
#include "kernels/points/cull.h"
#include "methods/points/points.h"
#include "methods/points/tools/probe.h"
#include "methods/stages.h"

ts_status ts_probe_piece(ts_probe *p, u64 index, json_t *o, bool *kept)
{
	const ts_params *params = &p->trace->params;
	ts_piece piece;
	ts_align frame;
	f32 scale;
	u32 keep, again;
	if (ts_probe_fetch(p, TS_B_split_piece, index, 1, &piece) != TS_OK ||
	    ts_probe_fetch(p, TS_B_split_density, index, 1, &scale) != TS_OK ||
	    ts_probe_fetch(p, TS_B_cull_keep, index, 1, &keep) != TS_OK ||
	    ts_probe_fetch(p, TS_B_align_frame, index, 1, &frame) != TS_OK)
		return TS_ERROR;
	ts_cull_args args = {.pieces = &piece,
	                     .scale = &scale,
	                     .keep = &again,
	                     .seed = TS_PARAM(params, seed),
	                     .unit = ts_cull_unit(params),
	                     .enabled = TS_PARAM(params, points_cull)};
	ts_k_cull_item(&args, 0);
	f32 pixels = ts_k_cull_pixels(&args, 0);
	*kept = keep != 0;
	ts_probe_put(p, o, "piece", ts_probe_int(index));
	ts_probe_put(p, o, "path", ts_probe_int(piece.path));
	ts_probe_put(p, o, "scale", ts_probe_bits(scale));
	ts_probe_put(p, o, "area", ts_probe_real(ts_k_area(ts_load3(piece.a), ts_load3(piece.b), ts_load3(piece.c))));
	ts_probe_put(p, o, "cull_pixels", ts_probe_bits(pixels));
	ts_probe_put(p, o, "cull_threshold", ts_probe_int((u64)ts_k_cull_threshold(pixels)));
	ts_probe_put(p, o, "cull_chance", ts_probe_int((u64)ts_k_cull_chance(&args, 0)));
	ts_probe_put(p, o, "cull",
	             json_string(TS_PARAM(params, points_cull) == 0 ? "off"
	                         : keep != 0                        ? "kept"
	                                                            : "dropped"));
	ts_probe_put(p, o, "frame_scale", ts_probe_bits(frame.s));
	ts_probe_put(p, o, "check",
	             json_string(again == keep ? "bits agree with cull.keep" : "bits differ from cull.keep"));
	return TS_OK;
}
