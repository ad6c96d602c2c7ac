/* Cubes as off-screen views, and which off-screen views may see a triangle. */
#include "stages.h"

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

/* Six a cube: they are a few, and the host makes them. */
ts_status ts_stage_offscreen(ts_run *run)
{
	const ts_face *cubes = ts_frame_data(&run->frame, TS_B_resize_face);
	const ts_buffer *lights = &run->frame.buffer[TS_B_lamp_light];
	u32 n = ts_run_n_cubes(run), light = lights->made && lights->n > 0 ? 0 : TS_NONE;
	ts_offscreen *views = ts_frame_make1(&run->frame, TS_B_offscreen_view, (u64)6 * n);
	if (views == NULL) return TS_ERROR;
	for (u32 v = 0; v < 6 * n; v++) ts_offscreen_of_face(&views[v], &cubes[v / 6], v % 6, light);
	return TS_OK;
}

ts_status ts_stage_offscreen_visibility(ts_run *run)
{
	u64 n = run->scene->n_triangles;
	u32 n_views = (u32)ts_frame_n(&run->frame, TS_B_offscreen_view), n_words = (n_views + 63) / 64;
	ts_offscreen_args args = {
		.scene = ts_run_arrays(run),
		.views = ts_frame_handle(&run->frame, TS_B_offscreen_view),
		.bits = ts_frame_make2(&run->frame, TS_B_visibility_bits, n, n_words),
		.n_views = n_views,
		.n_words = n_words,
		.vertex_mode = run->params.visibility == TS_VISIBILITY_VERTEX,
	};
	if (args.bits == NULL) return TS_ERROR;
	if (ts_run_launch(run, TS_KERNEL_offscreen_visibility, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "triangles processed", (i64)n);
	return TS_OK;
}
