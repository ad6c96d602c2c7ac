/* The cube that both octrees divide. */
#include "kernels/views/octree_root.h"
#include "methods/stages.h"

static const ts_launch extent = TS_LAUNCH(octree_root_least, TS_BUT(root));
static const ts_launch cube = TS_LAUNCH(octree_root, TS_IN(least, octree_root_least), TS_BUT(vertices));

static ts_status octree_root(ts_run *run)
{
	ts_octree_root_args args;
	if (TS_RUN(run, &extent, &args, ts_run_size(run, TS_DIM_vertices)) != TS_OK) return TS_ERROR;
	return TS_RUN(run, &cube, &args, 1);
}

const ts_stage ts_stage_octree_root = {
	.name = "octree.root",
	.kind = "map",
	.paper = "MegaViews 3.1",
	.doc = "the cube around all vertices, the root of both octrees",
	.run = octree_root,
	.launches = TS_LAUNCHES(&extent, &cube),
};
