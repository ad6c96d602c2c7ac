/* Virtual point lights from the reflective shadow maps. */
#include "stages.h"

ts_status ts_stage_vpl(ts_run *run)
{
	u64 n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch), n_lit;
	ts_vpl_args args = {
		.patches = ts_frame_handle(&run->frame, TS_B_rsm_patch),
		.root = ts_frame_handle(&run->frame, TS_B_root_cube),
		.offset = ts_frame_make1(&run->frame, TS_B_vpl_offset, n_patches + 1),
		.n_patches = n_patches,
		.random = run->params.vpls != 0,
		.seed = run->params.seed,
		.levels = run->params.levels,
	};
	if (args.offset == NULL || ts_run_launch(run, TS_KERNEL_vpl_count, &args, n_patches) != TS_OK) return TS_ERROR;
	if (ts_run_scan(run, TS_B_vpl_offset, "virtual point lights", &n_lit) != TS_OK) return TS_ERROR;
	args.n_lit = (u32)n_lit;
	args.n = args.random && n_lit != 0 ? run->params.vpls : args.n_lit;
	args.lights = ts_frame_make1(&run->frame, TS_B_vpl_light, args.n);
	if (args.lights == NULL) return TS_ERROR;
	ts_run_count(run, "virtual point lights", args.n);
	return ts_run_launch(run, TS_KERNEL_vpl, &args, args.n);
}
