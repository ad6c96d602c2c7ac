/* Points into the off-screen views of the batch: stored ones, or made from the pieces on the spot. */
#include "../../kernels/raster/draw.h"
#include "../../kernels/points/shadow_splat.h"
#include "points.h"

/* Of points that are stored, and of pieces. */
typedef struct {
	ts_launch stored, pieces;
} launches;

#define STORED(path) TS_IN(path.keys, points_key), TS_IN(path.points, points_record)
static const launches into_depths = {
	TS_LAUNCH(scatter, STORED(from), TS_WITH(depths)),
	TS_LAUNCH(scatter_pieces, TS_WITH(depths)),
};
static const launches into_colours = {
	TS_LAUNCH(scatter, STORED(from), TS_WITH(colours)),
	TS_LAUNCH(scatter_pieces, TS_WITH(colours)),
};
static const launches splats = {
	TS_LAUNCH(shadow_splat, STORED(of.from), TS_WITH(of.depths)),
	TS_LAUNCH(shadow_splat_pieces, TS_WITH(of.depths)),
};
static const ts_launch rasterized = TS_LAUNCH(depth, TS_ALL);

static ts_scatter_args values(const ts_run *run)
{
	ts_scatter_args args = {
		.from = ts_points_values(run),
		.n_words = (u32)ts_run_size(run, TS_DIM_view_words),
		.exposure = TS_PARAM(&run->params, image_exposure),
	};
	ts_run_views(run, &args.first_view, &args.n_views);
	return args;
}

/* Without views there is nothing to scatter into. */
static ts_status launch(ts_run *run, const launches *own, void *args, size_t bytes, u32 n_views)
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

static ts_status scatter(ts_run *run)
{
	ts_scatter_args args = values(run);
	return launch(run, &into_depths, &args, sizeof args, args.n_views);
}

static ts_status scatter_colour(ts_run *run)
{
	ts_scatter_args args = values(run);
	return launch(run, &into_colours, &args, sizeof args, args.n_views);
}

/* EPR: points smaller than a texel as they are, larger ones as squares. */
static ts_status shadow_splat(ts_run *run)
{
	ts_shadow_splat_args args = {
		.of = values(run),
		.clip = TS_PARAM(&run->params, splat_clip),
		.plane_depth = TS_PARAM(&run->params, shadow_splat_depth) == TS_SHADOW_DEPTH_PLANE,
	};
	if (launch(run, &splats, &args, sizeof args, args.of.n_views) != TS_OK) return TS_ERROR;
	ts_run_count(run, "direct writes", ts_frame_tally(&run->frame, 2));
	ts_run_count(run, "splats", ts_frame_tally(&run->frame, 3));
	ts_run_count(run, "texel writes", ts_frame_tally(&run->frame, 4));
	return TS_OK;
}

/* MVR: every triangle into every view of the batch. */
static ts_status depth_map(ts_run *run)
{
	ts_depth_args args = {.scene = ts_run_scene(run)};
	ts_run_views(run, &args.first_view, &args.n_views);
	if (TS_RUN(run, &rasterized, &args, args.scene.n_triangles) != TS_OK) return TS_ERROR;
	ts_run_count(run, "geometry traversals", args.n_views);
	ts_run_count(run, "triangles processed", (i64)args.scene.n_triangles * args.n_views);
	return TS_OK;
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

const ts_stage ts_stage_shadow_splat = {
	.name = "shadow_splat",
	.kind = "scatter",
	.paper = "EPR 5.1",
	.doc = "points into depth maps: small ones as they are, large ones as squares",
	.run = shadow_splat,
	.launches = TS_LAUNCHES(&splats.stored, &splats.pieces),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_cube_size_face),
};

const ts_stage ts_stage_depth_map = {
	.name = "depth_map",
	.kind = "scatter",
	.paper = "iVIR 4",
	.doc = "MVR: standard rasterization into every depth map",
	.run = depth_map,
	.launches = TS_LAUNCHES(&rasterized),
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_cube_size_face),
};
