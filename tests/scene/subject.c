/* A room beside an open place is found, with its own floor and ceiling; and where something stands on the circle of its
 * eye the hall is drawn in until the eye is free. */
#include "kernels/base/scene.h"
#include "scene/build.h"
#include "scene/sources.h"
#include "scene/view.h"
#include "tests/model/test.h"

static ts_params params;

static void quad(ts_build *build, ts_v3 a, ts_v3 ab, ts_v3 ad)
{
	u32 first = ts_build_peek(build)->n_vertices;
	const ts_v3 corner[4] = {a, ts_add(a, ab), ts_add(ts_add(a, ab), ad), ts_add(a, ad)};
	for (u32 k = 0; k < 4; k++) {
		ts_vertex v = {.position = {corner[k].x, corner[k].y, corner[k].z}};
		ts_build_vertex(build, &v);
	}
	ts_build_triangle(build, first, first + 1, first + 2, TS_NONE);
	ts_build_triangle(build, first, first + 2, first + 3, TS_NONE);
}

/* Six sides of a box: those of a room look inwards, those of a thing outwards. */
static void box(ts_build *build, ts_v3 low, ts_v3 high, bool room)
{
	ts_v3 x = ts_v3_make(high.x - low.x, 0, 0), y = ts_v3_make(0, high.y - low.y, 0);
	ts_v3 z = ts_v3_make(0, 0, high.z - low.z);
	const ts_v3 sides[6][3] = {{low, x, y},
	                           {low, y, z},
	                           {low, z, x},
	                           {high, ts_neg(y), ts_neg(x)},
	                           {high, ts_neg(z), ts_neg(y)},
	                           {high, ts_neg(x), ts_neg(z)}};
	for (u32 k = 0; k < 6; k++) quad(build, sides[k][0], sides[k][room ? 1 : 2], sides[k][room ? 2 : 1]);
}

static const ts_v3 low = {-30, 0, -8}, high = {-6, 8, 8};

/* The room, and far from it a tower; `post`: what stands in the room, or NULL. */
static ts_info found(const ts_v3 *post)
{
	ts_scene *scene;
	ts_params_default(&params);
	ts_build *build = ts_build_new("house");
	assert_non_null(build);
	box(build, low, high, true);
	box(build, ts_v3_make(28, 0, -8), ts_v3_make(30, 30, 8), false);
	if (post != NULL) {
		ts_v3 half = ts_v3_make(0.25f, 1, 0.25f);
		box(build, ts_sub(*post, half), ts_add(*post, half), false);
	}
	assert_int_equal(ts_build_finish(build, &params, NULL, &scene), TS_OK);
	ts_rays *rays = ts_rays_new(scene);
	assert_non_null(rays);
	ts_info info = scene->info;
	ts_subject_find(&info, rays, scene, &params);
	ts_rays_free(rays);
	ts_scene_free(scene);
	return info;
}

static void a_room_beside_the_open_is_found(void **state)
{
	(void)state;
	ts_info info = found(NULL);
	const f32 right[6] = {low.x, low.y, low.z, high.x, high.y, high.z};
	for (u32 k = 0; k < 3; k++) {
		assert_float_equal(info.box_min[k], right[k], 1e-3);
		assert_float_equal(info.box_max[k], right[3 + k], 1e-3);
	}
	for (u32 axis = 0; axis < 2; axis++) {
		f32 middle = 0.5f * (right[2 * axis] + right[3 + 2 * axis]), half = right[3 + 2 * axis] - middle;
		assert_float_equal(info.hall_min[axis], middle - 0.95f * half, 1e-3);
		assert_float_equal(info.hall_max[axis], middle + 0.95f * half, 1e-3);
	}
	assert_int_equal(info.circles, TS_CIRCLES_ROOM);
}

static ts_v3 eye_of(const ts_info *info)
{
	ts_view view;
	ts_view_eye(&view, info, &params);
	return ts_load3(view.eye);
}

static void the_hall_shrinks_around_a_post(void **state)
{
	(void)state;
	ts_info free_room = found(NULL);
	ts_v3 post = eye_of(&free_room);
	ts_info info = found(&post);
	ts_v3 eye = eye_of(&info);
	assert_int_equal(info.circles, TS_CIRCLES_ROOM);
	for (u32 axis = 0; axis < 2; axis++) {
		assert_true(info.hall_min[axis] > free_room.hall_min[axis] && info.hall_max[axis] < free_room.hall_max[axis]);
		assert_true(info.hall_max[axis] - info.hall_min[axis] > 1);
	}
	assert_true(eye.x > low.x && eye.x < high.x && eye.z > low.z && eye.z < high.z);
	assert_true(ts_abs(eye.x - post.x) > 0.25f || ts_abs(eye.z - post.z) > 0.25f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(a_room_beside_the_open_is_found),
	                                   cmocka_unit_test(the_hall_shrinks_around_a_post)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
