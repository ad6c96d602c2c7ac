/* Views without a hierarchy. */
#include "stages.h"

ts_status ts_stage_view_alone(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_vpl_light), n_ends = run->params.levels + 2;
	u32 *before = ts_frame_make1(&run->frame, TS_B_view_octree_level, n_ends);
	ts_view_alone_args args = {
		.lights = ts_frame_handle(&run->frame, TS_B_vpl_light),
		.nodes = ts_frame_make1(&run->frame, TS_B_view_octree_node, n),
		.cones = ts_frame_make1(&run->frame, TS_B_view_cone_node, n),
		.views = ts_frame_make1(&run->frame, TS_B_view_octree_view, n),
		.leaves = ts_frame_make1(&run->frame, TS_B_view_octree_leaf, n),
	};
	bool made = before != NULL && args.nodes != NULL && args.cones != NULL && args.views != NULL && args.leaves != NULL;
	if (!made) return TS_ERROR;
	for (u64 level = 0; level < n_ends; level++) before[level] = level > 0 ? (u32)n : 0;
	return ts_run_launch(run, TS_KERNEL_view_alone, &args, n);
}
