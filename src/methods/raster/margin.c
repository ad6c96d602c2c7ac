/* Margins of coverage and depths of triangles. */
#include "kernels/raster/margin.h"
#include "methods/raster/raster.h"

static const ts_launch of_eye =
	TS_LAUNCH(eye_margin, TS_WITH(view), TS_IN(depth_triangle, eye_depth_triangle), TS_MIN(margin, eye_margin));
static const ts_launch of_faces =
	TS_LAUNCH(cube_face_margin, TS_WITH(cubes), TS_IN(depth_triangle, cube_face_depth_triangle),
              TS_MIN(margin, cube_face_margin));
static const ts_launch of_depths =
	TS_LAUNCH(depth_map_margin, TS_WITH(views), TS_WITH(depths), TS_MIN(margin, depth_map_margin));

static ts_status eye_margin(ts_run *run)
{
	ts_margin_args args = {.scene = ts_run_scene(run), .samples = ts_eye_samples(&run->params)};
	return TS_RUN(run, &of_eye, &args, (u64)args.scene.n_triangles * args.samples);
}

static ts_status cube_face_margin(ts_run *run)
{
	ts_margin_args args = {.scene = ts_run_scene(run), .first_unit = run->first_unit, .n_units = run->n_units};
	return TS_RUN(run, &of_faces, &args, args.scene.n_triangles);
}

static ts_status depth_map_margin(ts_run *run)
{
	ts_margin_args args = {.scene = ts_run_scene(run)};
	ts_run_views(run, &args.first_unit, &args.n_units);
	return TS_RUN(run, &of_depths, &args, args.scene.n_triangles);
}

const ts_stage ts_stage_eye_margin = {
	.name = "eye.margin",
	.kind = "scatter",
	.margin_of = "eye",
	.paper = "EPR 4.1.3",
	.doc = "margins of the eye's coverage and depths",
	.run = eye_margin,
	.launches = TS_LAUNCHES(&of_eye),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_cube_face_margin = {
	.name = "cube_face.margin",
	.kind = "scatter",
	.margin_of = "cube_face",
	.paper = "EPR 4.2",
	.doc = "margins of the cube faces' coverage and depths",
	.run = cube_face_margin,
	.launches = TS_LAUNCHES(&of_faces),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_depth_map_margin = {
	.name = "depth_map.margin",
	.kind = "scatter",
	.margin_of = "depth_map",
	.paper = "iVIR 4",
	.doc = "margins of the depth maps' coverage and depths",
	.run = depth_map_margin,
	.launches = TS_LAUNCHES(&of_depths),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_cube_size_face),
};
