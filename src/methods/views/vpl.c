/* Virtual point lights from the reflective shadow maps. */
#include "../../kernels/views/vpl.h"
#include "octree.h"

/* Texels that send light on; lights of each path; the lights. */
static const ts_launch lit = TS_LAUNCH(vpl_count, TS_BUT(paths), TS_BUT(lights));
static const ts_launch counted = TS_LAUNCH(vpl_path, TS_IN(offset, vpl_offset), TS_BUT(lights));
static const ts_launch written = TS_LAUNCH(vpl, TS_IN(offset, vpl_offset), TS_IN(paths, vpl_path));
static const ts_launch asked = TS_LAUNCH(vpl, TS_BUT(offset), TS_BUT(paths));

/* Leaf sides are those of both octrees. */
static ts_cast_args cast(const ts_run *run)
{
	const ts_root *root = ts_frame_data(&run->frame, TS_B_octree_root);
	return (ts_cast_args){
		.scene = ts_run_scene(run),
		.first_leaf = ts_octree_first(run, &ts_scene_octree, TS_PARAM(&run->params, octree_levels)),
		.leaf = root->side / (f32)(1 << TS_PARAM(&run->params, octree_levels)),
	};
}

static ts_vpl_args values(const ts_run *run)
{
	bool empty = ts_frame_n(&run->frame, TS_B_octree_node) == 0;
	return (ts_vpl_args){
		.cast = cast(run),
		.n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch),
		.random = TS_PARAM(&run->params, vpl_paths) != 0,
		.seed = TS_PARAM(&run->params, seed),
		.bounces = empty ? 1 : TS_PARAM(&run->params, vpl_bounces),
	};
}

ts_status ts_vpl_ask(const ts_run *run, ts_vpl_args *args)
{
	*args = values(run);
	return TS_ASK(run, &asked, args);
}

static ts_status find_lit(ts_run *run, ts_vpl_args *args)
{
	u64 n_lit;
	if (TS_RUN(run, &lit, args, args->n_patches) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, &lit, "offset", &n_lit) != TS_OK) return TS_ERROR;
	args->n_lit = (u32)n_lit;
	args->n = args->random && n_lit != 0 ? TS_PARAM(&run->params, vpl_paths) : args->n_lit;
	ts_run_set_size(run, TS_DIM_paths, args->n);
	return TS_OK;
}

static ts_status vpl(ts_run *run)
{
	u64 total;
	ts_vpl_args args = values(run);
	if (find_lit(run, &args) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &counted, &args, args.n) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, &counted, "paths", &total) != TS_OK) return TS_ERROR;
	ts_run_count(run, "paths of light", args.n);
	ts_run_count(run, "virtual point lights", (i64)total);
	return TS_RUN(run, &written, &args, args.n);
}

const ts_stage ts_stage_vpl = {
	.name = "vpl",
	.kind = "emit",
	.paper = "MegaViews 4.1",
	.doc = "virtual point lights where paths from the lamps end and are reflected, each of them a view",
	.run = vpl,
	.launches = TS_LAUNCHES(&lit, &counted, &written),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_offscreen_view, TS_B_octree_root, TS_B_octree_level),
};
