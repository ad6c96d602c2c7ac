/* Runs of steps that several methods share. */
#include "pipelines.h"

const ts_step ts_frame_run[] = {
	{.stage = "view"}, /* where the eye is */
	{.stage = "pose"}, /* where everything else is */
	{0},
};

const ts_step ts_soft_run[] = {
	{.run = ts_frame_run}, {.stage = "lamp"}, {.stage = "lamp_view"}, {.stage = "eye"}, {0},
};

const ts_step ts_omni_run[] = {
	{.run = ts_frame_run},  {.stage = "lamp_ball"}, {.stage = "lamp_cube"},
	{.stage = "offscreen"}, {.stage = "eye"},       {0},
};

const ts_step ts_resolve_run[] = {
	{.stage = "resolve", .each_batch = true},
	{.stage = "shadow_image"},
	{0},
};

const ts_step ts_rsm_run[] = {
	{.run = ts_frame_run},  {.stage = "lamp"},
	{.stage = "rsm_view"},  {.stage = "rsm"}, /* what each light sees */
	{.stage = "rsm_patch"}, {0},
};

const ts_step ts_gbuffer_run[] = {
	{.stage = "eye"},
	{.stage = "gbuffer"},
	{0},
};
