/* Voxels that triangles touch: future leaves of the scene's octree. */
#include "methods/views/octree.h"

static const ts_launch marked =
	TS_LAUNCH(voxel, TS_WITH(mask), TS_BUT(bits), TS_BUT(before), TS_BUT(offset), TS_BUT_LIT);

ts_voxel_args ts_voxel_values(const ts_run *run)
{
	return (ts_voxel_args){
		.scene = ts_run_scene(run),
		.levels = TS_PARAM(&run->params, octree_levels),
	};
}

static ts_status voxel(ts_run *run)
{
	ts_voxel_args args = ts_voxel_values(run);
	if (TS_RUN(run, &marked, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", 1);
	return ts_octree_ids(run, &ts_scene_octree);
}

const ts_stage ts_stage_voxel = {
	.name = "voxel",
	.kind = "scatter",
	.paper = "MegaViews 4.1",
	.doc = "voxels that triangles touch, at all levels",
	.run = voxel,
	.launches = TS_LAUNCHES(&marked, &ts_scene_octree.raised, &ts_scene_octree.counted),
};
