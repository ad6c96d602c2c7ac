/* Shadows from depth maps: how many samples of each light reach a pixel, and the comparisons' margins. */
#include "kernels/raster/shadow_test_margin.h"
#include "methods/raster/raster.h"

static const ts_launch resolved = TS_LAUNCH(shadow_test, TS_ALL);
static const ts_launch measured = TS_LAUNCH(shadow_test_margin, TS_BUT(of.lit));

ts_shadow_test_args ts_resolve_values(const ts_run *run)
{
	ts_shadow_test_args args = {
		.scene = ts_run_scene(run),
		.n_lamps = (u32)ts_run_size(run, TS_DIM_lamps),
		.cubes = ts_run_has_cubes(run),
		.bias = TS_PARAM(&run->params, depth_map_bias),
		.slope = TS_PARAM(&run->params, depth_map_bias_slope),
		.samples = ts_eye_samples(&run->params),
	};
	ts_run_views(run, &args.first_view, &args.n_views);
	return args;
}

static ts_status shadow_test(ts_run *run)
{
	ts_shadow_test_args args = ts_resolve_values(run);
	return TS_RUN(run, &resolved, &args, ts_eye_size(run));
}

static ts_status shadow_test_margin(ts_run *run)
{
	ts_shadow_test_margin_args args = {.of = ts_resolve_values(run)};
	return TS_RUN(run, &measured, &args, ts_eye_size(run));
}

const ts_stage ts_stage_shadow_test = {
	.name = "shadow_test",
	.kind = "map",
	.paper = "iVIR 4",
	.doc = "number of light samples that reach each pixel",
	.run = shadow_test,
	.launches = TS_LAUNCHES(&resolved),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_cube_size_face, TS_B_lamp_shape),
};

const ts_stage ts_stage_shadow_test_margin = {
	.name = "shadow_test.margin",
	.kind = "map",
	.margin_of = "shadow_test",
	.paper = "iVIR 4",
	.doc = "margins of the comparisons with depth maps",
	.run = shadow_test_margin,
	.launches = TS_LAUNCHES(&measured),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_cube_size_face, TS_B_lamp_shape),
};
