/* Light at the corners of the segments' boxes, as lobes, at every pixel; or gathered by every pixel itself. */
#include "../../kernels/hulls/direct.h"
#include "../../kernels/hulls/fit.h"
#include "../../kernels/hulls/gather.h"
#include "../../kernels/hulls/hull_margin.h"
#include "../../kernels/hulls/hull.h"
#include "../stages.h"

static const ts_launch gathered = TS_LAUNCH(gather, TS_ALL);
static const ts_launch fitted = TS_LAUNCH(fit, TS_ALL);
static const ts_launch interpolated = TS_LAUNCH(hull, TS_ALL);
static const ts_launch measured = TS_LAUNCH(hull_margin, TS_ALL);
static const ts_launch everywhere = TS_LAUNCH(direct, TS_ALL);

static u64 n_pixels(const ts_run *run) { return (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height); }

static ts_status corner(ts_run *run)
{
	u64 n = 4 * ts_run_size(run, TS_DIM_segment_boxes);
	ts_gather_args args = {.n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch),
	                       .grid = TS_PARAM(&run->params, depth_grid_px)};
	ts_run_count(run, "gathers", (i64)(n * args.n_patches));
	return TS_RUN(run, &gathered, &args, n);
}

static ts_status corner_lobes(ts_run *run)
{
	ts_fit_args args = {.vmf = TS_PARAM(&run->params, hull_sharpness) == TS_SHARPNESS_VMF};
	return TS_RUN(run, &fitted, &args, 4 * ts_run_size(run, TS_DIM_segment_boxes));
}

static ts_choice_args choice(const ts_run *run)
{
	return (ts_choice_args){
		.grid = TS_PARAM(&run->params, depth_grid_px),
		.robust = TS_PARAM(&run->params, hull_surface) == TS_SURFACE_ROBUST,
		.step = TS_PARAM(&run->params, segment_step),
	};
}

static ts_status hull(ts_run *run)
{
	ts_hull_args args = {
		.choice = choice(run),
		.width = TS_PARAM(&run->params, width),
		.height = TS_PARAM(&run->params, height),
		.cosine = TS_PARAM(&run->params, hull_cosine),
		.by_moments = TS_PARAM(&run->params, hull_interpolation) == TS_INTERPOLATION_MOMENTS,
		.vmf = TS_PARAM(&run->params, hull_sharpness) == TS_SHARPNESS_VMF,
		.printed = TS_PARAM(&run->params, hull_integrals) == TS_INTEGRALS_PRINTED,
	};
	if (TS_RUN(run, &interpolated, &args, n_pixels(run)) != TS_OK) return TS_ERROR;
	ts_run_count(run, "pixels without a segment", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}

static ts_status hull_margin(ts_run *run)
{
	ts_hull_margin_args args = {
		.choice = choice(run), .width = TS_PARAM(&run->params, width), .height = TS_PARAM(&run->params, height)};
	return TS_RUN(run, &measured, &args, n_pixels(run));
}

static ts_status direct(ts_run *run)
{
	ts_direct_args args = {.n_patches = ts_frame_n(&run->frame, TS_B_rsm_patch)};
	ts_run_count(run, "gathers", (i64)(n_pixels(run) * args.n_patches));
	return TS_RUN(run, &everywhere, &args, n_pixels(run));
}

const ts_stage ts_stage_corner = {
	.name = "corner",
	.kind = "map",
	.paper = "SSAGH 3",
	.doc = "light at the corners of every box",
	.run = corner,
	.launches = TS_LAUNCHES(&gathered),
};

const ts_stage ts_stage_corner_lobes = {
	.name = "corner.lobes",
	.kind = "map",
	.paper = "SSAGH 4, eqs 4 and 5",
	.doc = "that light as spherical Gaussians, one a channel",
	.run = corner_lobes,
	.launches = TS_LAUNCHES(&fitted),
};

const ts_stage ts_stage_hull = {
	.name = "hull",
	.kind = "map",
	.paper = "SSAGH 4, eqs 15 to 18",
	.doc = "each pixel's box, its lobes between the corners, and their integral with the cosine",
	.run = hull,
	.launches = TS_LAUNCHES(&interpolated),
};

const ts_stage ts_stage_hull_margin = {
	.name = "hull.margin",
	.kind = "map",
	.margin_of = "hull",
	.paper = "SSAGH 3",
	.doc = "how near each pixel's choice was to another box",
	.run = hull_margin,
	.launches = TS_LAUNCHES(&measured),
};

const ts_stage ts_stage_direct = {
	.name = "direct",
	.kind = "map",
	.paper = "SSAGH 5",
	.doc = "light of every triangle at every pixel by form factors",
	.run = direct,
	.launches = TS_LAUNCHES(&everywhere),
};
