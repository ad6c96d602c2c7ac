/* Boxes, balls and cube sizes of the reflectors. With cube.hysteresis, the only state between frames (METHODS 2), sizes
 * depend on those of the frame before. The frames before are replayed, except those that a sequence has just run and
 * turns that change nothing. There are few items per frame, so the C backend always runs them. */
#include <stdlib.h>
#include "kernels/points/cube_size.h"
#include "methods/stages.h"
#include "scene/view.h"

typedef struct {
	ts_run *run;
	ts_cube_size_args args;
	u32 n;
	u32 turn;  /* frames after which all motion repeats; 0: more than there are */
	u32 *then; /* the sizes at the end of the turn before */
} replay;

static u32 common_turn(const ts_run *run)
{
	u64 turn = ts_view_period(ts_run_info(run), run->scene->n_path);
	for (u32 i = 0; i < run->scene->n_objects && turn != 0; i++) {
		u64 period = run->scene->objects[i].period, a = turn, b = period;
		while (b != 0) {
			u64 rest = a % b;
			a = b;
			b = rest;
		}
		if (period != 0) turn = turn / a * period;
		if (turn > UINT32_MAX) turn = 0;
	}
	return (u32)turn;
}

static ts_status resize(replay *r, u32 frame)
{
	static const ts_launch launch = TS_LAUNCH(cube_size, TS_ALL);
	ts_backend *c = &r->run->c.backend;
	ts_params params = r->run->params;
	ts_view view;
	TS_PARAM_SET(&params, frame, frame);
	ts_view_on_path(&view, ts_run_info(r->run), r->run->scene->path, r->run->scene->n_path, &params);
	r->args.view = &view;
	r->args.frame = frame;
	return c->launch(c, &r->run->frame, &launch, &r->args, r->n);
}

/* Whether this turn ends with the sizes of the one before: so will all that follow. */
static bool turns_alike(replay *r)
{
	bool alike = true;
	for (u32 i = 0; i < r->n; i++) {
		alike &= r->then[i] == r->args.cubes[i].n;
		r->then[i] = r->args.cubes[i].n;
	}
	return alike;
}

/* The first frame to replay for this one, with the sizes before it. */
static u32 begin(const replay *r)
{
	const ts_history *history = r->run->history;
	u32 frame = TS_PARAM(&r->run->params, frame);
	bool known = history != NULL && history->n != NULL && history->n_cubes == r->n && history->frame < frame;
	for (u32 i = 0; i < r->n; i++) {
		r->args.cubes[i].n = known ? history->n[i] : 0;
		r->then[i] = UINT32_MAX;
	}
	if (r->n == 0 || r->args.fixed != 0 || r->args.hysteresis == 0) return frame;
	return known ? history->frame + 1 : 0;
}

static ts_status keep(const replay *r)
{
	ts_history *history = r->run->history;
	if (history == NULL) return TS_OK;
	free(history->n);
	*history = (ts_history){.n = ts_alloc(r->n, sizeof *history->n, "sizes of cubes"),
	                        .frame = TS_PARAM(&r->run->params, frame),
	                        .n_cubes = r->n};
	for (u32 i = 0; i < r->n && history->n != NULL; i++) history->n[i] = r->args.cubes[i].n;
	return history->n != NULL ? TS_OK : TS_ERROR;
}

static ts_status replay_all(replay *r)
{
	u32 last = TS_PARAM(&r->run->params, frame);
	r->turn = common_turn(r->run);
	r->then = ts_alloc(r->n, sizeof *r->then, "sizes of cubes");
	if (r->then == NULL) return TS_ERROR;
	ts_status status = TS_OK;
	for (u32 frame = begin(r); frame <= last && status == TS_OK; frame++) {
		bool repeats = ts_run_info(r->run)->circles == TS_CIRCLES_PATH;
		bool stands = repeats || frame + 1 >= r->run->scene->n_path;
		bool ended = stands && r->turn != 0 && frame % r->turn == 0;
		if (ended && turns_alike(r)) frame = last - last % r->turn;
		status = resize(r, frame);
	}
	free(r->then);
	return status == TS_OK ? keep(r) : status;
}

static ts_status cube_size(ts_run *run)
{
	u32 n = ts_run_info(run)->n_reflectors;
	ts_sizes_cubes(&run->sizes, n);
	ts_face *cubes = ts_run_make(run, TS_B_cube_size_face);
	u32 *objects = ts_alloc(n, sizeof *objects, "reflectors");
	if (cubes == NULL || objects == NULL) {
		free(objects);
		return TS_ERROR;
	}
	memset(cubes, 0, n * sizeof *cubes);
	for (u32 i = 0; i < run->scene->n_objects; i++) {
		u32 reflector = run->scene->objects[i].reflector;
		if (reflector != TS_NONE) objects[reflector] = i;
	}
	ts_cube_size_args args = {
		.vertices = ts_frame_data(&run->frame, TS_B_scene_vertex),
		.objects = ts_frame_data(&run->frame, TS_B_scene_object),
		.motions = run->scene->motion,
		.n_objects = run->scene->n_objects,
		.n_motion = run->scene->n_motion,
		.reflector_objects = objects,
		.cubes = cubes,
		.n_max = ts_largest_face(&run->params),
		.hysteresis = TS_PARAM(&run->params, cube_hysteresis),
		.fixed = run->plan.offscreen.side != 0 ? run->plan.offscreen.side : TS_PARAM(&run->params, cube_px),
		.all = run->plan.offscreen.all || TS_PARAM(&run->params, lookup_bounces) > 1,
	};
	replay all = {.run = run, .args = args, .n = n};
	ts_status status = replay_all(&all);
	free(objects);
	if (status != TS_OK) return status;
	u64 offset = 0;
	for (u32 r = 0; r < n; r++) {
		cubes[r].offset = offset;
		offset += (u64)6 * cubes[r].n * cubes[r].n;
	}
	ts_run_count(run, "cube texels", (i64)offset);
	return TS_OK;
}

const ts_stage ts_stage_cube_size = {
	.name = "cube_size",
	.kind = "map",
	.paper = "EPR 3.5",
	.doc = "box, ball and cube size of every reflector",
	.run = cube_size,
	.looks_at = TS_BUFFERS(TS_B_scene_vertex, TS_B_scene_object, TS_B_scene_path, TS_B_scene_motion, TS_B_scene_info),
	.makes = TS_BUFFERS(TS_B_cube_size_face),
};
