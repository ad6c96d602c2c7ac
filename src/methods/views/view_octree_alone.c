/* Views without a hierarchy. */
#include "kernels/views/view_octree_alone.h"
#include "methods/stages.h"

static const ts_launch launch = TS_LAUNCH(view_octree_alone, TS_ALL);

static ts_status view_octree_alone(ts_run *run)
{
	u64 n = ts_run_size(run, TS_DIM_vpls);
	u32 *before = ts_run_make(run, TS_B_view_octree_level);
	ts_view_octree_alone_args args;
	ts_run_set_size(run, TS_DIM_view_nodes, n);
	if (before == NULL) return TS_ERROR;
	for (u32 level = 0; level < TS_PARAM(&run->params, octree_levels) + 2; level++)
		before[level] = level > 0 ? (u32)n : 0;
	return TS_RUN(run, &launch, &args, n);
}

const ts_stage ts_stage_view_octree_alone = {
	.name = "view_octree.alone",
	.kind = "map",
	.paper = "MegaViews 4.1",
	.doc = "ManyLoDs: every view by itself, as a root that is a leaf",
	.run = view_octree_alone,
	.launches = TS_LAUNCHES(&launch),
	.makes = TS_BUFFERS(TS_B_view_octree_level),
};
