/* Runs of steps that several methods of many views share. */
#include "methods/views/pipelines.h"
#include "methods/views/views.h"

#define FUSED \
	{ \
		.stage = "view_map.fuse", .only_if = ts_gather_asks_fused \
	}

const ts_step ts_shared_views_run[] = {
	{.stage = "view_octree.voxel"},
	{.stage = "view_octree"}, /* of the views */
	{.stage = "view_octree.cone"},
	{.stage = "traverse", .only_traced = true},
	{.stage = "view_map"}, /* the traversal, and what it renders */
	{0},
};

const ts_step ts_shared_maps_run[] = {{.run = ts_shared_views_run}, FUSED, {0}};

const ts_step ts_own_maps_run[] = {
	{.stage = "view_octree.alone"}, {.stage = "traverse", .only_traced = true}, {.stage = "view_map"}, FUSED, {0},
};

const ts_step ts_all_maps_run[] = {
	{.stage = "view_octree.alone"},
	{.stage = "view_map.all"}, /* no traversal */
	FUSED,
	{0},
};

const ts_step ts_gather_run[] = {
	{.stage = "vpl_gather.pairs"}, /* the traversal again: which views may light which nodes */
	{.stage = "vpl_gather", .spares = ts_gather_asks_fused, .spared = TS_B_view_map_depth_node},
	{.stage = "bilateral"},
	{.stage = "image.indirect"},
	{0},
};
