/* Filters the gathered light. */
#include "kernels/views/bilateral.h"
#include "methods/raster/raster.h"

static const ts_launch along_rows =
	TS_LAUNCH(bilateral, TS_IN(from, vpl_gather_irradiance), TS_OUT(to, bilateral_filtered_rows));
static const ts_launch along_columns =
	TS_LAUNCH(bilateral, TS_IN(from, bilateral_filtered_rows), TS_OUT(to, indirect_irradiance));

static ts_status bilateral(ts_run *run)
{
	const ts_params *params = &run->params;
	ts_bilateral_args args = {
		.width = TS_PARAM(params, width), .height = TS_PARAM(params, height), .radius = TS_PARAM(params, bilateral_px)};
	u64 n = ts_eye_size(run);
	if (TS_RUN(run, &along_rows, &args, n) != TS_OK) return TS_ERROR;
	args.columns = 1;
	return TS_RUN(run, &along_columns, &args, n);
}

const ts_stage ts_stage_bilateral = {
	.name = "bilateral",
	.kind = "map",
	.paper = "MegaViews 5.1",
	.doc = "gathered light, filtered but not across edges",
	.run = bilateral,
	.launches = TS_LAUNCHES(&along_rows, &along_columns),
};
