/* Boxes, balls and cube sizes of the reflectors. Frames 0 to this one are replayed, because the cube.hysteresis is the
 * one state between frames (METHODS 2). A few items a frame, so the C backend does it whatever the others run on. */
#include <stdlib.h>
#include "../../scene/view.h"
#include "../../kernels/points/cube_size.h"
#include "../stages.h"

static void replay(const ts_run *run, ts_cube_size_args args, u32 n)
{
	ts_params params = run->params;
	ts_view view;
	const ts_info *info = ts_run_info(run);
	args.view = &view;
	u32 first = args.fixed != 0 ? TS_PARAM(&run->params, frame) : 0;
	for (u32 frame = first; frame <= TS_PARAM(&run->params, frame); frame++) {
		TS_PARAM_SET(&params, frame, frame);
		args.frame = frame;
		ts_view_eye(&view, info, &params);
		ts_c_launch(TS_KERNEL_cube_size, &args, n, run->c.threads);
	}
}

static ts_status cube_size(ts_run *run)
{
	u32 n = ts_run_info(run)->n_reflectors;
	ts_sizes_cubes(&run->sizes, n);
	ts_face *cubes = ts_run_make(run, TS_B_cube_size_face);
	u32 *objects = ts_alloc(n, sizeof *objects, "reflectors");
	if (cubes == NULL || objects == NULL) {
		free(objects);
		return TS_ERROR;
	}
	memset(cubes, 0, n * sizeof *cubes);
	for (u32 i = 0; i < run->scene->n_objects; i++) {
		u32 reflector = run->scene->objects[i].reflector;
		if (reflector != TS_NONE) objects[reflector] = i;
	}
	ts_cube_size_args args = {
		.vertices = ts_frame_data(&run->frame, TS_B_scene_vertex),
		.objects = ts_frame_data(&run->frame, TS_B_scene_object),
		.reflector_objects = objects,
		.cubes = cubes,
		.n_max = ts_largest_face(&run->params),
		.hysteresis = TS_PARAM(&run->params, cube_hysteresis),
		.fixed = run->plan.offscreen.side != 0 ? run->plan.offscreen.side : TS_PARAM(&run->params, cube_px),
		.all = run->plan.offscreen.all || TS_PARAM(&run->params, lookup_bounces) > 1,
	};
	replay(run, args, n);
	free(objects);
	u64 offset = 0;
	for (u32 r = 0; r < n; r++) {
		cubes[r].offset = offset;
		offset += (u64)6 * cubes[r].n * cubes[r].n;
	}
	ts_run_count(run, "cube texels", (i64)offset);
	return TS_OK;
}

const ts_stage ts_stage_cube_size = {
	.name = "cube_size",
	.kind = "map",
	.paper = "EPR 3.5",
	.doc = "box, ball and cube size of every reflector",
	.run = cube_size,
	.looks_at = TS_BUFFERS(TS_B_scene_vertex, TS_B_scene_object, TS_B_scene_info),
	.makes = TS_BUFFERS(TS_B_cube_size_face),
};
