/* Deferred shading of a G-buffer, with the shadows of its lights, and the margins of its decisions. */
#include "kernels/surfels/deferred_margin.h"
#include "methods/surfels/surfel.h"

#define BUT_TRIANGLES(path) TS_BUT(path.scene), TS_BUT(path.view), TS_BUT(path.depth_triangle)
static const ts_launch lit = TS_LAUNCH(deferred_lit, BUT_TRIANGLES(of));
static const ts_launch lit_measured = TS_LAUNCH(deferred_lit_margin, BUT_TRIANGLES(of.of), TS_BUT(of.of.lit));
/* Without shadows, and with them. */
static const ts_launch shaded[] = {TS_LAUNCH(deferred, TS_ALL), TS_LAUNCH(deferred, TS_WITH(lit))};
#define MEASURED TS_BUT(of.radiance), TS_BUT(of.srgb)
static const ts_launch measured[] = {
	TS_LAUNCH(deferred_margin, MEASURED),
	TS_LAUNCH(deferred_margin, MEASURED, TS_WITH(of.lit)),
};

bool ts_shader_has_shadows(const ts_params *params)
{
	return TS_PARAM(params, deferred_shader) == TS_SHADER_PHONG_SHADOW ||
	       TS_PARAM(params, deferred_shader) == TS_SHADER_NPR_SHADOW;
}

bool ts_shader_is_npr(const ts_params *params)
{
	return TS_PARAM(params, deferred_shader) == TS_SHADER_NPR ||
	       TS_PARAM(params, deferred_shader) == TS_SHADER_NPR_SHADOW;
}

static u64 n_pixels(const ts_run *run) { return (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height); }

static ts_deferred_lit_args lit_values(const ts_run *run)
{
	return (ts_deferred_lit_args){
		.of =
			{
				.n_views = (u32)ts_run_size(run, TS_DIM_views),
				.n_lamps = (u32)ts_run_size(run, TS_DIM_lamps),
				.bias = TS_PARAM(&run->params, depth_map_bias),
				.slope = TS_PARAM(&run->params, depth_map_bias_slope),
			},
	};
}

static ts_status deferred_lit(ts_run *run)
{
	ts_deferred_lit_args args = lit_values(run);
	return TS_RUN(run, &lit, &args, n_pixels(run));
}

static ts_status deferred_lit_margin(ts_run *run)
{
	ts_deferred_lit_margin_args args = {.of = lit_values(run)};
	return TS_RUN(run, &lit_measured, &args, n_pixels(run));
}

static ts_deferred_args values(const ts_run *run)
{
	return (ts_deferred_args){
		.n_lights = (u32)ts_run_size(run, TS_DIM_lamps),
		.npr = ts_shader_is_npr(&run->params),
		.ambient = ts_run_info(run)->ambient,
		.exposure = TS_PARAM(&run->params, image_exposure),
	};
}

ts_status ts_deferred_ask(const ts_run *run, ts_deferred_args *args)
{
	*args = values(run);
	return TS_ASK(run, &shaded[ts_shader_has_shadows(&run->params)], args);
}

static ts_status deferred(ts_run *run)
{
	ts_deferred_args args = values(run);
	if (TS_RUN(run, &shaded[ts_shader_has_shadows(&run->params)], &args, n_pixels(run)) != TS_OK) return TS_ERROR;
	ts_run_count(run, "shading operations", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}

static ts_status deferred_margin(ts_run *run)
{
	ts_deferred_margin_args args = {.of = values(run)};
	return TS_RUN(run, &measured[ts_shader_has_shadows(&run->params)], &args, n_pixels(run));
}

const ts_stage ts_stage_deferred_lit = {
	.name = "deferred.lit",
	.kind = "map",
	.paper = "NV40: Timings & Comparison",
	.doc = "the lights that reach each pixel",
	.run = deferred_lit,
	.launches = TS_LAUNCHES(&lit),
};

const ts_stage ts_stage_deferred_lit_margin = {
	.name = "deferred.lit_margin",
	.kind = "map",
	.margin_of = "deferred.lit",
	.paper = "NV40: Timings & Comparison",
	.doc = "margins of the comparisons with depth maps",
	.run = deferred_lit_margin,
	.launches = TS_LAUNCHES(&lit_measured),
};

const ts_stage ts_stage_deferred = {
	.name = "deferred",
	.kind = "map",
	.paper = "NV40: Deferred Shading",
	.doc = "the picture, shaded once per pixel",
	.run = deferred,
	.launches = TS_LAUNCHES(&shaded[0], &shaded[1]),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_deferred_margin = {
	.name = "deferred.margin",
	.kind = "map",
	.margin_of = "deferred",
	.paper = "NV40: Deferred Shading",
	.doc = "margins of outlines, tones and light",
	.run = deferred_margin,
	.launches = TS_LAUNCHES(&measured[0], &measured[1]),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
