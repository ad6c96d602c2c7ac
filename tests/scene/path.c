/* The eye's path against closed forms in doubles, and files that are refused. */
#include <math.h>
#include "model/core.h"
#include "scene/sources.h"
#include "scene/view.h"
#include "tests/comma.h"
#include "tests/model/test.h"

static void put(const char *file, const char *text, size_t bytes)
{
	FILE *out = fopen(file, "wb");
	assert_non_null(out);
	assert_int_equal(fwrite(text, 1, bytes, out), bytes);
	fclose(out);
}

static ts_scene *open_path(const char *text, bool own_fov)
{
	ts_params params;
	ts_scene *scene;
	const char *file = scratch_path("eye.txt");
	ts_scene_options options = {.path = file, .own_fov = own_fov};
	ts_params_default(&params);
	params.reflectors_count = 0;
	put(file, text, strlen(text));
	ts_build *build = ts_build_new("path");
	ts_vertex corner[3] = {{.position = {0, 0, 0}}, {.position = {1, 0, 0}}, {.position = {0, 1, 0}}};
	for (u32 i = 0; i < 3; i++) ts_build_vertex(build, &corner[i]);
	ts_build_triangle(build, 0, 1, 2, TS_NONE);
	const char *camera = ts_arrange(build, &params, &options, false);
	if (ts_build_finish(build, &params, camera, &scene) == TS_OK) return scene;
	assert_null(scene);
	return NULL;
}

/* Keyframes of the test: uneven, and with a curve that leaves the box of its points. */
enum { N_KEYS = 5 };
static const int frames[N_KEYS] = {3, 10, 12, 40, 41};
static const double values[N_KEYS][7] = {{0, 1, 8, 0, 1, 0, 50},
                                         {4.25, 1.5, 6, 0.5, 1, 0, 60},
                                         {4.5, 2, 5.5, 0.5, 1.25, -1, 61},
                                         {-7, 0.125, 9, 1, 2, 0, 30},
                                         {-7.5, 0, 9.5, 1, 2, 1, 40}};
static const char text[] = "# eye, target, degrees\n\n3 0,1,8 0,1,0 50\n10 4.25,1.5,6 0.5,1,0 60 # a comment\r\n"
						   "\t12\t4.5,2,5.5  0.5,1.25,-1 61\n40 -7,0.125,9 1,2,0 3e1\n41 -7.5, 0, 9.5 1,2,1 40";

/* Hermite's basis functions as books print them, not Horner's scheme. */
static double truth(double frame, int i)
{
	int k = 0;
	if (frame <= frames[0]) return values[0][i];
	if (frame >= frames[N_KEYS - 1]) return values[N_KEYS - 1][i];
	while (frames[k + 1] < frame) k++;
	double n = frames[k + 1] - frames[k], s = (frame - frames[k]) / n, m[2];
	for (int e = 0; e < 2; e++) {
		int at = k + e;
		bool end = at == 0 || at == N_KEYS - 1;
		m[e] = end ? 0 : (values[at + 1][i] - values[at - 1][i]) / (frames[at + 1] - frames[at - 1]);
	}
	double s2 = s * s, s3 = s2 * s;
	return (2 * s3 - 3 * s2 + 1) * values[k][i] + (s3 - 2 * s2 + s) * n * m[0] + (3 * s2 - 2 * s3) * values[k + 1][i] +
	       (s3 - s2) * n * m[1];
}

static void paths_follow_their_closed_form(void **state)
{
	(void)state;
	ts_scene *scene = open_path(text, false);
	assert_non_null(scene);
	assert_int_equal(scene->n_path, 42);
	for (int frame = 0; frame < 42; frame++) {
		const ts_path_eye *at = &scene->path[frame];
		double way[3], length = 0, away = 0;
		for (int i = 0; i < 3; i++) {
			assert_true(fabs((double)at->eye[i] - truth(frame, i)) < 4e-6);
			way[i] = truth(frame, i) - truth(frame, 3 + i);
			length += way[i] * way[i];
		}
		for (int i = 0; i < 3; i++) away = fmax(away, fabs((double)at->back[i] - way[i] / sqrt(length)));
		assert_true(away < 2e-6);
		assert_true(at->right[1] == 0.0f && at->up[1] > 0.0f);
		assert_true(fabs((double)at->yfov * 360 - truth(frame, 6)) < 1e-4);
	}
	ts_scene_free(scene);
}

/* Keyframes are met, no step is larger than the curve allows, and the eye stands still before and behind. */
static void the_eye_stands_still_before_and_behind(void **state)
{
	(void)state;
	ts_scene *scene = open_path(text, true);
	assert_non_null(scene);
	ts_params params;
	ts_view view, last;
	ts_params_default(&params);
	for (u32 k = 0; k < N_KEYS; k++) {
		for (u32 i = 0; i < 3; i++) assert_true(scene->path[frames[k]].eye[i] == (f32)values[k][i]);
	}
	for (u32 frame = 1; frame <= 3; frame++)
		assert_memory_equal(&scene->path[frame], &scene->path[0], sizeof *scene->path);
	params.frame = 41;
	ts_view_on_path(&last, &scene->info, scene->path, scene->n_path, &params);
	params.frame = 100000;
	ts_view_on_path(&view, &scene->info, scene->path, scene->n_path, &params);
	assert_memory_equal(&view, &last, sizeof view);
	params.frame = 0;
	ts_view_on_path(&last, &scene->info, scene->path, scene->n_path, &params);
	ts_view_eye(&view, &scene->info, &params);
	assert_memory_equal(&view, &last, sizeof view);
	assert_true(scene->path[7].yfov == 0.0f);
	ts_scene_free(scene);
}

