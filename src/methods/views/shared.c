/* Runs of steps that several methods of many views share. */
#include "pipelines.h"

const ts_step ts_shared_maps_run[] = {
	{.stage = "view_voxel"}, {.stage = "view_octree"}, /* of the views */
	{.stage = "view_cone"},  {.stage = "traverse", .only_traced = true},
	{.stage = "map"}, /* the traversal, and what it renders */
	{.stage = "fuse"},       {0},
};

const ts_step ts_own_maps_run[] = {
	{.stage = "view_alone"}, {.stage = "traverse", .only_traced = true}, {.stage = "map"}, {.stage = "fuse"}, {0},
};

const ts_step ts_all_maps_run[] = {
	{.stage = "view_alone"},
	{.stage = "map_all"}, /* no traversal */
	{.stage = "fuse"},
	{0},
};

const ts_step ts_gather_run[] = {
	{.stage = "vpl_pairs"}, /* the traversal again: which views may light what */
	{.stage = "vpl_gather"}, {.stage = "bilateral"}, {.stage = "indirect_image"}, {0},
};
