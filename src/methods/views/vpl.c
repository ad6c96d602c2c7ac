/* Virtual point lights from the reflective shadow maps. */
#include "kernels/views/vpl.h"
#include "methods/views/octree.h"

/* Texels that reflect light; lights of each path; the lights; and those for paths with random beginnings. */
static const ts_launch lit = TS_LAUNCH(vpl_count, TS_BUT(paths), TS_BUT(lights));
static const ts_launch counted = TS_LAUNCH(vpl_path, TS_IN(offset, vpl_offset), TS_BUT(lights));
static const ts_launch written = TS_LAUNCH(vpl, TS_IN(offset, vpl_offset), TS_IN(paths, vpl_path));
static const ts_launch asked = TS_LAUNCH(vpl, TS_BUT(offset), TS_BUT(paths));
#define AT_RANDOM TS_BUT(patches), TS_BUT(offset), TS_WITH(areas), TS_WITH(lamps)
static const ts_launch counted_at_random = TS_LAUNCH(vpl_path, AT_RANDOM, TS_BUT(lights));
static const ts_launch written_at_random = TS_LAUNCH(vpl, AT_RANDOM, TS_IN(paths, vpl_path));
static const ts_launch asked_at_random = TS_LAUNCH(vpl, TS_BUT(offset), TS_BUT(paths), TS_WITH(areas), TS_WITH(lamps));
static const ts_launch measured = TS_LAUNCH(vpl_area, TS_BUT_SURFACES, TS_BUT(scene.objects));

bool ts_vpl_at_random(const ts_params *params) { return TS_PARAM(params, vpl_place) == TS_VPL_AT_RANDOM; }

/* Sides of leaves are the same in both octrees. */
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
		.n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_light),
		.n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch),
		.random = TS_PARAM(&run->params, vpl_paths) != 0,
		.seed = TS_PARAM(&run->params, seed),
		.bounces = empty ? 1 : TS_PARAM(&run->params, vpl_bounces),
	};
}

ts_status ts_vpl_ask(const ts_run *run, ts_vpl_args *args)
{
	*args = values(run);
	return TS_ASK(run, ts_vpl_at_random(&run->params) ? &asked_at_random : &asked, args);
}

static ts_status vpl_area(ts_run *run)
{
	u64 total;
	ts_vpl_area_args args = {.scene = ts_run_scene(run)};
	if (TS_RUN(run, &measured, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	return ts_launch_sum(run, &measured, "areas", &total);
}

static ts_status find_lit(ts_run *run, ts_vpl_args *args)
{
	u64 n_lit;
	if (TS_RUN(run, &lit, args, args->n_patches) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, &lit, "offset", &n_lit) != TS_OK) return TS_ERROR;
	bool nowhere = ts_vpl_at_random(&run->params) && ts_frame_n(&run->frame, TS_B_octree_node) == 0;
	args->n_lit = nowhere ? 0 : (u32)n_lit;
	args->n = args->random && args->n_lit != 0 ? TS_PARAM(&run->params, vpl_paths) : args->n_lit;
	ts_run_set_size(run, TS_DIM_paths, args->n);
	return TS_OK;
}

static ts_status vpl(ts_run *run)
{
	u64 total;
	ts_vpl_args args = values(run);
	bool at_random = ts_vpl_at_random(&run->params);
	const ts_launch *count = at_random ? &counted_at_random : &counted;
	const ts_launch *write = at_random ? &written_at_random : &written;
	if (find_lit(run, &args) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, count, &args, args.n) != TS_OK) return TS_ERROR;
	if (ts_launch_sum(run, count, "paths", &total) != TS_OK) return TS_ERROR;
	ts_run_count(run, "paths of light", args.n);
	ts_run_count(run, "virtual point lights", (i64)total);
	return TS_RUN(run, write, &args, args.n);
}

const ts_stage ts_stage_vpl_area = {
	.name = "vpl.area",
	.kind = "map",
	.paper = "MegaViews 4.1, figure 11",
	.doc = "areas of the triangles, for paths that begin at random",
	.run = vpl_area,
	.launches = TS_LAUNCHES(&measured),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_vpl = {
	.name = "vpl",
	.kind = "emit",
	.paper = "MegaViews 4.1",
	.doc = "virtual point lights where paths from the lamps are reflected; each is also a view",
	.run = vpl,
	.launches = TS_LAUNCHES(&lit, &counted, &written, &counted_at_random, &written_at_random),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_offscreen_view, TS_B_octree_root, TS_B_octree_level),
};
