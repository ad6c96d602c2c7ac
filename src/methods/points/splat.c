/* Points into the cubes. */
#include "kernels/points/splat.h"
#include "methods/points/points.h"
#include "methods/stages.h"

/* Points in order of pieces, or of arrival; and again into finished texels, to find ties. */
#define STORED TS_BUT(from.scene), TS_IN(from.points, points_record)
static const ts_launch in_order = TS_LAUNCH(splat, STORED, TS_COUNTED_POINTS(from));
static const ts_launch arrived = TS_LAUNCH(splat, STORED);
/* Texels that no look-up reads are left out; not among the stage's launches, as no trace has them. */
static const ts_launch asked = TS_LAUNCH(splat, STORED, TS_COUNTED_POINTS(from), TS_WITH(pixels), TS_WITH(view));
#define TIES TS_IN(texels, splat_depth_index), TS_WITH(tie)
static const ts_launch ties_in_order = TS_LAUNCH(splat, STORED, TS_COUNTED_POINTS(from), TIES);
static const ts_launch ties_arrived = TS_LAUNCH(splat, STORED, TIES);
/* Launches for points that are made on the spot. */
static const ts_launch direct = TS_LAUNCH(splat_fragments, TS_COUNTED_POINTS(from));
static const ts_launch direct_ties = TS_LAUNCH(splat_fragments, TS_COUNTED_POINTS(from), TIES);
/* Colours instead of indices. */
#define COLOURS TS_MIN(texels, splat_depth_colour), TS_WITH(colours)
static const ts_launch coloured_in_order = TS_LAUNCH(splat, STORED, TS_COUNTED_POINTS(from), COLOURS);
static const ts_launch coloured_arrived = TS_LAUNCH(splat, STORED, COLOURS);

f32 ts_splat_inset(const ts_params *params)
{
	return TS_PARAM(params, splat_box) == TS_BOX_TOUCHED ? 0 : TS_SPLAT_INSET;
}

static ts_splat_args values(const ts_run *run)
{
	return (ts_splat_args){
		.n_cubes = (u32)ts_run_size(run, TS_DIM_cubes),
		.n_words = (u32)ts_run_size(run, TS_DIM_view_words),
		.n_pieces = (u32)ts_run_size(run, TS_DIM_pieces),
		.clip = TS_PARAM(&run->params, splat_clip),
		.inset = ts_splat_inset(&run->params),
		.plane_depth = TS_PARAM(&run->params, splat_plane_depth),
	};
}

static ts_status put(ts_run *run, const ts_launch *launch, ts_splat_args *args, ts_dim items)
{
	if (TS_RUN(run, launch, args, ts_run_size(run, items)) != TS_OK) return TS_ERROR;
	ts_run_count(run, "point-view scatters", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "texel writes", ts_frame_tally(&run->frame, 1));
	return TS_OK;
}

/* Only look-ups of the first bounce read the texels, and only the fast path leaves any out. */
static bool leaves_out(const ts_run *run)
{
	bool fast = run->backend == NULL && !run->c.no_fast_paths && !run->arrival;
	return fast && ts_launch_spares(run, &asked, "texels") && TS_PARAM(&run->params, lookup_bounces) < 2;
}

static ts_status splat_asked(ts_run *run, ts_splat_args *args)
{
	args->n_pixels = (u32)ts_run_size(run, TS_DIM_mirror_pixels);
	return TS_RUN(run, &asked, args, ts_run_size(run, TS_DIM_points));
}

static ts_status splat(ts_run *run)
{
	ts_splat_args args = values(run);
	if (leaves_out(run)) return splat_asked(run, &args);
	return put(run, run->arrival ? &arrived : &in_order, &args, TS_DIM_points);
}

static ts_status splat_direct(ts_run *run)
{
	ts_splat_args args = values(run);
	args.from = ts_points_values(run);
	return put(run, &direct, &args, TS_DIM_pieces);
}

static ts_status splat_colour(ts_run *run)
{
	ts_splat_args args = values(run);
	args.coloured = 1;
	return put(run, run->arrival ? &coloured_arrived : &coloured_in_order, &args, TS_DIM_points);
}

static ts_status mark(ts_run *run, const ts_launch *launch, ts_splat_args *args, ts_dim items)
{
	args->mark = 1;
	if (TS_RUN(run, launch, args, ts_run_size(run, items)) != TS_OK) return TS_ERROR;
	const u8 *marks = ts_frame_data(&run->frame, TS_B_splat_tie);
	u64 n = ts_frame_n(&run->frame, TS_B_splat_tie);
	i64 n_tied = 0;
	for (u64 i = 0; i < n; i++) n_tied += marks[i];
	ts_run_count(run, "texels tied", n_tied);
	return TS_OK;
}

static ts_status splat_tie(ts_run *run)
{
	ts_splat_args args = values(run);
	return mark(run, run->arrival ? &ties_arrived : &ties_in_order, &args, TS_DIM_points);
}

static ts_status splat_direct_tie(ts_run *run)
{
	ts_splat_args args = values(run);
	args.from = ts_points_values(run);
	return mark(run, &direct_ties, &args, TS_DIM_pieces);
}

const ts_stage ts_stage_splat = {
	.name = "splat",
	.kind = "scatter",
	.paper = "EPR 3.5",
	.doc = "points into cube faces by 64-bit minimum",
	.run = splat,
	.launches = TS_LAUNCHES(&in_order, &arrived),
};

const ts_stage ts_stage_splat_colour = {
	.name = "splat.colour",
	.kind = "scatter",
	.paper = "EPR 3.5",
	.doc = "colours of points into cube faces by 64-bit minimum",
	.run = splat_colour,
	.launches = TS_LAUNCHES(&coloured_in_order, &coloured_arrived),
};

const ts_stage ts_stage_splat_tie = {
	.name = "splat.tie",
	.kind = "scatter",
	.paper = "EPR 3.5",
	.doc = "texels that another point at the same distance might have won",
	.run = splat_tie,
	.launches = TS_LAUNCHES(&ties_in_order, &ties_arrived),
};

const ts_stage ts_stage_splat_direct = {
	.name = "splat.direct",
	.kind = "scatter",
	.paper = "EPR 3.4",
	.doc = "points, splatted as they are made and not stored",
	.run = splat_direct,
	.launches = TS_LAUNCHES(&direct),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};

const ts_stage ts_stage_splat_direct_tie = {
	.name = "splat.direct_tie",
	.kind = "scatter",
	.paper = "EPR 3.4",
	.doc = "texels that another point at the same distance might have won, without stored points",
	.run = splat_direct_tie,
	.launches = TS_LAUNCHES(&direct_ties),
	.looks_at = TS_BUFFERS(TS_B_scene_info),
};
