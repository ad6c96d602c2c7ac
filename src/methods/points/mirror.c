/* MVR: reflective pixels of the batch's reflectors look up their cubes; pixels of other batches stay as they are. */
#include "kernels/points/mirror.h"
#include "methods/stages.h"

static const ts_launch launch = TS_LAUNCH(mirror, TS_ALL);

static ts_status mirror(ts_run *run)
{
	ts_mirror_args args = {
		.first_cube = run->first_unit,
		.n_cubes = run->n_units,
		.supersample = TS_PARAM(&run->params, mvr_filter) == TS_MVR_SUPERSAMPLE,
	};
	return TS_RUN(run, &launch, &args, ts_run_size(run, TS_DIM_mirror_pixels));
}

const ts_stage ts_stage_mirror = {
	.name = "mirror",
	.kind = "map",
	.paper = "EPR 4.2",
	.doc = "MVR: mip-mapped look-ups of the reflective pixels",
	.run = mirror,
	.launches = TS_LAUNCHES(&launch),
};
