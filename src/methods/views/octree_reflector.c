/* The reflectors that nodes of the scene's octree belong to. */
#include "kernels/views/octree_reflector.h"
#include "methods/views/octree.h"

static const ts_launch of_leaves = TS_LAUNCH(leaf_reflector, TS_BUT_SURFACES, TS_BUT(scene.materials));
static const ts_launch of_nodes = TS_LAUNCH(inner_reflector, TS_BUT(scene), TS_BUT(offset), TS_BUT(triangles));

static ts_status octree_reflector(ts_run *run)
{
	ts_octree_reflector_args args = {.scene = ts_run_scene(run)};
	if (TS_FILL(run, &of_leaves, &args) != TS_OK) return TS_ERROR;
	return ts_octree_rise(run, &of_leaves, &of_nodes, &args, &args.first);
}

const ts_stage ts_stage_octree_reflector = {
	.name = "octree.reflector",
	.kind = "map",
	.paper = "EPR 4.1.3",
	.doc = "the reflector to which each node belongs",
	.run = octree_reflector,
	.launches = TS_LAUNCHES(&of_leaves, &of_nodes),
	.looks_at = TS_BUFFERS(TS_B_octree_level),
};
