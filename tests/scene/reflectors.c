/* The added reflectors: their mean size, that they stay in the scene and apart, and what they are made of. */
#include <unistd.h>
#include "kernels/base/pose.h"
#include "scene/sources.h"
#include "scene/view.h"
#include "tests/model/test.h"
#include "tests/scene/folder.h"
#include "tests/status.h"
#include "tests/whole.h"

static ts_params params;

static int set_up(void **state)
{
	(void)state;
	ts_params_default(&params);
	return 0;
}

/* A scene whose box is x by y by z with a corner at (-7, 2, 30), with a camera "door" that looks along -x. */
static ts_scene *room(f32 x, f32 y, f32 z, const char *camera)
{
	ts_build *build = ts_build_new("room");
	assert_non_null(build);
	const f32 corners[3][3] = {{-7.0f, 2.0f, 30.0f}, {-7.0f + x, 2.0f + y, 30.0f}, {-7.0f, 2.0f, 30.0f + z}};
	for (u32 i = 0; i < 3; i++) {
		ts_vertex v = {.position = {corners[i][0], corners[i][1], corners[i][2]}};
		ts_build_vertex(build, &v);
	}
	ts_build_triangle(build, 0, 1, 2, TS_NONE);
	ts_camera door = {.name = "door",
	                  .eye = {-7.0f + 0.97f * x, 2.0f + 0.4f * y, 30.0f + 0.4f * z},
	                  .right = {0.0f, 0.0f, -1.0f},
	                  .up = {0.0f, 1.0f, 0.0f},
	                  .back = {1.0f, 0.0f, 0.0f},
	                  .yfov = 0.125f};
	ts_build_camera(build, &door);
	ts_reflectors_add(build, &params, camera, NULL);
	ts_scene *scene;
	assert_int_equal(ts_build_finish(build, &params, camera, &scene), TS_OK);
	assert_int_equal(scene->info.n_reflectors, params.reflectors_count);
	assert_int_equal(scene->n_objects, params.reflectors_count + 1);
	return scene;
}

/* Greatest distance of an object's vertex from its origin. */
static double radius_of(const ts_scene *scene, u32 object)
{
	const ts_object *o = &scene->objects[object];
	f32 greatest = 0.0f;
	for (u32 i = 0; i < o->n_vertices; i++)
		greatest = ts_max(greatest, ts_length(ts_load3(scene->vertices[o->first_vertex + i].position)));
	return (double)greatest;
}

static double along(const f32 axis[3], ts_v3 d)
{
	return (double)axis[0] * (double)d.x + (double)axis[1] * (double)d.y + (double)axis[2] * (double)d.z;
}

/* Mean of 2 f r / z over the reflectors at frame 0; of those out of the picture by the distance. */
static double mean_diameter(const ts_scene *scene)
{
	ts_view eye;
	ts_params first = params;
	first.frame = 0;
	ts_view_eye(&eye, &scene->info, &first);
	double sum = 0.0, f = (double)eye.focal;
	for (u32 i = 1; i < scene->n_objects; i++) {
		if (scene->objects[i].period == 0) continue; /* the file's own */
		ts_v3 d = ts_sub(ts_k_pose(&scene->objects[i], 0).centre, ts_load3(eye.eye));
		double z = -along(eye.back, d), x = f * along(eye.right, d) / z, y = f * along(eye.up, d) / z;
		bool seen = z > 0.0 && fabs(x) <= eye.width * 0.5 && fabs(y) <= eye.height * 0.5;
		const f32 offset[3] = {d.x, d.y, d.z};
		sum += 2.0 * f * radius_of(scene, i) / (seen ? z : sqrt(along(offset, d)));
	}
	return sum / params.reflectors_count;
}

static void check_size(f32 x, f32 y, f32 z, const char *camera)
{
	ts_scene *scene = room(x, y, z, camera);
	double mean = mean_diameter(scene);
	if (fabs(mean / (double)params.reflectors_px - 1.0) > 1e-4)
		fail_msg("%u reflectors in %g x %g x %g: %g px, expected %g", params.reflectors_count, (double)x, (double)y,
		         (double)z, mean, (double)params.reflectors_px);
	assert_int_equal(scene->n_notes, 0);
	ts_scene_free(scene);
}

