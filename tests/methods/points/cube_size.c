/* Sizes of cubes over frames: what a sequence remembers, what the turn repeats, and replaying every frame agree;
 * and sizes of shadow cubes. */
#include <stdlib.h>
#include "kernels/points/cube_size.h"
#include "methods/stages.h"
#include "scene/view.h"
#include "tests/methods/small.h"

enum { N_CUBES = 4, PATH_FRAMES = 701, STARTS = 600, PACE = 3, MOTION_FRAMES = 60 };

static ts_params moving_params(void)
{
	ts_params params = small_params(384, 216);
	params.reflectors_count = N_CUBES;
	params.cube_hysteresis = 8;
	return params;
}

/* The stage's sizes. */
static void sizes_of(u32 sizes[N_CUBES], const ts_scene *scene, const ts_params *params, ts_history *history)
{
	ts_run run;
	ts_run_begin(&run, scene, params, 1);
	run.history = history;
	if (ts_run_stage(&run, ts_stage_find("cube_size")) != TS_OK) fail_msg("%s", ts_error_message());
	const ts_face *cubes = ts_frame_data(&run.frame, TS_B_cube_size_face);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_cube_size_face), N_CUBES);
	for (u32 i = 0; i < N_CUBES; i++) sizes[i] = cubes[i].n;
	ts_run_end(&run);
}

/* A path on which the eye stands still for two turns, circles PACE times as fast, and stands still again. */
static u32 pace_of(u32 frame)
{
	u32 last = frame < PATH_FRAMES ? frame : PATH_FRAMES - 1;
	return last > STARTS ? PACE * (last - STARTS) : 0;
}

static void set_eye(ts_path_eye *at, const ts_view *view)
{
	memcpy(at->eye, view->eye, sizeof at->eye);
	memcpy(at->right, view->right, sizeof at->right);
	memcpy(at->up, view->up, sizeof at->up);
	memcpy(at->back, view->back, sizeof at->back);
}

static void set_path(ts_scene *scene, ts_params params)
{
	scene->path = calloc(PATH_FRAMES, sizeof *scene->path);
	scene->n_path = PATH_FRAMES;
	for (u32 frame = 0; frame < PATH_FRAMES; frame++) {
		ts_view view;
		ts_path_eye *at = &scene->path[frame];
		params.frame = pace_of(frame);
		ts_view_eye(&view, &scene->info, &params);
		set_eye(at, &view);
	}
}

/* Mirror 0 goes to and fro once in MOTION_FRAMES, as a file would have it. */
static void set_motion(ts_scene *scene)
{
	u32 mover = 0;
	while (scene->objects[mover].reflector != 0) mover++;
	ts_object *object = &scene->objects[mover];
	scene->motion = calloc((size_t)MOTION_FRAMES * scene->n_objects, sizeof *scene->motion);
	scene->n_motion = MOTION_FRAMES;
	object->period = MOTION_FRAMES;
	for (u32 frame = 0; frame < MOTION_FRAMES; frame++) {
		ts_motion *at = &scene->motion[(size_t)frame * scene->n_objects + mover];
		u32 there = frame < MOTION_FRAMES / 2 ? frame : MOTION_FRAMES - frame;
		at->moves = 1;
		memcpy(at->origin, object->centre, sizeof at->origin);
		at->origin[1] += 0.1f * (f32)there;
		for (u32 i = 0; i < 9; i += 4) at->linear[i] = at->normal[i] = 1 + 0.01f * (f32)there;
	}
}

/* Every frame by the kernel, one after the other. */
static void replay(u32 (*sizes)[N_CUBES], u32 n_frames, const ts_scene *scene, ts_params params)
{
	ts_face cubes[N_CUBES];
	u32 objects[N_CUBES];
	ts_view view;
	memset(cubes, 0, sizeof cubes);
	for (u32 i = 0; i < scene->n_objects; i++) {
		if (scene->objects[i].reflector != TS_NONE) objects[scene->objects[i].reflector] = i;
	}
	ts_cube_size_args args = {.vertices = scene->vertices,
	                          .objects = scene->objects,
	                          .reflector_objects = objects,
	                          .motions = scene->motion,
	                          .n_objects = scene->n_objects,
	                          .n_motion = scene->n_motion,
	                          .view = &view,
	                          .cubes = cubes,
	                          .n_max = ts_largest_face(&params),
	                          .hysteresis = params.cube_hysteresis};
	for (args.frame = 0; args.frame < n_frames; args.frame++) {
		params.frame = scene->n_path > 0 ? pace_of(args.frame) : args.frame;
		ts_view_eye(&view, &scene->info, &params);
		for (u32 i = 0; i < N_CUBES; i++) {
			ts_k_cube_size_item(&args, i);
			sizes[args.frame][i] = cubes[i].n;
		}
	}
}

