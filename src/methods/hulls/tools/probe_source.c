/* Triangles of light that a trace gathers from: texels of reflective shadow maps, or lamps. */
#include <inttypes.h>
#include "kernels/hulls/polygon.h"
#include "methods/hulls/tools/tools.h"

const ts_buffer_id *ts_probe_source_needed(const ts_probe *p)
{
	static const ts_buffer_id texels[] = {TS_B_eye_depth_triangle, TS_B_rsm_patch, TS_N_BUFFERS};
	static const ts_buffer_id lamps[] = {TS_B_eye_depth_triangle, TS_B_lamp_light, TS_B_lamp_shape, TS_B_polygon_patch,
	                                     TS_N_BUFFERS};
	return ts_probe_makes(p, TS_B_rsm_patch) ? texels : lamps;
}

static ts_status read_lamps(ts_probe *p, ts_direct_args *source)
{
	u64 n = ts_probe_n(p, TS_B_lamp_light), n_shapes = ts_probe_n(p, TS_B_lamp_shape);
	source->lamps = ts_probe_whole(p, TS_B_lamp_light);
	source->shapes = source->lamps != NULL ? ts_probe_whole(p, TS_B_lamp_shape) : NULL;
	if (source->shapes == NULL) return TS_ERROR;
	if (n >= TS_NONE || n_shapes != n || source->n_patches != n * TS_LAMP_TRIANGLES) {
		return ts_fail("%s: %" PRIu64 " lamps, %" PRIu64 " shapes and %" PRIu64 " triangles of light; of each lamp one "
		               "shape and %u triangles would be right",
		               p->trace->dir, n, n_shapes, source->n_patches, TS_LAMP_TRIANGLES);
	}
	source->n_lamps = (u32)n;
	return TS_OK;
}

ts_status ts_probe_read_source(ts_probe *p, ts_direct_args *source)
{
	bool of_texels = ts_probe_makes(p, TS_B_rsm_patch);
	ts_buffer_id id = of_texels ? TS_B_rsm_patch : TS_B_polygon_patch;
	*source = (ts_direct_args){.patches = ts_probe_whole(p, id), .n_patches = ts_probe_n(p, id)};
	if (source->patches == NULL) return TS_ERROR;
	return of_texels ? TS_OK : read_lamps(p, source);
}
