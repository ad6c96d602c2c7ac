/* Embree alone, of the off-screen views of a run: every texel has a ray, and the rays go through the texels. */
#include <math.h>
#include "methods/stages.h"
#include "tests/model/test.h"
#include "tests/truth/world.h"
#include "truth/bare.h"

static world *room_new(void)
{
	world *w = malloc(sizeof *w);
	assert_non_null(w);
	world_begin(w);
	world_room(w, ts_v3_make(-1, -1, -1), ts_v3_make(1, 1, 1), TWO_SIDED, 0);
	world_pose(w);
	return w;
}

static void end(world *w, ts_bare *bare)
{
	ts_bare_free(bare);
	ts_run_end(&w->run);
	free(w);
}

/* Sides that are no multiple of a packet's; a cube out of sight has no rays. */
static void every_texel_of_cubes_has_a_ray(void **state)
{
	(void)state;
	for (u32 side = 1; side <= 9; side++) {
		world *w = room_new();
		ts_bare *bare;
		ts_face *cubes = ts_frame_make1(&w->run.frame, TS_B_cube_size_face, 3);
		for (u32 i = 0; i < 3; i++)
			cubes[i] = (ts_face){.n = i == 1 ? 0 : side, .centre = {0.5f * (f32)i - 0.5f, 0, 0}, .near = 0.001f};
		cubes[2].near = 10; /* all walls are before its near plane */
		w->run.plan.units = 3;
		assert_int_equal(ts_bare_new(&bare, &w->run), TS_OK);
		assert_int_equal(ts_bare_n_rays(bare), 2 * 6 * side * side);
		for (u32 threads = 1; threads <= 2; threads++) {
			ts_bare_cast(bare, threads);
			assert_int_equal(ts_bare_n_hits(bare), 6 * side * side);
		}
		end(w, bare);
	}
}

/* Walls one away from the middle of a face, and farther away from its other texels: those within the reflector that the
 * cube is of are not hit. */
static void walls_within_the_reflector_are_not_hit(void **state)
{
	(void)state;
	enum { SIDE = 9 };
	static const f32 radius[] = {0, 0.9f, 1.2f, 1.5f, 1.8f};
	for (u32 k = 0; k < sizeof radius / sizeof *radius; k++) {
		world *w = room_new();
		ts_bare *bare;
		u32 n_beyond = 0;
		ts_face *cube = ts_frame_make1(&w->run.frame, TS_B_cube_size_face, 1);
		*cube = (ts_face){.n = SIDE, .radius = radius[k], .near = 0.001f};
		w->run.plan.units = 1;
		for (i32 i = 0; i < SIDE * SIDE; i++) {
			double u = (2 * (i % SIDE) + 1 - SIDE) / (double)SIDE, v = (2 * (i / SIDE) + 1 - SIDE) / (double)SIDE;
			n_beyond += sqrt(1 + u * u + v * v) > (double)radius[k];
		}
		assert_int_equal(ts_bare_new(&bare, &w->run), TS_OK);
		ts_bare_cast(bare, 2);
		assert_int_equal(ts_bare_n_hits(bare), 6 * n_beyond);
		end(w, bare);
	}
}

/* A view whose field is twice as wide as a wall behind a hole: those of its rays hit that go there. */
static void rays_hit_the_wall_they_reach(void **state)
{
	(void)state;
	world *w = malloc(sizeof *w);
	ts_bare *bare;
	assert_non_null(w);
	world_begin(w);
	world_quad(w, ts_v3_make(-1, -1, -2), ts_v3_make(1, -1, -2), ts_v3_make(1, 1, -2), ts_v3_make(-1, 1, -2), TWO_SIDED,
	           0);
	world_pose(w);
	ts_offscreen *views = ts_frame_make1(&w->run.frame, TS_B_offscreen_view, 2);
	views[0] = (ts_offscreen){
		.focal = 8, .right = {1, 0, 0}, .up = {0, 1, 0}, .back = {0, 0, 1}, .width = 16, .height = 20, .near = 0.1f};
	views[1] = views[0];
	views[1].orthographic = 1;
	assert_int_equal(ts_bare_new(&bare, &w->run), TS_OK);
	assert_int_equal(ts_bare_n_rays(bare), 2 * 16 * 20);
	ts_bare_cast(bare, 2);
	assert_int_equal(ts_bare_n_hits(bare), 8 * 8 + 16 * 16);
	ts_truth *truth;
	assert_int_equal(ts_truth_new(&truth, &w->run), TS_OK);
	ts_bare_cast_truth(bare, truth, 2);
	assert_int_equal(ts_truth_cost_of(truth).rays, 2 * 16 * 20);
	ts_truth_free(truth);
	end(w, bare);
}

/* Views of any sides: the truth casts as many rays as Embree alone, none of them beside the view. */
static void the_truth_casts_as_many_rays(void **state)
{
	(void)state;
	static const u32 sides[][2] = {{1, 1}, {4, 4}, {3, 70}, {67, 5}, {64, 4}, {65, 3}, {130, 6}};
	for (u32 k = 0; k < sizeof sides / sizeof *sides; k++) {
		world *w = room_new();
		ts_bare *bare;
		ts_truth *truth;
		ts_offscreen *view = ts_frame_make1(&w->run.frame, TS_B_offscreen_view, 1);
		*view = (ts_offscreen){.focal = 8,
		                       .right = {1, 0, 0},
		                       .up = {0, 1, 0},
		                       .back = {0, 0, 1},
		                       .width = sides[k][0],
		                       .height = sides[k][1],
		                       .near = 0.001f};
		assert_int_equal(ts_bare_new(&bare, &w->run), TS_OK);
		assert_int_equal(ts_truth_new(&truth, &w->run), TS_OK);
		u64 n = (u64)sides[k][0] * sides[k][1];
		ts_bare_cast(bare, 1);
		ts_bare_cast_truth(bare, truth, 1);
		assert_true(ts_bare_n_rays(bare) == n && ts_bare_n_hits(bare) == n);
		assert_int_equal(ts_truth_cost_of(truth).rays, n);
		ts_truth_free(truth);
		end(w, bare);
	}
}

/* More views than memory could hold. */
static void too_many_views_are_refused(void **state)
{
	(void)state;
	world *w = room_new();
	ts_bare *bare;
	ts_frame_make1(&w->run.frame, TS_B_offscreen_view, 1);
	w->run.frame.buffer[TS_B_offscreen_view].n = 1ull << 60;
	assert_int_equal(ts_bare_new(&bare, &w->run), TS_ERROR);
	assert_null(bare);
	assert_non_null(strstr(ts_error_message(), "Embree's views: "));
	w->run.frame.buffer[TS_B_offscreen_view].n = 1;
	end(w, bare);
}

static void a_run_without_views_is_refused(void **state)
{
	(void)state;
	world *w = room_new();
	ts_bare *bare;
	assert_int_equal(ts_bare_new(&bare, &w->run), TS_ERROR);
	assert_null(bare);
	end(w, bare);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_texel_of_cubes_has_a_ray), cmocka_unit_test(walls_within_the_reflector_are_not_hit),
		cmocka_unit_test(rays_hit_the_wall_they_reach),   cmocka_unit_test(the_truth_casts_as_many_rays),
		cmocka_unit_test(too_many_views_are_refused),     cmocka_unit_test(a_run_without_views_is_refused)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
