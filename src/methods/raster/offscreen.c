/* Cubes as off-screen views, and which off-screen views may see a triangle. */
#include "kernels/raster/offscreen.h"
#include "methods/stages.h"

static const ts_launch launch = TS_LAUNCH(offscreen_visibility, TS_BUT_SURFACES);

void ts_offscreen_of_face(ts_offscreen *view, const ts_face *cube, u32 face, u32 light)
{
	ts_camera_k from = ts_k_cube_view(cube, face);
	memset(view, 0, sizeof *view);
	ts_store3(view->eye, from.eye);
	ts_store3(view->right, from.right);
	ts_store3(view->up, from.up);
	ts_store3(view->back, from.back);
	view->focal = from.focal;
	view->near = from.near;
	view->width = view->height = cube->n;
	view->reach[0] = view->reach[1] = 1.0f;
	view->offset = cube->offset + (u64)face * cube->n * cube->n;
	view->object = cube->object;
	view->light = light;
}

/* Six per cube: they are few, and the host makes them. */
static ts_status offscreen(ts_run *run)
{
	const ts_face *cubes = ts_frame_data(&run->frame, TS_B_cube_size_face);
	u32 n = (u32)ts_run_size(run, TS_DIM_cubes), light = ts_run_has(run, TS_B_lamp_light) ? 0 : TS_NONE;
	ts_run_set_size(run, TS_DIM_views, (u64)6 * n);
	ts_offscreen *views = ts_run_make(run, TS_B_offscreen_view);
	if (views == NULL) return TS_ERROR;
	for (u32 v = 0; v < 6 * n; v++) ts_offscreen_of_face(&views[v], &cubes[v / 6], v % 6, light);
	return TS_OK;
}

static ts_status offscreen_visibility(ts_run *run)
{
	u64 n = ts_run_size(run, TS_DIM_triangles);
	ts_offscreen_args args = {
		.scene.n_triangles = (u32)n,
		.n_views = (u32)ts_run_size(run, TS_DIM_views),
		.n_words = (u32)ts_run_size(run, TS_DIM_view_words),
		.vertex_mode = TS_PARAM(&run->params, visibility_test) == TS_VISIBILITY_VERTEX,
	};
	if (TS_RUN(run, &launch, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "triangles processed", (i64)n);
	return TS_OK;
}

const ts_stage ts_stage_offscreen = {
	.name = "offscreen",
	.kind = "map",
	.paper = "iVIR 5",
	.doc = "six off-screen views per cube",
	.run = offscreen,
	.looks_at = TS_BUFFERS(TS_B_cube_size_face, TS_B_lamp_light),
	.makes = TS_BUFFERS(TS_B_offscreen_view),
};

const ts_stage ts_stage_offscreen_visibility = {
	.name = "offscreen.visibility",
	.kind = "map",
	.paper = "iVIR 3.1",
	.doc = "visibility of triangles: one bit per triangle and off-screen view",
	.run = offscreen_visibility,
	.launches = TS_LAUNCHES(&launch),
};
