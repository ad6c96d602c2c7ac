/* What the machine allows: that the loops measured do what they say. Times themselves are of the machine. */
#include <math.h>
#include <time.h>
#include "study/speed_limits.h"
#include "tests/model/test.h"
#include "tests/truth/world.h"

/* In place of the library's: once it ticks, each call of a thread is a second later. */
static bool ticks;
double ts_seconds(void)
{
	static _Thread_local double ticked;
	struct timespec now;
	if (ticks) return ++ticked;
	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void limits_of_memory_are_measured(void **state)
{
	(void)state;
	double small, large, stream;
	double begin = ts_seconds();
	assert_int_equal(ts_limit_minima(&small, 1 << 16, 1), TS_OK);
	assert_true(small * (ts_seconds() - begin) >= 1 << 24); /* so many are offered, and more is done beside */
	assert_int_equal(ts_limit_minima(&large, 1 << 27, 2), TS_OK);
	assert_int_equal(ts_limit_stream(&stream, 2), TS_OK);
	assert_true(isfinite(small) && isfinite(large) && isfinite(stream));
	assert_true(small > 1e6 && large > 1e5 && stream > 1e7);
}

/* In one second: what one thread offers, and what all threads read and write in four passes. */
static void limits_count_what_is_offered_and_moved(void **state)
{
	(void)state;
	for (u32 threads = 1; threads <= 2; threads++) {
		double minima, stream;
		ticks = true;
		ts_status status = ts_limit_minima(&minima, 1 << 16, threads);
		if (status == TS_OK) status = ts_limit_stream(&stream, threads);
		ticks = false;
		assert_int_equal(status, TS_OK);
		assert_true(minima == 1 << 24 && stream == 4.0 * 2 * 8 * (1 << 24));
	}
}

enum { SIDE = 8, POINTS = 100000, HALF = 2 }; /* HALF: of the width of the room */

/* The triangle lies in the wall that a face looks at: +x, -x, +y, -y, +z, -z. */
static bool is_of_face(const world *w, u32 triangle, u32 face)
{
	for (u32 k = 0; k < 3; k++) {
		f32 at = w->vertices[w->triangles[triangle].vertex[k]].position[face / 2];
		if (at != (face % 2 == 0 ? HALF : -HALF)) return false;
	}
	return true;
}

/* A cube in the middle of a room: every texel has a point, on the wall of its own face, at the wall's depth. */
static void every_texel_of_a_room_is_drawn(void **state)
{
	(void)state;
	world *w = malloc(sizeof *w);
	assert_non_null(w);
	world_begin(w);
	world_room(w, ts_v3_make(-HALF, -HALF, -HALF), ts_v3_make(HALF, HALF, HALF), ONE_SIDED, 0);
	world_pose(w);
	ts_face *cube = ts_frame_make1(&w->run.frame, TS_B_cube_size_face, 2);
	cube[0] = (ts_face){.n = SIDE, .near = 0.001f, .object = TS_NONE};
	cube[1] = (ts_face){.n = 0, .offset = 6 * SIDE * SIDE, .object = TS_NONE};
	w->run.plan.units = 2;
	ts_limit_points points = {.n = 0};
	assert_int_equal(ts_limit_points_place(&points, &w->run, POINTS), TS_OK);
	assert_true(points.n >= POINTS && points.n < POINTS + 256);
	for (u32 threads = 1; threads <= 2; threads++) {
		memset(points.texels, 0, 6 * SIDE * SIDE * sizeof *points.texels);
		ts_limit_points_draw(&points, threads);
		for (u32 i = 0; i < 6 * SIDE * SIDE; i++) {
			assert_true((u32)points.texels[i] < w->scene.n_triangles);
			assert_true(is_of_face(w, (u32)points.texels[i], i / (SIDE * SIDE)));
			assert_float_equal(ts_u2f((u32)(points.texels[i] >> 32)), HALF, 1e-6);
		}
	}
	ts_limit_points_free(&points);
	assert_null(points.texels);
	ts_run_end(&w->run);
	free(w);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(limits_of_memory_are_measured),
	                                   cmocka_unit_test(limits_count_what_is_offered_and_moved),
	                                   cmocka_unit_test(every_texel_of_a_room_is_drawn)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
