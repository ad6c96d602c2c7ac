/* A picture of one rendered view (MegaViews, figure 9). */
#include <stdio.h>
#include "kernels/base/srgb.h"
#include "kernels/views/paraboloid.h"
#include "methods/raster/tools/tools.h"
#include "methods/views/tools/tools.h"

/* The front and the back of the view behind the largest cube, one disc each. */
static ts_status take_view(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	u32 view, n = run->plan.views.px;
	if (!ts_picture_largest_cube(run, &view)) return TS_OK;
	ts_stage_picture *p = ts_stage_pictures_add(pictures, "view", 2 * n, n, false);
	if (p == NULL) return TS_ERROR;
	const f32 *colours = (const f32 *)ts_frame_data(&run->frame, id) + (u64)view * (2 * n * n) * 3;
	for (u32 i = 0; i < 2 * n * n; i++) {
		u32 column = i / (n * n) * n + i % n, row = i / n % n;
		u8 *rgb = p->rgb + 3 * ((u64)row * 2 * n + column);
		for (u32 c = 0; c < 3 && ts_k_paraboloid_is_used(i, n); c++) rgb[c] = (u8)ts_srgb_byte(colours[3 * i + c]);
	}
	snprintf(p->caption, sizeof p->caption,
	         "map of cube %u's view, %u x %u texels each: the half along +x, that along -x", (unsigned)view,
	         (unsigned)n, (unsigned)n);
	return TS_OK;
}

const ts_stage_picture_rule ts_views_pictures[] = {
	{TS_B_view_map_colour, take_view},
	{.take = NULL},
};