static void mirrors_have_the_mean_size_asked_for(void **state)
{
	(void)state;
	const u32 counts[] = {1, 2, 10, 37, 100};
	for (u32 i = 0; i < sizeof counts / sizeof *counts; i++) {
		params.reflectors_count = counts[i];
		for (params.eye_distance = TS_EYE_NEAR; params.eye_distance <= TS_EYE_FAR; params.eye_distance++) {
			check_size(30.0f, 12.0f, 18.0f, NULL);
			check_size(8.0f, 3.0f, 8.0f, NULL);
			check_size(8.0f, 1.0f, 8.0f, NULL);
		}
		check_size(30.0f, 12.0f, 18.0f, "door");
	}
	params.reflectors_count = 10;
	params.frame = 77;
	check_size(30.0f, 12.0f, 18.0f, NULL);
	params.reflectors_px = 40.0f;
	check_size(30.0f, 12.0f, 18.0f, NULL);
}

/* 10 mirrors of half the default size in a picture of half the default size: all have room in these files. */
static void mirrors_have_their_mean_size_in_files(void **state)
{
	(void)state;
	static const char *const files[] = {
		"instances.gltf",     "room.gltf",       "cornell_box_original.glb", "vr_gallery.glb",
		"bunny.glb",          "dragon_80k.glb",  "armadillo_86k.glb",        "damaged_helmet.glb",
		"modern_hall.glb",    "suzanne.glb",     "cornell_box_sphere.glb",   "sibenik.glb",
		"fireplace_room.glb", "sponza.glb",      "breakfast_room.glb",       "country_kitchen_partial.glb",
		"chess_board.glb",    "pbr_spheres.glb", "dragon_scans.glb",
	};
	char path[4096];
	u32 n = 0, most = whole_or(sizeof files / sizeof *files, 9);
	params.width = 960;
	params.height = 540;
	params.reflectors_px = 57.5f;
	for (u32 i = 0; i < most; i++) {
		ts_scene *scene;
		snprintf(path, sizeof path, "%s/%s", i < 2 ? "scenes" : scenes_folder(), files[i]);
		if (access(path, R_OK) != 0) continue;
		n++;
		if (ts_scene_load(&scene, path, &params, &(ts_scene_options){0}) != TS_OK) fail_msg("%s", ts_error_message());
		double mean = mean_diameter(scene);
		if (fabs(mean / 57.5 - 1.0) > 1e-4) fail_msg("%s: %g px, expected 57.5", files[i], mean);
		ts_scene_free(scene);
	}
	assert_true(n >= 2);
}

static void check_inside(const ts_scene *scene, const ts_object *object, u32 frame)
{
	const f32 rounding = 1e-5f;
	ts_pose pose = ts_k_pose(object, frame);
	for (u32 i = 0; i < object->n_vertices; i++) {
		ts_v3 p = ts_k_pose_point(&pose, ts_load3(scene->vertices[object->first_vertex + i].position));
		const f32 place[3] = {p.x, p.y, p.z};
		for (u32 k = 0; k < 3; k++)
			assert_true(place[k] >= scene->info.box_min[k] - rounding && place[k] <= scene->info.box_max[k] + rounding);
	}
}

/* For a whole turn and every shape, with bobbing and spinning, in a high room and in one that barely holds them. */
static void mirrors_stay_inside_for_a_whole_turn(void **state)
{
	(void)state;
	const f32 heights[2] = {6.0f, 1.05f};
	params.reflectors_count = 50;
	for (u32 low = 0; low < 2; low++) {
		params.reflectors_shape = low ? TS_SHAPE_SPHERE : TS_SHAPE_MIXED;
		ts_scene *scene = room(20.0f, heights[low], 14.0f, NULL);
		assert_true(low == 0 || radius_of(scene, 1) > 0.43 * (double)heights[1]);
		for (u32 frame = 0; frame < 240; frame += 3)
			for (u32 i = 1; i < scene->n_objects; i++) check_inside(scene, &scene->objects[i], frame);
		ts_scene_free(scene);
	}
}

/* Paths within the inner 60 %, golden phases, one turn in 240 frames. */
static void mirrors_turn_once_in_240_frames(void **state)
{
	(void)state;
	params.reflectors_count = 50;
	ts_scene *scene = room(20.0f, 6.0f, 14.0f, NULL);
	for (u32 i = 0; i < 50; i++) {
		const ts_object *o = &scene->objects[i + 1];
		assert_int_equal(o->reflector, i);
		assert_int_equal(o->period, 240);
		assert_true(fabs((double)o->phase - fmod(0.618034 * i, 1.0)) < 1e-5);
		assert_true(o->axis[0] > 0.0f && o->axis[0] <= 6.0f && o->axis[1] > 0.0f && o->axis[1] <= 4.2f);
		assert_float_equal(o->centre[0], 3.0f, 1e-5f);
		assert_float_equal(o->centre[2], 37.0f, 1e-5f);
		assert_true(o->spin == ts_floor(o->spin));
	}
	ts_scene_free(scene);
}