static void one_keyframe_is_a_path(void **state)
{
	(void)state;
	ts_scene *scene = open_path("0 1,2,3 4,5,6", false);
	assert_non_null(scene);
	assert_int_equal(scene->n_path, 1);
	assert_true(scene->path[0].yfov == 0.0f && scene->path[0].eye[2] == 3.0f);
	ts_scene_free(scene);
}

static void wrong_lines_of_a_path_are_refused(void **state)
{
	(void)state;
	static const char *const rows[][2] = {
		{"", "no keyframe"},
		{"# nothing\n\n", "no keyframe"},
		{"0 1,2,3 4,5,6\nnonsense", ":2: is not FRAME"},
		{"0 1,2,3", ":1: is not FRAME"},
		{"0 1,2,3 4,5", ":1: is not FRAME"},
		{"0 1,2 3,4,5", ":1: is not FRAME"},
		{"0 1,2,3 4,5,6 60 7", ":1: is not FRAME"},
		{"0 1,2,3 4,5,6x", ":1: is not FRAME"},
		{"-1 1,2,3 4,5,6", ":1: is not FRAME"},
		{"1.5 1,2,3 4,5,6", ":1: is not FRAME"},
		{"0 1,2,\n3 4,5,6", ":1: is not FRAME"},
		{"5 1,2,3 4,5,6\n5 1,2,3 4,5,7", ":2: its frame"},
		{"5 1,2,3 4,5,6\n# x\n4 1,2,3 4,5,7", ":3: its frame"},
		{"65536 1,2,3 4,5,6", ":1: frame 65535 is the last"},
		{"99999999999999999999999 1,2,3 4,5,6", ":1: frame 65535 is the last"},
		{"0 nan,2,3 4,5,6", ":1: is not FRAME"},
		{"0 1,2,3 4,inf,6", ":1: is not FRAME"},
		{"0 1,2,3e9 4,5,6", ":1: a coordinate"},
		{"0 1,2,3 1,2,3", ":1: the eye is its target"},
		{"0 1,2,3 4,5,6 0", ":1: the field of view"},
		{"0 1,2,3 4,5,6 nan", ":1: is not FRAME"},
		{"0 1,2,3 4,5,6 151", ":1: the field of view"},
		{"0 1,2,3 4,5,6 60\n1 1,2,3 4,5,6", ":2: either all"},
		{"0 1,2,3 4,5,6\n1 1,2,3 4,5,6 60", ":2: either all"},
		{"0 1,0,0 -1,0,0\n10 -1,0,0 1,0,0", "frame 5: the eye meets its target"},
		{"0 16777216,0,0 0,0,0\n1 16777216,0,0 0,0,0\n2 -16777216,0,0 0,0,0\n40 -16777216,0,0 0,0,1",
	     "the eye is beyond 16777216"},
	};
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
		ts_scene *scene = open_path(rows[i][0], false);
		if (scene != NULL) fail_msg("taken: %s", rows[i][0]);
		if (strstr(ts_error_message(), rows[i][1]) == NULL) fail_msg("%s: %s", rows[i][0], ts_error_message());
		assert_null(strchr(ts_error_message(), '\n'));
	}
}

static void a_path_too_large_is_refused(void **state)
{
	(void)state;
	size_t n = TS_PATH_MAX_BYTES + 1;
	char *blank = test_malloc(n + 1);
	memset(blank, '\n', n);
	blank[n] = 0;
	assert_null(open_path(blank, false));
	assert_non_null(strstr(ts_error_message(), "at most 4194304 are read"));
	test_free(blank);
	ts_scene *scene = open_path("0 1,2,3 4,5,6\n65535 2,2,3 4,5,6", false);
	assert_non_null(scene);
	assert_int_equal(scene->n_path, 65536);
	ts_scene_free(scene);
}

static void the_locale_changes_no_number(void **state)
{
	(void)state;
	comma_begin();
	ts_scene *scene = open_path("0 0.5,2,3 4,5,6 30.5", false);
	comma_end();
	if (scene == NULL) fail_msg("%s", ts_error_message());
	assert_true(scene->path[0].eye[0] == 0.5f);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(paths_follow_their_closed_form), cmocka_unit_test(the_eye_stands_still_before_and_behind),
		cmocka_unit_test(one_keyframe_is_a_path),         cmocka_unit_test(wrong_lines_of_a_path_are_refused),
		cmocka_unit_test(a_path_too_large_is_refused),    cmocka_unit_test(the_locale_changes_no_number),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}
