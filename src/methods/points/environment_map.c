/* iVIR: colours of points into level 0, and the levels above. */
#include "kernels/points/environment_map.h"
#include "methods/points/points.h"
#include "methods/raster/raster.h"

static const ts_launch copied = TS_LAUNCH(environment_map, TS_BUT(to.scene), TS_BUT(to.depth_triangle));

static ts_status environment_map(ts_run *run)
{
	ts_environment_map_args args = {
		.to = {.first_cube = run->first_unit, .n_cubes = run->n_units},
		.exposure = ts_code_exposure(&run->params),
	};
	if (TS_RUN(run, &copied, &args, ts_run_size(run, TS_DIM_texels)) != TS_OK) return TS_ERROR;
	return ts_mip_make(run, args.to);
}

const ts_stage ts_stage_environment_map = {
	.name = "environment_map",
	.kind = "map",
	.paper = "iVIR 5",
	.doc = "environment maps into mip chains",
	.run = environment_map,
	.launches = TS_LAUNCHES(&copied, &ts_mip_averaged),
};
