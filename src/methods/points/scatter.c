/* Points into the off-screen views of the batch: stored ones, or made from the pieces on the spot. */
#include "kernels/points/scatter.h"
#include "methods/points/points.h"

static const ts_scatters into_depths = {
	TS_LAUNCH(scatter, TS_STORED_POINTS(from), TS_WITH(depths)),
	TS_LAUNCH(scatter_pieces, TS_WITH(depths)),
};
static const ts_scatters into_colours = {
	TS_LAUNCH(scatter, TS_STORED_POINTS(from), TS_WITH(colours)),
	TS_LAUNCH(scatter_pieces, TS_WITH(colours)),
};

f32 ts_code_exposure(const ts_params *params)
{
	return TS_PARAM(params, image_exposure) / TS_PARAM(params, scatter_headroom);
}

ts_scatter_args ts_scatter_values(const ts_run *run)
{
	ts_scatter_args args = {
		.from = ts_points_values(run),
		.n_words = (u32)ts_run_size(run, TS_DIM_view_words),
	};
	ts_run_views(run, &args.first_view, &args.n_views);
	return args;
}

ts_status ts_scatter_run(ts_run *run, const ts_scatters *own, void *args, size_t bytes, u32 n_views)
{
	bool stored = ts_run_has(run, TS_B_points_record);
	const ts_launch *taken = stored ? &own->stored : &own->pieces;
	if (ts_launch_fill(run, taken, args, bytes) != TS_OK) return TS_ERROR;
	if (n_views == 0) return TS_OK;
	u64 n = ts_run_size(run, stored ? TS_DIM_points : TS_DIM_pieces);
	if (ts_launch_items(run, taken, args, n) != TS_OK) return TS_ERROR;
	if (!stored || run->first_unit == 0) ts_run_count(run, "geometry traversals", 1);
	if (!stored && run->first_unit == 0) ts_run_count(run, "points", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "point-view scatters", ts_frame_tally(&run->frame, 1));
	ts_run_count(run, "texel writes", ts_frame_tally(&run->frame, 2));
	return TS_OK;
}

static ts_scatter_args values(const ts_run *run)
{
	ts_scatter_args args = ts_scatter_values(run);
	args.centre = TS_PARAM(&run->params, scatter_at) == TS_SCATTER_CENTRE;
	args.culled = TS_PARAM(&run->params, points_cull);
	return args;
}

static ts_status scatter(ts_run *run)
{
	ts_scatter_args args = values(run);
	return ts_scatter_run(run, &into_depths, &args, sizeof args, args.n_views);
}

static ts_status scatter_colour(ts_run *run)
{
	ts_scatter_args args = values(run);
	args.exposure = ts_code_exposure(&run->params);
	return ts_scatter_run(run, &into_colours, &args, sizeof args, args.n_views);
}

const ts_stage ts_stage_scatter = {
	.name = "scatter",
	.kind = "scatter",
	.paper = "iVIR 4",
	.doc = "points into depth maps by 32-bit minimum",
	.run = scatter,
	.launches = TS_LAUNCHES(&into_depths.stored, &into_depths.pieces),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_cube_size_face),
};

const ts_stage ts_stage_scatter_colour = {
	.name = "scatter.colour",
	.kind = "scatter",
	.paper = "iVIR 5",
	.doc = "points into environment maps: 13 bits of depth, 19 of colour",
	.run = scatter_colour,
	.launches = TS_LAUNCHES(&into_colours.stored, &into_colours.pieces),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_cube_size_face),
};
