/* Glowing particles as virtual point lights. */
#include "../scene/view.h"
#include "stages.h"

ts_particle_args ts_particle_arguments(const ts_run *run)
{
	const ts_params *params = &run->params;
	ts_space hall = ts_view_hall(ts_run_info(run));
	return (ts_particle_args){
		.middle = hall.middle,
		.extent = hall.half,
		.turns = (f32)(params->frame % TS_FRAMES_A_TURN) / (f32)TS_FRAMES_A_TURN,
		.glow = params->glow,
		.n = params->particles,
		.seed = params->seed,
	};
}

ts_status ts_stage_particle(ts_run *run)
{
	ts_particle_args args = ts_particle_arguments(run);
	args.lights = ts_frame_make1(&run->frame, TS_B_vpl_light, args.n);
	return args.lights != NULL ? ts_run_launch(run, TS_KERNEL_particle, &args, args.n) : TS_ERROR;
}
