/* The eye: where it is, where it looks, and its projection, against double arithmetic. */
#include "scene/view.h"
#include "tests/model/test.h"

static ts_params params;
static ts_info room;
static ts_camera camera;

static int set_up(void **state)
{
	(void)state;
	ts_params_default(&params);
	room = (ts_info){.circles = 1,
	                 .box_min = {-3.0f, -1.0f, 10.0f},
	                 .box_max = {5.0f, 5.0f, 40.0f},
	                 .hall_min = {-3.0f, 10.0f},
	                 .hall_max = {5.0f, 40.0f}};
	camera = (ts_camera){.eye = {1.0f, 2.0f, 3.0f},
	                     .right = {0.0f, 0.0f, -1.0f},
	                     .up = {0.0f, 1.0f, 0.0f},
	                     .back = {1.0f, 0.0f, 0.0f},
	                     .yfov = 0.125f};
	return 0;
}

static ts_view view_of(u32 frame)
{
	ts_view view;
	params.frame = frame;
	ts_view_eye(&view, &room, &params);
	return view;
}

static double dot(const f32 *a, const f32 *b)
{
	return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static void check_orthonormal(const ts_view *v)
{
	const f32 *axes[3] = {v->right, v->up, v->back};
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) assert_true(fabs(dot(axes[i], axes[j]) - (i == j)) < 1e-6);
	ts_v3 cross = ts_cross(ts_load3(v->right), ts_load3(v->up));
	assert_true(ts_dot(cross, ts_load3(v->back)) > 0.99f);
}

static void axes_of_the_eye_are_orthonormal(void **state)
{
	(void)state;
	for (u32 frame = 0; frame < 240; frame++) {
		ts_view v = view_of(frame);
		check_orthonormal(&v);
		assert_true(v.right[1] == 0.0f && v.up[1] > 0.9f);
	}
}

static void the_eye_circles_on_its_ellipse(void **state)
{
	(void)state;
	const double factors[2] = {0.35, 0.9};
	for (u32 eye = TS_EYE_NEAR; eye <= TS_EYE_FAR; eye++) {
		params.eye_distance = eye;
		for (u32 frame = 0; frame < 240; frame++) {
			ts_view v = view_of(frame);
			double turn = 2.0 * 3.14159265358979323846 * frame / 240.0;
			assert_true(fabs((double)v.eye[0] - (1.0 + 4.0 * factors[eye] * cos(turn))) < 1e-5);
			assert_true(fabs((double)v.eye[2] - (25.0 + 15.0 * factors[eye] * sin(turn))) < 1e-5);
			assert_true(v.eye[1] > room.box_min[1] && v.eye[1] < room.box_max[1]);
		}
	}
}

/* The vertical axis through the middle of the box is in the middle column. */
static void the_eye_looks_at_the_middle(void **state)
{
	(void)state;
	for (u32 frame = 0; frame < 240; frame += 7) {
		ts_view v = view_of(frame);
		f32 d[3] = {1.0f - v.eye[0], 2.0f - v.eye[1], 25.0f - v.eye[2]};
		assert_true(fabs(dot(d, v.right)) < 1e-5);
		assert_true(-dot(d, v.back) > 1.0);
	}
}

static void a_turn_later_nothing_has_changed(void **state)
{
	(void)state;
	ts_view first = view_of(17), later = view_of(17 + 240);
	assert_memory_equal(&first, &later, sizeof first);
	later = view_of(18);
	assert_memory_not_equal(&first, &later, sizeof first);
}

static void field_of_view_sets_focal_length(void **state)
{
	(void)state;
	const f32 degrees[] = {1.0f, 30.0f, 60.0f, 90.0f, 150.0f};
	for (u32 i = 0; i < sizeof degrees / sizeof *degrees; i++) {
		params.eye_fov = degrees[i];
		ts_view v = view_of(0);
		double focal = params.height / (2.0 * tan((double)degrees[i] * 3.14159265358979323846 / 360.0));
		assert_true(fabs((double)v.focal / focal - 1.0) < 1e-5);
		assert_int_equal(v.width, params.width);
		assert_int_equal(v.height, params.height);
		assert_true(fabs((double)v.near * 1024.0 / sqrt(16.0 + 9.0 + 225.0) - 1.0) < 1e-6);
	}
}