/* No two of ten reflectors meet, and none comes over the eye, at any frame. */
static void no_two_mirrors_meet(void **state)
{
	(void)state;
	for (params.eye_distance = TS_EYE_NEAR; params.eye_distance <= TS_EYE_FAR; params.eye_distance++) {
		params.frame = 0;
		ts_scene *scene = room(20.0f, 6.0f, 14.0f, NULL);
		f32 radius = (f32)radius_of(scene, 1);
		for (; params.frame < 240; params.frame++) {
			ts_view eye;
			ts_view_eye(&eye, &scene->info, &params);
			for (u32 i = 1; i < scene->n_objects; i++) {
				ts_v3 centre = ts_k_pose(&scene->objects[i], params.frame).centre;
				assert_true(ts_length(ts_sub(centre, ts_load3(eye.eye))) > radius * 1.5f);
				for (u32 j = 1; j < i; j++) {
					ts_v3 other = ts_k_pose(&scene->objects[j], params.frame).centre;
					if (ts_length(ts_sub(centre, other)) <= radius * 2.0f)
						fail_msg("reflectors %u and %u meet in frame %u, eye %u", j, i, params.frame,
						         params.eye_distance);
				}
			}
		}
		ts_scene_free(scene);
	}
}

/* However many there are, none comes near the eye's ellipse where the eye is. */
static void no_mirror_comes_near_the_eye(void **state)
{
	(void)state;
	params.eye_distance = TS_EYE_NEAR;
	params.reflectors_count = 200;
	ts_scene *scene = room(20.0f, 6.0f, 14.0f, NULL);
	for (u32 i = 1; i < scene->n_objects; i++) {
		ts_v3 p = ts_k_pose(&scene->objects[i], 0).centre;
		double x = ((double)p.x - 3.0) / 10.0 - 0.35, z = ((double)p.z - 37.0) / 7.0;
		assert_true(sqrt(x * x + z * z) > 0.1599);
	}
	ts_scene_free(scene);
}

/* Between a tenth and six tenths of the room's height, evenly: about as many in each fifth of that. */
static void mirrors_stand_evenly_in_height(void **state)
{
	(void)state;
	u32 fifths[5] = {0};
	params.reflectors_count = 50;
	params.reflectors_px = 20.0f;
	ts_scene *scene = room(20.0f, 6.0f, 14.0f, NULL);
	for (u32 i = 1; i < scene->n_objects; i++) {
		double up = ((double)scene->objects[i].centre[1] - 2.0) / 6.0;
		assert_true(up >= 0.0999 && up < 0.6);
		fifths[(u32)((up - 0.0999) * 10.0)]++;
	}
	for (u32 i = 0; i < 5; i++) assert_in_range(fifths[i], 8, 12);
	ts_scene_free(scene);
}

/* At least two thirds of the reflectors are in the picture of frame 0. */
static void two_thirds_of_mirrors_are_in_sight(void **state)
{
	(void)state;
	params.reflectors_count = 30;
	ts_scene *scene = room(20.0f, 6.0f, 14.0f, NULL);
	ts_view eye;
	ts_view_eye(&eye, &scene->info, &params);
	u32 seen = 0;
	for (u32 i = 1; i < scene->n_objects; i++) {
		ts_v3 d = ts_sub(ts_k_pose(&scene->objects[i], 0).centre, ts_load3(eye.eye));
		double z = -along(eye.back, d), f = (double)eye.focal;
		seen += z > 0.0 && fabs(f * along(eye.right, d)) <= z * eye.width * 0.5 &&
		        fabs(f * along(eye.up, d)) <= z * eye.height * 0.5;
	}
	assert_in_range(seen, 20, 30);
	ts_scene_free(scene);
}

/* A file's camera stands still: it sees every mirror in frame 0. */
static void a_standing_eye_sees_every_mirror(void **state)
{
	(void)state;
	params.reflectors_count = 5;
	ts_scene *scene;
	ts_view eye;
	require(ts_scene_load(&scene, "scenes/room.gltf", &params, &(ts_scene_options){.camera = "door"}));
	ts_view_eye(&eye, &scene->info, &params);
	u32 n = 0;
	for (u32 i = 1; i < scene->n_objects; i++) {
		f32 depth;
		if (scene->objects[i].reflector == TS_NONE || scene->objects[i].period == 0) continue;
		assert_true(ts_view_holds(&eye, ts_k_pose(&scene->objects[i], 0).centre, 0.0f, &depth));
		n++;
	}
	assert_int_equal(n, 5);
	ts_scene_free(scene);
}

