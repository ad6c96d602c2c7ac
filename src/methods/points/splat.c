/* Points into the cubes. */
#include "../../kernels/points/splat.h"
#include "../stages.h"

/* Points that stand by piece, or as they arrived; and again into texels that are there, to find ties. */
static const ts_launch in_order = TS_LAUNCH(splat, TS_WITH(offset));
static const ts_launch arrived = TS_LAUNCH(splat, TS_ALL);
static const ts_launch ties = TS_LAUNCH(splat, TS_IN(texels, splat_depth_index), TS_WITH(tie));

static ts_splat_args values(const ts_run *run)
{
	return (ts_splat_args){
		.n_cubes = (u32)ts_run_size(run, TS_DIM_cubes),
		.n_words = (u32)ts_run_size(run, TS_DIM_view_words),
		.n_pieces = (u32)ts_run_size(run, TS_DIM_pieces),
		.clip = TS_PARAM(&run->params, splat_clip),
		.plane_depth = TS_PARAM(&run->params, splat_plane_depth),
	};
}

static ts_status splat(ts_run *run)
{
	ts_splat_args args = values(run);
	u64 n = ts_run_size(run, TS_DIM_points);
	if (TS_RUN(run, run->arrival ? &arrived : &in_order, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "point-view scatters", ts_frame_tally(&run->frame, 0));
	ts_run_count(run, "texel writes", ts_frame_tally(&run->frame, 1));
	return TS_OK;
}

static ts_status splat_tie(ts_run *run)
{
	ts_splat_args args = values(run);
	args.mark = 1;
	if (TS_RUN(run, &ties, &args, ts_run_size(run, TS_DIM_points)) != TS_OK) return TS_ERROR;
	const u8 *marks = ts_frame_data(&run->frame, TS_B_splat_tie);
	u64 n = ts_frame_n(&run->frame, TS_B_splat_tie);
	i64 n_tied = 0;
	for (u64 i = 0; i < n; i++) n_tied += marks[i];
	ts_run_count(run, "texels tied", n_tied);
	return TS_OK;
}

const ts_stage ts_stage_splat = {
	.name = "splat",
	.kind = "scatter",
	.paper = "EPR 3.5",
	.doc = "points into cube faces by 64-bit minimum",
	.run = splat,
	.launches = TS_LAUNCHES(&in_order, &arrived),
};

const ts_stage ts_stage_splat_tie = {
	.name = "splat.tie",
	.kind = "scatter",
	.paper = "EPR 3.5",
	.doc = "texels that another point of the same distance might have won",
	.run = splat_tie,
	.launches = TS_LAUNCHES(&ties),
};
