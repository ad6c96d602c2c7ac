/* Triangles of light, and the texels of reflective shadow maps that hold them. */
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
