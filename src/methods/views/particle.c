/* Glowing particles as virtual point lights. */
#include "kernels/views/particle.h"
#include "methods/views/views.h"
#include "scene/view.h"

static const ts_launch launch = TS_LAUNCH(particle, TS_ALL);

ts_particle_args ts_particle_values(const ts_run *run)
{
	const ts_params *params = &run->params;
	ts_space hall = ts_view_hall(ts_run_info(run));
	return (ts_particle_args){
		.middle = hall.middle,
		.extent = hall.half,
		.turns = (f32)(TS_PARAM(params, frame) % TS_FRAMES_A_TURN) / (f32)TS_FRAMES_A_TURN,
		.glow = TS_PARAM(params, particle_glow),
		.n = TS_PARAM(params, particle_count),
		.seed = TS_PARAM(params, seed),
	};
}

static ts_status particle(ts_run *run)
{
	ts_particle_args args = ts_particle_values(run);
	ts_run_set_size(run, TS_DIM_vpls, args.n);
	return TS_RUN(run, &launch, &args, args.n);
}

const ts_stage ts_stage_particle = {
	.name = "particle",
	.kind = "map",
	.paper = "MegaViews 5.2",
	.doc = "glowing particles; each is a virtual point light to all sides, and a view",
	.run = particle,
	.launches = TS_LAUNCHES(&launch),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
