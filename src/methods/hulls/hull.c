/* Every pixel's box, and the lobes of its corners at the pixel. */
#include "kernels/hulls/hull_margin.h"
#include "methods/hulls/gloss.h"
#include "methods/raster/raster.h"

static const ts_launch interpolated = TS_LAUNCH(hull, TS_ALL);
static const ts_launch measured = TS_LAUNCH(hull_margin, TS_ALL);

static ts_choice_args choice(const ts_run *run)
{
	return (ts_choice_args){
		.grid = TS_PARAM(&run->params, depth_grid_px),
		.robust = TS_PARAM(&run->params, hull_surface) == TS_SURFACE_ROBUST,
		.step = TS_PARAM(&run->params, segment_step),
	};
}

ts_hull_args ts_hull_values(const ts_run *run)
{
	return (ts_hull_args){
		.choice = choice(run),
		.width = TS_PARAM(&run->params, width),
		.height = TS_PARAM(&run->params, height),
		.cosine = TS_PARAM(&run->params, hull_cosine),
		.by_moments = TS_PARAM(&run->params, hull_interpolation) == TS_INTERPOLATION_MOMENTS,
		.vmf = TS_PARAM(&run->params, hull_sharpness) == TS_SHARPNESS_VMF,
		.printed = TS_PARAM(&run->params, hull_integrals) == TS_INTEGRALS_PRINTED,
		.rectangle = TS_PARAM(&run->params, hull_corners) == TS_CORNERS_RECTANGLE,
	};
}

static ts_status hull(ts_run *run)
{
	ts_hull_args args = ts_hull_values(run);
	if (TS_RUN(run, &interpolated, &args, ts_eye_size(run)) != TS_OK) return TS_ERROR;
	ts_run_count(run, "pixels without a segment", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}

static ts_status hull_margin(ts_run *run)
{
	ts_hull_margin_args args = {
		.choice = choice(run), .width = TS_PARAM(&run->params, width), .height = TS_PARAM(&run->params, height)};
	return TS_RUN(run, &measured, &args, ts_eye_size(run));
}

const ts_stage ts_stage_hull = {
	.name = "hull",
	.kind = "map",
	.paper = "SSAGH 4, eqs 15 to 18",
	.doc = "the box of each pixel, its lobes interpolated between the corners, and their integral with the cosine",
	.run = hull,
	.launches = TS_LAUNCHES(&interpolated),
};

const ts_stage ts_stage_hull_margin = {
	.name = "hull.margin",
	.kind = "map",
	.margin_of = "hull",
	.paper = "SSAGH 3",
	.doc = "margins of each pixel's choice of a box",
	.run = hull_margin,
	.launches = TS_LAUNCHES(&measured),
};