static void check_frames(bool on_path, bool by_file)
{
	enum { N_FRAMES = 1100, STEP = 7 };
	static u32 expected[N_FRAMES][N_CUBES];
	ts_params params = moving_params();
	ts_scene *scene = small_scene(&params);
	ts_history history = {.n = NULL};
	u32 sizes[N_CUBES], n_apart = 0;
	if (on_path) set_path(scene, params);
	if (by_file) set_motion(scene);
	replay(expected, N_FRAMES, scene, params);
	for (u32 frame = 0; frame < N_FRAMES; frame += STEP) {
		params.frame = frame;
		sizes_of(sizes, scene, &params, &history);
		assert_memory_equal(sizes, expected[frame], sizeof sizes);
		params.cube_hysteresis = 0;
		u32 bare[N_CUBES];
		sizes_of(bare, scene, &params, NULL);
		n_apart += memcmp(bare, sizes, sizeof bare) != 0;
		params.cube_hysteresis = 8;
	}
	assert_true(n_apart > 10); /* sizes do depend on the frames before */
	static const u32 alone[] = {0, 1, 239, 240, 241, 479, 480, 481, 700, 701, 719, 720, 721, 959, 960, 961, 1000, 1099};
	for (u32 i = 0; i < sizeof alone / sizeof *alone; i++) {
		params.frame = alone[i];
		sizes_of(sizes, scene, &params, NULL);
		assert_memory_equal(sizes, expected[alone[i]], sizeof sizes);
	}
	free(history.n);
	ts_scene_free(scene);
}

static void any_frame_sizes_cubes_as_a_replay(void **state)
{
	(void)state;
	check_frames(false, false);
}

static void a_moving_eye_sizes_cubes_as_replays(void **state)
{
	(void)state;
	check_frames(true, false);
}

static void moving_mirrors_size_cubes_as_a_replay(void **state)
{
	(void)state;
	check_frames(false, true);
	check_frames(true, true);
}

/* A history of a later frame, or of other cubes, is none. */
static void a_foreign_history_is_none(void **state)
{
	(void)state;
	ts_params params = moving_params();
	ts_scene *scene = small_scene(&params);
	u32 sizes[N_CUBES], expected[N_CUBES];
	params.frame = 30;
	sizes_of(expected, scene, &params, NULL);
	for (u32 k = 0; k < 2; k++) {
		ts_history history = {.n = calloc(N_CUBES, sizeof(u32)), .frame = k == 0 ? 30 : 29, .n_cubes = N_CUBES - k};
		sizes_of(sizes, scene, &params, &history);
		assert_memory_equal(sizes, expected, sizeof sizes);
		assert_int_equal(history.frame, 30);
		assert_memory_equal(history.n, expected, sizeof sizes);
		free(history.n);
	}
	ts_scene_free(scene);
}

/* All shadow cubes have the side that the eye's least quotient asks, METHODS' rule in other words; here the eye goes
 * back from the hall, until the least sides do. */
static void shadow_cubes_are_as_fine_as_the_eye_needs(void **state)
{
	(void)state;
	enum { MOST = 100, N_EYES = 6 };
	static const u32 steps[] = {0, 1, 8, 24};
	ts_params params = small_params(64, 36);
	params.lamp_cubes = 3;
	params.depth_map_px = MOST;
	ts_scene *scene = small_scene(&params);
	ts_view view;
	u32 n_between = 0;
	ts_view_eye(&view, &scene->info, &params);
	scene->path = calloc(1, sizeof *scene->path);
	scene->n_path = 1;
	for (u32 i = 0; i < N_EYES * 4; i++) {
		ts_path_eye *at = scene->path;
		ts_run run;
		params.cube_hysteresis = steps[i % 4];
		params.shadow_splat_resize = i != 0;
		set_eye(at, &view);
		for (u32 k = 0; k < 3; k++) at->eye[k] += view.back[k] * 20 * (f32)(i / 4 * (i / 4));
		ts_run_begin(&run, scene, &params, 2);
		if (ts_pipeline_run(ts_pipeline_find("omni-shadows", "epr"), &run) != TS_OK) fail_msg("%s", ts_error_message());
		const ts_face *cubes = ts_frame_data(&run.frame, TS_B_cube_size_face);
		f32 least = ts_u2f(*(const u32 *)ts_frame_data(&run.frame, TS_B_shadow_cube_size_least_ratio));
		u32 side = 0, step = steps[i % 4] > 0 ? steps[i % 4] : 1;
		while (side < MOST && (side % step != 0 || side < 16 || (f32)side <= MOST / least)) side++;
		if (i == 0) side = MOST;
		assert_int_equal(ts_frame_n(&run.frame, TS_B_cube_size_face), 3);
		for (u32 k = 0; k < 3; k++) {
			assert_int_equal(cubes[k].n, side);
			assert_int_equal(cubes[k].offset, k * 6 * side * side);
		}
		n_between += side > 16 && side < MOST;
		ts_run_end(&run);
	}
	assert_true(n_between >= 4);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(any_frame_sizes_cubes_as_a_replay),
		cmocka_unit_test(a_moving_eye_sizes_cubes_as_replays),
		cmocka_unit_test(moving_mirrors_size_cubes_as_a_replay),
		cmocka_unit_test(a_foreign_history_is_none),
		cmocka_unit_test(shadow_cubes_are_as_fine_as_the_eye_needs),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
