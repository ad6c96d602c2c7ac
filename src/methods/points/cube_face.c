/* MVR: draws every triangle into the faces of the batch's cubes. */
#include "kernels/raster/cube_face.h"
#include "methods/stages.h"

static const ts_launch launch = TS_LAUNCH(cube_face, TS_ALL);

static ts_status cube_face(ts_run *run)
{
	ts_cube_face_args args = {.scene = ts_run_scene(run), .first_cube = run->first_unit, .n_cubes = run->n_units};
	if (TS_RUN(run, &launch, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", run->n_units);
	ts_run_count(run, "triangles processed", (i64)args.scene.n_triangles * run->n_units);
	return TS_OK;
}

const ts_stage ts_stage_cube_face = {
	.name = "cube_face",
	.kind = "scatter",
	.paper = "EPR 4.2",
	.doc = "MVR: standard rasterization into the six cube faces of each reflector",
	.run = cube_face,
	.launches = TS_LAUNCHES(&launch),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
