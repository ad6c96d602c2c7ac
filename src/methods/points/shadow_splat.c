/* Points of EPR's shadows into the depth maps of the batch. */
#include "kernels/points/scatter.h"
#include "kernels/points/shadow_splat.h"
#include "methods/points/points.h"

static const ts_scatters splats = {
	TS_LAUNCH(shadow_splat, TS_STORED_POINTS(of.from), TS_WITH(of.depths)),
	TS_LAUNCH(shadow_splat_pieces, TS_WITH(of.depths)),
};

/* EPR: scatters points smaller than a texel, and splats larger ones as squares. */
static ts_status shadow_splat(ts_run *run)
{
	ts_shadow_splat_args args = {
		.of = ts_scatter_values(run),
		.clip = TS_PARAM(&run->params, splat_clip),
		.inset = ts_splat_inset(&run->params),
		.plane_depth = TS_PARAM(&run->params, shadow_splat_depth) == TS_SHADOW_DEPTH_PLANE,
	};
	if (ts_scatter_run(run, &splats, &args, sizeof args, args.of.n_views) != TS_OK) return TS_ERROR;
	ts_run_count(run, "direct writes", ts_frame_tally(&run->frame, 2));
	ts_run_count(run, "splats", ts_frame_tally(&run->frame, 3));
	ts_run_count(run, "texel writes", ts_frame_tally(&run->frame, 4));
	return TS_OK;
}

const ts_stage ts_stage_shadow_splat = {
	.name = "shadow_splat",
	.kind = "scatter",
	.paper = "EPR 5.1",
	.doc = "points into depth maps: those smaller than a texel as they are, larger ones as squares",
	.run = shadow_splat,
	.launches = TS_LAUNCHES(&splats.stored, &splats.pieces),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_cube_size_face),
};
