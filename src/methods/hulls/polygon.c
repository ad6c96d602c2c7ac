/* Lamps as triangles of light. */
#include "kernels/hulls/polygon.h"
#include "methods/stages.h"
#include "scene/view.h"

static const ts_launch launch = TS_LAUNCH(polygon, TS_ALL);

#define AWAY 1024.0f /* of half the scene's diagonal; across the scene a sun's direction is the same within 2^-9 */

static ts_status polygon(ts_run *run)
{
	ts_space box = ts_view_box(ts_run_info(run));
	ts_polygon_args args = {.middle = box.middle, .away = ts_length(box.half) * AWAY};
	return TS_RUN(run, &launch, &args, ts_run_size(run, TS_DIM_lamps) * TS_LAMP_TRIANGLES);
}

const ts_stage ts_stage_polygon = {
	.name = "polygon",
	.kind = "map",
	.paper = "SSAGH 3",
	.doc = "the lamps as triangles of light",
	.run = polygon,
	.launches = TS_LAUNCHES(&launch),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
