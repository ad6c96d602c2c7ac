/* Vertices of this frame in world space. */
#include "kernels/base/pose.h"
#include "methods/stages.h"

static const ts_launch posed = TS_LAUNCH(pose, TS_ALL);
static const ts_launch posed_by_file = TS_LAUNCH(pose, TS_WITH(motions));

static ts_status pose(ts_run *run)
{
	ts_pose_args args = {
		.n_objects = run->scene->n_objects, .n_motion = run->scene->n_motion, .frame = TS_PARAM(&run->params, frame)};
	const ts_launch *launch = args.n_motion > 0 ? &posed_by_file : &posed;
	return TS_RUN(run, launch, &args, ts_run_size(run, TS_DIM_vertices));
}

const ts_stage ts_stage_pose = {
	.name = "pose",
	.kind = "map",
	.paper = "EPR 4.2",
	.doc = "moving objects to their place in this frame",
	.run = pose,
	.launches = TS_LAUNCHES(&posed, &posed_by_file),
};
