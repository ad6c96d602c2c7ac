/* Runs of steps that several methods share. */
#include "../pipelines.h"

const ts_step ts_frame_run[] = {
	{.stage = "view"},           /* where the eye is */
	{.stage = "pose"},           /* where everything else is */
	{0},
};

const ts_step ts_soft_run[] = {
	{.run = ts_frame_run},
	{.stage = "lamp"},
	{.stage = "lamp_view"},
	{.stage = "eye"},
	{0},
};

const ts_step ts_omni_run[] = {
	{.run = ts_frame_run},
	{.stage = "lamp_ball"},
	{.stage = "lamp_cube"},
	{.stage = "offscreen"},
	{.stage = "eye"},
	{0},
};

const ts_step ts_resolve_run[] = {
	{.stage = "resolve", .each_batch = true},
	{.stage = "shadow_image"},
	{0},
};

const ts_step ts_rsm_run[] = {
	{.run = ts_frame_run},
	{.stage = "lamp"},
	{.stage = "rsm_view"},
	{.stage = "rsm"},            /* what each light sees */
	{.stage = "rsm_patch"},
	{0},
};

const ts_step ts_gbuffer_run[] = {
	{.stage = "eye"},
	{.stage = "gbuffer"},
	{0},
};

const ts_step ts_shared_maps_run[] = {
	{.stage = "view_voxel"},
	{.stage = "view_octree"},    /* of the views */
	{.stage = "view_cone"},
	{.stage = "traverse", .only_traced = true},
	{.stage = "map"},            /* the traversal, and what it renders */
	{.stage = "fuse"},
	{0},
};

const ts_step ts_own_maps_run[] = {
	{.stage = "view_alone"},
	{.stage = "traverse", .only_traced = true},
	{.stage = "map"},
	{.stage = "fuse"},
	{0},
};

const ts_step ts_all_maps_run[] = {
	{.stage = "view_alone"},
	{.stage = "map_all"},        /* no traversal */
	{.stage = "fuse"},
	{0},
};

const ts_step ts_gather_run[] = {
	{.stage = "vpl_pairs"},      /* the traversal again: which views may light what */
	{.stage = "vpl_gather"},
	{.stage = "bilateral"},
	{.stage = "indirect_image"},
	{0},
};
