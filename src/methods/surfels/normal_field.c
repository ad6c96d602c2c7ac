/* Linear fields of normals, optional for static surfels. */
#include "kernels/surfels/normal_field.h"
#include "methods/surfels/surfel.h"

static const ts_launch launch = TS_LAUNCH(normal_field, TS_ALL);

static ts_status normal_field(ts_run *run)
{
	ts_normal_field_args args;
	return TS_RUN(run, &launch, &args, ts_run_size(run, TS_DIM_surfels));
}

const ts_stage ts_stage_normal_field = {
	.name = "normal_field",
	.kind = "map",
	.paper = "NV40: Phong Shading for PBR",
	.doc = "a linear field of normals for each surfel, fitted to its nearest surfels",
	.run = normal_field,
	.launches = TS_LAUNCHES(&launch),
};
