/* Glowing particles as virtual point lights. */
#include "../scene/view.h"
#include "stages.h"

ts_status ts_stage_particle(ts_run *run)
{
	const ts_params *params = &run->params;
	ts_space hall = ts_view_hall(ts_run_info(run));
	ts_particle_args args = {
		.lights = ts_frame_make1(&run->frame, TS_B_vpl_light, params->particles),
		.middle = hall.middle,
		.extent = hall.half,
		.turns = (f32)(params->frame % TS_FRAMES_A_TURN) / (f32)TS_FRAMES_A_TURN,
		.glow = params->glow,
		.n = params->particles,
		.seed = params->seed,
	};
	return args.lights != NULL ? ts_run_launch(run, TS_KERNEL_particle, &args, args.n) : TS_ERROR;
}
