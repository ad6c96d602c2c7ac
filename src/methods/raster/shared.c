/* Runs of steps that several methods share. */
#include "methods/raster/pipelines.h"

const ts_step ts_frame_run[] = {
	{.stage = "eye.view"}, /* where the eye is */
	{.stage = "pose"},     /* where everything else is */
	{0},
};

const ts_step ts_soft_run[] = {
	{.run = ts_frame_run}, {.stage = "lamp"}, {.stage = "lamp.view"}, {.stage = "eye"}, {0},
};

const ts_step ts_omni_run[] = {
	{.run = ts_frame_run},  {.stage = "lamp.ball"}, {.stage = "lamp.cube"},
	{.stage = "offscreen"}, {.stage = "eye"},       {0},
};

const ts_step ts_resolve_run[] = {
	{.stage = "shadow_test", .each_batch = true},
	{.stage = "image.shadow"},
	{0},
};

const ts_step ts_rsm_run[] = {
	{.run = ts_frame_run},  {.stage = "lamp"},
	{.stage = "rsm.view"},  {.stage = "rsm"}, /* what each light sees */
	{.stage = "rsm.patch"}, {0},
};

const ts_step ts_gbuffer_run[] = {
	{.stage = "eye"},
	{.stage = "gbuffer"},
	{0},
};
