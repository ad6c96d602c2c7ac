/* MVR: level 0 of the batch's cubes by shading every texel; mip chains. */
#include "kernels/raster/texel_place.h"
#include "methods/raster/raster.h"

static const ts_launch shaded = TS_LAUNCH(illuminate, TS_ALL);
const ts_launch ts_mip_averaged = TS_LAUNCH(mip, TS_BUT(scene), TS_BUT(depth_triangle));

ts_status ts_mip_make(ts_run *run, ts_illuminate_args args)
{
	const ts_face *cubes = ts_frame_data(&run->frame, TS_B_cube_size_face);
	for (u32 r = run->first_unit; r < run->first_unit + run->n_units; r++) {
		u32 n = cubes[r].n;
		args.first_cube = r;
		for (args.level = 1; n != 0 && args.level < ts_k_mip_levels(n); args.level++) {
			u64 size = ts_k_mip_size(n, args.level);
			if (ts_launch_items(run, &ts_mip_averaged, &args, 6 * size * size) != TS_OK) return TS_ERROR;
		}
		args.mip += ts_k_mip_texels(n, TS_NONE) * 4;
	}
	return TS_OK;
}

static ts_status illuminate(ts_run *run)
{
	ts_illuminate_args args = {.scene = ts_run_scene(run), .first_cube = run->first_unit, .n_cubes = run->n_units};
	if (TS_RUN(run, &shaded, &args, ts_run_size(run, TS_DIM_texels)) != TS_OK) return TS_ERROR;
	if (ts_mip_make(run, args) != TS_OK) return TS_ERROR;
	const u64 *seen = ts_frame_data(&run->frame, TS_B_cube_face_depth_triangle);
	u64 n = ts_frame_n(&run->frame, TS_B_cube_face_depth_triangle);
	i64 n_shaded = 0;
	for (u64 i = 0; i < n; i++) n_shaded += seen[i] != TS_EMPTY;
	ts_run_count(run, "shading operations", n_shaded);
	return TS_OK;
}

const ts_stage ts_stage_illuminate = {
	.name = "illuminate",
	.kind = "map",
	.paper = "EPR 4.2",
	.doc = "MVR: deferred shading of every texel, and the mip chains",
	.run = illuminate,
	.launches = TS_LAUNCHES(&shaded, &ts_mip_averaged),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
