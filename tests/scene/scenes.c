/* The files in scenes/, as scenes/README.md describes them. */
#include "kernels/base/texture.h"
#include "scene/scene.h"
#include "tests/model/test.h"

static ts_scene *open_scene(const char *path, u32 reflectors, const ts_scene_options *options)
{
	ts_params params;
	ts_scene *scene;
	ts_params_default(&params);
	params.reflectors_count = reflectors;
	if (ts_scene_load(&scene, path, &params, options) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

static ts_v3 corner(const ts_scene *scene, u32 triangle, u32 k)
{
	return ts_load3(scene->vertices[scene->triangles[triangle].vertex[k]].position);
}

static ts_v3 normal(const ts_scene *scene, u32 triangle)
{
	ts_v3 a = corner(scene, triangle, 0);
	return ts_cross(ts_sub(corner(scene, triangle, 1), a), ts_sub(corner(scene, triangle, 2), a));
}

/* Every wall faces the middle of the room, every face of the reflector away from its own. */
static void every_wall_faces_the_rooms_middle(void **state)
{
	(void)state;
	const ts_v3 middle = ts_v3_make(0.0f, 2.0f, 0.0f), centre = ts_v3_make(1.0f, 1.5f, -1.0f);
	ts_scene *scene = open_scene("scenes/room.gltf", 0, NULL);
	assert_int_equal(scene->n_triangles, 20);
	assert_int_equal(scene->info.n_reflectors, 1);
	assert_int_equal(scene->n_notes, 0);
	for (u32 i = 0; i < 20; i++) {
		u32 object = scene->vertices[scene->triangles[i].vertex[0]].object;
		ts_v3 from = object == 0 ? middle : centre;
		f32 towards = ts_dot(normal(scene, i), ts_sub(from, corner(scene, i, 0)));
		assert_true(object == 0 ? towards > 0.0f : towards < 0.0f);
	}
	assert_float_equal(scene->info.hall_max[0], 3.8f, 1e-5f);
	assert_float_equal(scene->info.hall_min[1], -2.85f, 1e-5f);
	assert_int_equal(scene->n_images, 1);
	assert_int_equal(scene->n_texels, 5);
	assert_true(scene->slots[0].transform[0] == 2.0f && scene->slots[0].wrap[1] == TS_MIRROR);
	assert_true(scene->n_lights == 1 && scene->lights[0].position[1] == 3.5f && scene->lights[0].intensity[0] == 40.0f);
	ts_scene_free(scene);
}

static void the_door_looks_into_the_room(void **state)
{
	(void)state;
	const ts_scene_options door = {.camera = "door"};
	ts_scene *scene = open_scene("scenes/room.gltf", 3, &door);
	const ts_camera *camera = &scene->cameras[scene->camera];
	assert_int_equal(scene->info.n_reflectors, 4);
	assert_true(camera->eye[0] == -3.0f && camera->eye[1] == 1.5f && camera->eye[2] == 2.0f);
	assert_float_equal(camera->back[0], -0.70710678f, 1e-6f);
	assert_float_equal(camera->back[2], 0.70710678f, 1e-6f);
	assert_float_equal(camera->yfov, 1.0f / 6.0f, 1e-6f);
	ts_scene_free(scene);
}

/* The corner that the sparse accessor moves is at (0, 2, 0) before doubling; the second strip is mirrored in x. */
static void instances_are_doubled_and_mirrored(void **state)
{
	(void)state;
	ts_scene *scene = open_scene("scenes/instances.gltf", 0, NULL);
	assert_int_equal(scene->n_triangles, 2);
	for (u32 i = 0; i < 2; i++) assert_true(normal(scene, i).z > 0.0f);
	const f32 low[3] = {-2.0f, 0.0f, -2.0f}, high[3] = {2.0f, 4.0f, 0.0f};
	assert_memory_equal(scene->info.box_min, low, sizeof low);
	assert_memory_equal(scene->info.box_max, high, sizeof high);
	ts_scene_free(scene);
}

static void points_without_normals_are_surfels(void **state)
{
	(void)state;
	ts_scene *scene = open_scene("scenes/points.gltf", 2, NULL);
	assert_int_equal(scene->n_triangles_file, 0);
	assert_int_equal(scene->n_surfels, 12); /* both sides */
	assert_true(scene->n_notes >= 1);
	ts_scene_free(scene);
}

/* The same three ellipses in both formats. */
static void both_formats_hold_the_same_splats(void **state)
{
	(void)state;
	ts_scene *gltf = open_scene("scenes/splats.gltf", 2, NULL), *ply = open_scene("scenes/splats.ply", 2, NULL);
	assert_int_equal(gltf->n_surfels, 3);
	assert_int_equal(ply->n_surfels, 3);
	assert_memory_equal(gltf->surfels, ply->surfels, 3 * sizeof *ply->surfels);
	assert_true(ply->surfels[1].u[1] == 1.0f && ply->surfels[1].v[0] == -0.25f && ply->surfels[2].colour[2] == 1.0f);
	assert_int_equal(ply->info.n_reflectors, 0);
	ts_scene_free(gltf);
	ts_scene_free(ply);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_wall_faces_the_rooms_middle),  cmocka_unit_test(the_door_looks_into_the_room),
		cmocka_unit_test(instances_are_doubled_and_mirrored), cmocka_unit_test(points_without_normals_are_surfels),
		cmocka_unit_test(both_formats_hold_the_same_splats),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
