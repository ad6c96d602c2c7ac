/* Reflective shadow maps, and their texels as lights. */
#include "kernels/raster/rsm.h"
#include "methods/stages.h"

static const ts_launch rasterized = TS_LAUNCH(rsm, TS_ALL);
static const ts_launch lit =
	TS_LAUNCH(rsm_patch, TS_IN(depth_triangle, rsm_depth_triangle), TS_WITH(lamps), TS_WITH(patches));

static ts_rsm_args values(const ts_run *run)
{
	return (ts_rsm_args){.scene = ts_run_scene(run), .n_views = (u32)ts_run_size(run, TS_DIM_views)};
}

static ts_status rsm(ts_run *run)
{
	ts_rsm_args args = values(run);
	if (TS_RUN(run, &rasterized, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 1);
	return TS_OK;
}

static ts_status rsm_patch(ts_run *run)
{
	ts_rsm_args args = values(run);
	return TS_RUN(run, &lit, &args, ts_run_size(run, TS_DIM_texels));
}

const ts_stage ts_stage_rsm_view = {
	.name = "rsm.view",
	.kind = "map",
	.paper = "SSAGH 5",
	.doc = "a reflective shadow map for each light, six for a point light",
	.run = ts_light_views_make,
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_lamp_light),
	.makes = TS_BUFFERS(TS_B_offscreen_view),
};

const ts_stage ts_stage_rsm = {
	.name = "rsm",
	.kind = "scatter",
	.paper = "SSAGH 5",
	.doc = "standard rasterization into every reflective shadow map",
	.run = rsm,
	.launches = TS_LAUNCHES(&rasterized),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_rsm_patch = {
	.name = "rsm.patch",
	.kind = "map",
	.paper = "SSAGH 5",
	.doc = "the triangle of light of each texel of the reflective shadow maps",
	.run = rsm_patch,
	.launches = TS_LAUNCHES(&lit),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
