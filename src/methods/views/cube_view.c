/* Views from the middles of the reflectors' cubes, and their maps as mip chains. */
#include "kernels/views/cube_view.h"
#include "methods/raster/raster.h"
#include "methods/views/views.h"

static const ts_launch placed = TS_LAUNCH(cube_view, TS_ALL);
static const ts_launch copied = TS_LAUNCH(cube_view_mip, TS_BUT(to.scene), TS_BUT(to.depth_triangle));

static ts_status cube_view(ts_run *run)
{
	ts_cube_view_args args;
	u32 n = ts_run_info(run)->n_reflectors;
	ts_run_set_size(run, TS_DIM_vpls, n);
	return TS_RUN(run, &placed, &args, n);
}

static ts_status cube_view_mip(ts_run *run)
{
	ts_cube_view_mip_args args = {
		.to = {.first_cube = run->first_unit, .n_cubes = run->n_units},
		.n = run->plan.views.px,
	};
	if (TS_RUN(run, &copied, &args, ts_run_size(run, TS_DIM_texels)) != TS_OK) return TS_ERROR;
	return ts_mip_make(run, args.to);
}

const ts_stage ts_stage_cube_view = {
	.name = "cube_view",
	.kind = "map",
	.paper = "MegaViews 6",
	.doc = "a view to all sides from the middle of each reflector's cube",
	.run = cube_view,
	.launches = TS_LAUNCHES(&placed),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_cube_view_mip = {
	.name = "cube_view.mip",
	.kind = "map",
	.paper = "MegaViews 6",
	.doc = "coloured maps of the cubes' views as mip chains of cubes",
	.run = cube_view_mip,
	.launches = TS_LAUNCHES(&copied, &ts_mip_averaged),
};
