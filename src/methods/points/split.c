/* Pieces of triangles, each with its density. */
#include "kernels/points/split.h"
#include "methods/points/points.h"

/* Counts, then writes: for the eye through cubes; for off-screen views; for the eye through shadows. */
typedef struct {
	ts_launch count, write;
} launches;

#define COUNT TS_BUT_SURFACES, TS_BUT(pieces), TS_BUT(scale), TS_BUT(n_capped)
#define WRITE TS_BUT_SURFACES, TS_BUT(n_limited), TS_IN(whole, split_triangle_density), TS_IN(offset, split_offset)
#define OF_VIEWS TS_BUT(cubes), TS_WITH(views)
static const launches of_eye = {TS_LAUNCH(split_count, COUNT), TS_LAUNCH(split, WRITE)};
static const launches of_views = {TS_LAUNCH(split_count, COUNT, OF_VIEWS, TS_BUT(n_limited)),
                                  TS_LAUNCH(split, WRITE, OF_VIEWS)};

static ts_status divide(ts_run *run, const launches *own, ts_density_args args)
{
	u64 total, n = ts_run_size(run, TS_DIM_triangles);
	args.scene.n_triangles = (u32)n;
	args.n_words = (u32)ts_run_size(run, TS_DIM_view_words);
	args.split = TS_PARAM(&run->params, points_split);
	if (TS_RUN(run, &own->count, &args, n) != TS_OK) return TS_ERROR;
	if (own == &of_eye) ts_run_count(run, "density.limited", ts_frame_tally(&run->frame, 1));
	if (ts_launch_sum(run, &own->count, "offset", &total) != TS_OK) return TS_ERROR;
	if (TS_RUN(run, &own->write, &args, n) != TS_OK) return TS_ERROR;
	ts_run_count(run, "pieces", (i64)total);
	ts_run_count(run, "density.capped", ts_frame_tally(&run->frame, 0));
	return TS_OK;
}

u32 ts_greatest_side(const ts_params *params)
{
	if (TS_PARAM(params, density_cap) != TS_DENSITY_CAP_GREATEST) return 0;
	return TS_PARAM(params, cube_px) != 0 ? TS_PARAM(params, cube_px) : ts_largest_face(params);
}

static ts_status split(ts_run *run)
{
	const ts_density_args args = {
		.rho = ts_samples_a_pixel(&run->params),
		.n_cubes = (u32)ts_run_size(run, TS_DIM_cubes),
		.paper = TS_PARAM(&run->params, density_path) == TS_DENSITY_PAPER,
		.cap = TS_PARAM(&run->params, density_cap) != TS_DENSITY_CAP_OFF,
		.greatest = ts_greatest_side(&run->params),
		.ball = TS_PARAM(&run->params, density_mirror) == TS_MIRROR_BALL,
		.offaxis = TS_PARAM(&run->params, density_off_axis),
		.rate = TS_RATE_EYE,
	};
	return divide(run, &of_eye, args);
}

/* iVIR's density, or less for EPR's shadows where the eye sees less. */
static ts_status divide_for_views(ts_run *run, u32 shadow)
{
	const ts_density_args args = {
		.n_views = (u32)ts_run_size(run, TS_DIM_views),
		.rate = run->plan.points.rate,
		.shadow = shadow,
	};
	return divide(run, &of_views, args);
}

static ts_status split_views(ts_run *run) { return divide_for_views(run, TS_SHADOW_NONE); }

static ts_status split_shadow(ts_run *run)
{
	static const u32 rates[] = {[TS_SHADOW_RATE_SAFE] = TS_SHADOW_SAFE,
	                            [TS_SHADOW_RATE_UNIT] = TS_SHADOW_UNIT,
	                            [TS_SHADOW_RATE_PAPER] = TS_SHADOW_PAPER};
	return divide_for_views(run, rates[TS_PARAM(&run->params, shadow_splat_rate)]);
}

const ts_stage ts_stage_split = {
	.name = "split",
	.kind = "emit",
	.paper = "EPR 4.1.1, eqs 2 and 3",
	.doc = "density of every triangle; large triangles are split into pieces",
	.run = split,
	.launches = TS_LAUNCHES(&of_eye.count, &of_eye.write),
};

const ts_stage ts_stage_split_views = {
	.name = "split.views",
	.kind = "emit",
	.paper = "iVIR 3.1, eqs 2 and 3",
	.doc = "density of every triangle from the off-screen views; uneven and large triangles are split",
	.run = split_views,
	.launches = TS_LAUNCHES(&of_views.count, &of_views.write),
};

const ts_stage ts_stage_split_shadow = {
	.name = "split.shadow",
	.kind = "emit",
	.paper = "EPR 5.1, eq. 5",
	.doc = "density of every triangle from the off-screen views and the eye; large triangles are split",
	.run = split_shadow,
	.launches = TS_LAUNCHES(&of_views.count, &of_views.write),
};