static void mirrors_are_smooth_metal(void **state)
{
	(void)state;
	ts_scene *scene = room(20.0f, 6.0f, 14.0f, NULL);
	assert_int_equal(scene->n_triangles_file, 1);
	for (u32 i = 1; i < scene->n_triangles; i++) {
		const ts_material *m = &scene->materials[scene->triangles[i].material];
		assert_true(m->metallic == 1.0f && m->roughness == 0.05f);
		for (u32 k = 0; k < 3; k++) assert_true(m->base[k] > 0.5f && m->base[k] <= 1.0f);
	}
	ts_scene_free(scene);
}

static void mixed_shapes_come_in_turns(void **state)
{
	(void)state;
	params.reflectors_count = 1;
	u32 count[TS_SHAPE_MIXED];
	for (params.reflectors_shape = 0; params.reflectors_shape < TS_SHAPE_MIXED; params.reflectors_shape++) {
		ts_scene *scene = room(20.0f, 6.0f, 14.0f, NULL);
		count[params.reflectors_shape] = scene->objects[1].n_vertices;
		ts_scene_free(scene);
	}
	params.reflectors_count = 9;
	ts_scene *scene = room(20.0f, 6.0f, 14.0f, NULL);
	for (u32 i = 0; i < 9; i++) assert_int_equal(scene->objects[i + 1].n_vertices, count[i % TS_SHAPE_MIXED]);
	ts_scene_free(scene);
}

static void mirrors_are_the_same_every_time(void **state)
{
	(void)state;
	params.reflectors_shape = TS_SHAPE_MIXED;
	ts_scene *a = room(20.0f, 6.0f, 14.0f, NULL), *b = room(20.0f, 6.0f, 14.0f, NULL);
	assert_int_equal(a->n_vertices, b->n_vertices);
	assert_memory_equal(a->vertices, b->vertices, a->n_vertices * sizeof *a->vertices);
	assert_memory_equal(a->objects, b->objects, a->n_objects * sizeof *a->objects);
	ts_scene_free(a);
	ts_scene_free(b);
}

static void no_mirrors_add_nothing(void **state)
{
	(void)state;
	params.reflectors_count = 0;
	ts_scene *scene = room(20.0f, 6.0f, 14.0f, NULL);
	assert_int_equal(scene->n_triangles, 1);
	assert_int_equal(scene->n_materials, 1);
	ts_scene_free(scene);
}

/* Reflectors too large for the room are made smaller, and a note says so. */
static void mirrors_too_large_are_made_smaller(void **state)
{
	(void)state;
	params.reflectors_px = 4096.0f;
	ts_scene *scene = room(20.0f, 6.0f, 14.0f, NULL);
	assert_true(radius_of(scene, 1) <= 2.46);
	assert_int_equal(scene->n_notes, 1);
	assert_non_null(strstr(scene->notes[0], "reflectors.px=4096"));
	ts_scene_free(scene);
}

/* A wall, a floor and a needle can hold reflectors too. */
static void flat_scenes_hold_mirrors_too(void **state)
{
	(void)state;
	const f32 boxes[3][3] = {{20.0f, 6.0f, 0.0f}, {20.0f, 0.0f, 14.0f}, {0.0f, 6.0f, 0.0f}};
	for (u32 i = 0; i < 3; i++) {
		ts_scene *scene = room(boxes[i][0], boxes[i][1], boxes[i][2], NULL);
		assert_true(radius_of(scene, 1) > 0.0);
		ts_scene_free(scene);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup(mirrors_have_the_mean_size_asked_for, set_up),
		cmocka_unit_test_setup(mirrors_have_their_mean_size_in_files, set_up),
		cmocka_unit_test_setup(mirrors_stay_inside_for_a_whole_turn, set_up),
		cmocka_unit_test_setup(mirrors_turn_once_in_240_frames, set_up),
		cmocka_unit_test_setup(no_two_mirrors_meet, set_up),
		cmocka_unit_test_setup(no_mirror_comes_near_the_eye, set_up),
		cmocka_unit_test_setup(mirrors_stand_evenly_in_height, set_up),
		cmocka_unit_test_setup(two_thirds_of_mirrors_are_in_sight, set_up),
		cmocka_unit_test_setup(mirrors_are_smooth_metal, set_up),
		cmocka_unit_test_setup(mixed_shapes_come_in_turns, set_up),
		cmocka_unit_test_setup(mirrors_are_the_same_every_time, set_up),
		cmocka_unit_test_setup(no_mirrors_add_nothing, set_up),
		cmocka_unit_test_setup(mirrors_too_large_are_made_smaller, set_up),
		cmocka_unit_test_setup(flat_scenes_hold_mirrors_too, set_up),
		cmocka_unit_test_setup(a_standing_eye_sees_every_mirror, set_up),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
