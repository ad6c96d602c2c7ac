/* Reflective shadow maps, and their texels as lights. */
#include "../kernels/shade.h"
#include "../scene/lamp.h"
#include "stages.h"

u32 ts_rsm_views(const ts_light *light) { return light->kind == TS_LIGHT_KIND_POINT ? 6 : 1; }

/* View k of a light. */
static void set_view(ts_offscreen *view, const ts_light *light, u32 k, u32 index, const ts_run *run)
{
	ts_face cube;
	ts_params params = run->params;
	params.map_px = params.rsm_px;
	if (light->kind == TS_LIGHT_KIND_POINT) {
		ts_lamp_cube(&cube, light, 0.0f, 0, 1, ts_run_info(run), &params);
		ts_offscreen_of_face(view, &cube, k, index);
	} else {
		ts_lamp_view(view, light, 0.0f, 0, 1, ts_run_info(run), &params);
		view->light = index;
	}
}

ts_status ts_stage_rsm_view(ts_run *run)
{
	const ts_light *lights = ts_frame_data(&run->frame, TS_B_lamp_light);
	u64 n_lights = ts_frame_n(&run->frame, TS_B_lamp_light), n = 0;
	for (u64 i = 0; i < n_lights; i++) n += ts_rsm_views(&lights[i]);
	ts_offscreen *view = ts_frame_make1(&run->frame, TS_B_offscreen_view, n);
	if (view == NULL) return TS_ERROR;
	u64 texels = (u64)run->params.rsm_px * run->params.rsm_px, offset = 0;
	for (u32 i = 0; i < n_lights; i++) {
		for (u32 k = 0; k < ts_rsm_views(&lights[i]); k++, view++, offset += texels) {
			set_view(view, &lights[i], k, i, run);
			view->offset = offset;
		}
	}
	return TS_OK;
}

static ts_rsm_args arguments(const ts_run *run)
{
	return (ts_rsm_args){
		.scene = ts_run_arrays(run),
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.depth_triangle = ts_frame_handle(&run->frame, TS_B_rsm_depth_triangle),
		.n_views = (u32)ts_frame_n(&run->frame, TS_B_offscreen_view),
	};
}

ts_status ts_stage_rsm(ts_run *run)
{
	u64 n_texels = ts_run_n_texels(run, 0, (u32)ts_frame_n(&run->frame, TS_B_offscreen_view));
	if (ts_frame_make1(&run->frame, TS_B_rsm_depth_triangle, n_texels) == NULL) return TS_ERROR;
	if (ts_run_fill(run, TS_B_rsm_depth_triangle, 0xff) != TS_OK) return TS_ERROR;
	ts_rsm_args args = arguments(run);
	if (ts_run_launch(run, TS_KERNEL_rsm, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 1);
	return TS_OK;
}

ts_status ts_stage_rsm_patch(ts_run *run)
{
	u64 n_texels = ts_frame_n(&run->frame, TS_B_rsm_depth_triangle);
	ts_rsm_args args = arguments(run);
	args.lamps = ts_frame_handle(&run->frame, TS_B_lamp_light);
	args.patches = ts_frame_make1(&run->frame, TS_B_rsm_patch, n_texels);
	if (args.patches == NULL) return TS_ERROR;
	return ts_run_launch(run, TS_KERNEL_rsm_patch, &args, n_texels);
}
