/* Checks of views from the middles of cubes before a stage runs on them. */
#include <inttypes.h>
#include "methods/views/tools/tools.h"

ts_status ts_check_colours(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n_cubes, n_views = load->sizes.n[TS_DIM_vpls];
	if (ts_check_elements(load, TS_B_cube_size_face, &n_cubes) == NULL || n_views == n_cubes) return TS_OK;
	return ts_refuse("%s: maps of %" PRIu64 " views; %" PRIu64 ", one a cube, would be right", load->item[id]->path,
	                 n_views, n_cubes);
}