static void a_named_camera_is_the_eye(void **state)
{
	(void)state;
	ts_view_choose(&room, &camera);
	ts_view v = view_of(5), w = view_of(99);
	assert_memory_equal(&v, &w, sizeof v);
	assert_memory_equal(v.eye, camera.eye, sizeof v.eye);
	assert_memory_equal(v.right, camera.right, sizeof v.right);
	assert_memory_equal(v.up, camera.up, sizeof v.up);
	assert_memory_equal(v.back, camera.back, sizeof v.back);
	assert_true(fabs((double)v.focal / (540.0 / tan(3.14159265358979323846 / 8.0)) - 1.0) < 1e-6);
	camera.yfov = 0.0f;
	ts_view_choose(&room, &camera);
	v = view_of(5);
	assert_true(fabs((double)v.focal / (540.0 / tan(3.14159265358979323846 / 6.0)) - 1.0) < 1e-6);
}

/* Twice as fast it is where it would be in the frame of twice the number; without turns it stands still. */
static void turns_multiply_the_frame(void **state)
{
	(void)state;
	for (params.eye_distance = TS_EYE_NEAR; params.eye_distance <= TS_EYE_OUTSIDE; params.eye_distance++) {
		for (u32 frame = 0; frame < 500; frame++) {
			params.eye_turns = 2;
			ts_view twice = view_of(frame);
			params.eye_turns = 0;
			ts_view still = view_of(frame);
			params.eye_turns = 1;
			ts_view far = view_of(2 * frame), first = view_of(0);
			assert_memory_equal(&twice, &far, sizeof far);
			assert_memory_equal(&still, &first, sizeof first);
		}
	}
}

/* The eye keeps to a hall that is smaller than the box and beside its middle; near is the box's. */
static void the_eye_keeps_to_the_hall(void **state)
{
	(void)state;
	f32 near = view_of(0).near;
	room.hall_min[0] = 1.0f;
	room.hall_max[0] = 4.0f;
	room.hall_min[1] = 12.0f;
	room.hall_max[1] = 14.0f;
	for (params.eye_distance = TS_EYE_NEAR; params.eye_distance <= TS_EYE_FAR; params.eye_distance++) {
		for (u32 frame = 0; frame < 240; frame++) {
			ts_view v = view_of(frame);
			double x = ((double)v.eye[0] - 2.5) / 1.5, z = (double)v.eye[2] - 13.0;
			assert_true(fabs(sqrt(x * x + z * z) - (params.eye_distance == TS_EYE_NEAR ? 0.35 : 0.9)) < 1e-5);
			assert_true(v.near == near);
		}
	}
}

/* Boxes without thickness, and a point: still a view. */
static void flat_boxes_still_have_a_view(void **state)
{
	(void)state;
	for (u32 flat = 1; flat < 8; flat++) {
		set_up(NULL);
		for (u32 k = 0; k < 3; k++)
			if (flat >> k & 1) room.box_max[k] = room.box_min[k];
		for (u32 k = 0; k < 2; k++) room.hall_max[k] = room.box_max[2 * k];
		ts_v3 box = ts_view_box(&room).half, hall = ts_view_hall(&room).half;
		assert_true(box.x > 0.0f && box.y > 0.0f && box.z > 0.0f);
		assert_memory_equal(&hall, &box, sizeof hall);
		for (u32 frame = 0; frame < 240; frame += 20) {
			ts_view v = view_of(frame);
			check_orthonormal(&v);
			assert_true(v.near > 0.0f);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup(axes_of_the_eye_are_orthonormal, set_up),
		cmocka_unit_test_setup(the_eye_circles_on_its_ellipse, set_up),
		cmocka_unit_test_setup(the_eye_looks_at_the_middle, set_up),
		cmocka_unit_test_setup(a_turn_later_nothing_has_changed, set_up),
		cmocka_unit_test_setup(turns_multiply_the_frame, set_up),
		cmocka_unit_test_setup(field_of_view_sets_focal_length, set_up),
		cmocka_unit_test_setup(a_named_camera_is_the_eye, set_up),
		cmocka_unit_test_setup(the_eye_keeps_to_the_hall, set_up),
		cmocka_unit_test_setup(flat_boxes_still_have_a_view, set_up),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
