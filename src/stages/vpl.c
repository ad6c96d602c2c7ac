/* Virtual point lights from the reflective shadow maps. */
#include "octree.h"

/* Leaf sides are those of both octrees. */
static ts_cast_args scene_of(const ts_run *run)
{
	const ts_octree *octree = &ts_scene_octree;
	const ts_root *root = ts_frame_data(&run->frame, TS_B_root_cube);
	return (ts_cast_args){
		.scene = ts_run_arrays(run),
		.nodes = ts_frame_handle(&run->frame, octree->node),
		.offset = ts_frame_handle(&run->frame, octree->offset),
		.triangles = ts_frame_handle(&run->frame, octree->entries),
		.first_leaf = ts_octree_first(run, octree, run->params.levels),
		.leaf = root->side / (f32)(1 << run->params.levels),
	};
}

/* Texels that send light on. */
static ts_status find_lit(ts_run *run, ts_vpl_args *args)
{
	u64 n_lit;
	args->offset = ts_frame_make1(&run->frame, TS_B_vpl_offset, args->n_patches + 1);
	if (args->offset == NULL || ts_run_launch(run, TS_KERNEL_vpl_count, args, args->n_patches) != TS_OK) return TS_ERROR;
	if (ts_run_scan(run, TS_B_vpl_offset, &n_lit) != TS_OK) return TS_ERROR;
	args->n_lit = (u32)n_lit;
	args->n = args->random && n_lit != 0 ? run->params.vpls : args->n_lit;
	return TS_OK;
}

ts_vpl_args ts_vpl_arguments(const ts_run *run)
{
	bool empty = ts_frame_n(&run->frame, ts_scene_octree.node) == 0;
	return (ts_vpl_args){
		.cast = scene_of(run),
		.patches = ts_frame_handle(&run->frame, TS_B_rsm_patch),
		.n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch),
		.random = run->params.vpls != 0,
		.seed = run->params.seed,
		.bounces = empty ? 1 : run->params.vpl_bounces,
	};
}

ts_status ts_stage_vpl(ts_run *run)
{
	u64 total;
	ts_vpl_args args = ts_vpl_arguments(run);
	if (find_lit(run, &args) != TS_OK) return TS_ERROR;
	args.paths = ts_frame_make1(&run->frame, TS_B_vpl_path, (u64)args.n + 1);
	if (args.paths == NULL || ts_run_launch(run, TS_KERNEL_vpl_path, &args, args.n) != TS_OK) return TS_ERROR;
	if (ts_run_scan(run, TS_B_vpl_path, &total) != TS_OK) return TS_ERROR;
	args.lights = ts_frame_make1(&run->frame, TS_B_vpl_light, total);
	if (args.lights == NULL) return TS_ERROR;
	ts_run_count(run, "paths of light", args.n);
	ts_run_count(run, "virtual point lights", (i64)total);
	return ts_run_launch(run, TS_KERNEL_vpl, &args, args.n);
}
