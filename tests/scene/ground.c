/* The added ground: it lies under the scene, and neither box, hall, eye nor mirrors are others for it. */
#include <unistd.h>
#include "kernels/base/pose.h"
#include "scene/lamp.h"
#include "scene/sources.h"
#include "scene/view.h"
#include "tests/scene/folder.h"
#include "tests/status.h"
#include "tests/whole.h"

static const ts_scene_options none = {0}, circle = {.camera = TS_CAMERA_CIRCLE};

static u32 corner(ts_build *build, const f32 p[3])
{
	ts_vertex v = {.position = {p[0], p[1], p[2]}};
	return ts_build_vertex(build, &v);
}

/* A box whose faces look outwards. */
static void box(ts_build *build, const f32 low[3], const f32 high[3])
{
	for (u32 face = 0; face < 6; face++) {
		u32 axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, c[4];
		for (u32 k = 0; k < 4; k++) {
			f32 p[3];
			p[axis] = (face & 1 ? high : low)[axis];
			p[u] = (k == 1 || k == 2 ? high : low)[u];
			p[v] = (k >= 2 ? high : low)[v];
			c[k] = corner(build, p);
		}
		u32 second = face & 1 ? 1 : 2;
		ts_build_triangle(build, c[0], c[second], c[3 - second], TS_NONE);
		ts_build_triangle(build, c[0], c[second + 1], c[4 - second], TS_NONE);
	}
}

/* A body on four thick legs, between which a place is enclosed, but without a floor. */
static ts_scene *four_legs(void)
{
	ts_params params;
	ts_scene *scene;
	const f32 body[2][3] = {{-1, 2, -1}, {1, 2.7f, 1}};
	ts_params_default(&params);
	ts_build *build = ts_build_new("four legs");
	assert_non_null(build);
	for (u32 i = 0; i < 4; i++) {
		f32 x = i & 1 ? -1.0f : 0.1f, z = i & 2 ? -1.0f : 0.1f;
		const f32 leg[2][3] = {{x, 0, z}, {x + 0.9f, 2, z + 0.9f}};
		box(build, leg[0], leg[1]);
	}
	box(build, body[0], body[1]);
	require(ts_build_finish(build, &params, NULL, &scene));
	return scene;
}

/* The model as a caller's arrays; with_surfels: its first corner as a surfel, and no triangles. */
static ts_scene *opened(const ts_scene *model, bool ground, bool as_surfel, const ts_scene_options *options)
{
	const ts_surfel surfel = {.u = {1, 0, 0}, .v = {0, 0, -1}, .colour = {1, 1, 1}};
	ts_scene *scene;
	ts_params params;
	ts_params_default(&params);
	TS_PARAM_SET(&params, scene_ground, ground);
	ts_scene_arrays arrays = {.bytes = sizeof arrays, .vertices = model->vertices, .n_vertices = model->n_vertices};
	if (as_surfel) {
		arrays.surfels = &surfel;
		arrays.n_surfels = 1;
	} else {
		arrays.triangles = model->triangles;
		arrays.n_triangles = model->n_triangles;
		arrays.materials = model->materials;
		arrays.n_materials = model->n_materials;
	}
	require(ts_scene_of_arrays(&scene, &arrays, &params, options));
	return scene;
}

static void same_places(const ts_scene *without, const ts_scene *with, const char *what)
{
	if (memcmp(&without->info, &with->info, sizeof with->info) == 0) return;
	const ts_info *a = &without->info, *b = &with->info;
	fail_msg("%s: box y %g to %g is %g to %g with a ground", what, (double)a->box_min[1], (double)a->box_max[1],
	         (double)b->box_min[1], (double)b->box_max[1]);
}

/* No room is found between the legs, however the eye is chosen. */
static void the_subject_is_that_without_a_ground(void **state)
{
	(void)state;
	ts_scene *model = four_legs();
	for (u32 i = 0; i < 2; i++) {
		const ts_scene_options *options = i == 0 ? &none : &circle;
		ts_scene *without = opened(model, false, false, options), *with = opened(model, true, false, options);
		assert_int_equal(without->info.circles, i == 0 ? TS_CIRCLES_OUTSIDE : TS_CIRCLES_HALL);
		same_places(without, with, i == 0 ? "an eye that rays place" : "an eye that circles");
		ts_scene_free(without);
		ts_scene_free(with);
	}
	ts_scene_free(model);
}

/* Two triangles of the static scene, level with the soles, facing up, wider than the model all around. */
static void it_lies_under_the_model(void **state)
{
	(void)state;
	ts_scene *model = four_legs(), *with = opened(model, true, false, &none);
	assert_int_equal(with->n_triangles_file, model->n_triangles + 2);
	f32 low[3] = {0}, high[3] = {0};
	for (u32 i = model->n_triangles; i < with->n_triangles_file; i++) {
		ts_v3 p[3];
		for (u32 k = 0; k < 3; k++) {
			const ts_vertex *v = &with->vertices[with->triangles[i].vertex[k]];
			assert_int_equal(v->object, 0);
			p[k] = ts_load3(v->position);
			for (u32 axis = 0; axis < 3; axis++) {
				low[axis] = ts_min(low[axis], v->position[axis]);
				high[axis] = ts_max(high[axis], v->position[axis]);
			}
		}
		assert_true(ts_cross(ts_sub(p[1], p[0]), ts_sub(p[2], p[0])).y > 0.0f);
	}
	assert_true(low[1] == 0.0f && high[1] == 0.0f);
	for (u32 axis = 0; axis < 3; axis += 2) assert_true(low[axis] < -4.0f && high[axis] > 4.0f);
	ts_scene_free(with);
	ts_scene_free(model);
}

/* The mirrors stand on it or above it. */
static void no_mirror_reaches_through_it(void **state)
{
	(void)state;
	ts_scene *model = four_legs(), *with = opened(model, true, false, &none);
	assert_int_equal(with->info.n_reflectors, 10);
	for (u32 i = 1; i < with->n_objects; i++) {
		const ts_object *o = &with->objects[i];
		f32 radius = ts_length(ts_load3(with->vertices[o->first_vertex].position));
		assert_true(ts_k_pose(o, 0).centre.y >= radius);
	}
	ts_scene_free(with);
	ts_scene_free(model);
}

/* Where the lamp throws the shadow of a box's corner onto its floor. */
static ts_v3 shadow_of(const ts_light *lamp, ts_v3 corner, f32 floor)
{
	ts_v3 from = ts_load3(lamp->position), way = ts_sub(corner, from);
	return ts_mad(from, way, (floor - from.y) / way.y);
}

/* Of boxes of many proportions, high and flat. */
static void the_shadow_of_the_lamp_falls_onto_it(void **state)
{
	(void)state;
	for (u32 i = 0; i < 27; i++) {
		ts_params params;
		ts_scene *bare;
		const f32 extents[3] = {0.1f, 1, 8}, low[3] = {3, -2, 5};
		const f32 high[3] = {3 + extents[i % 3], -2 + extents[i / 3 % 3], 5 + extents[i / 9]};
		ts_params_default(&params);
		ts_build *build = ts_build_new("a box");
		assert_non_null(build);
		box(build, low, high);
		require(ts_build_finish(build, &params, NULL, &bare));
		ts_scene *scene = opened(bare, true, false, &none);
		ts_light lamp;
		ts_lamp_spot(&lamp, &scene->info, scene->n_stands != 0 ? scene->stands : NULL, &params);
		f32 reach = scene->vertices[scene->triangles[12].vertex[1]].position[0] - ts_view_box(&scene->info).middle.x;
		assert_true(reach > 0.0f);
		for (u32 c = 0; c < 8; c++) {
			ts_v3 at = ts_v3_make(c & 1 ? low[0] : high[0], c & 2 ? low[1] : high[1], c & 4 ? low[2] : high[2]);
			ts_v3 away = ts_sub(shadow_of(&lamp, at, low[1]), ts_view_box(&scene->info).middle);
			assert_true(ts_abs(away.x) < reach && ts_abs(away.z) < reach);
		}
		ts_scene_free(scene);
		ts_scene_free(bare);
	}
}

/* A scene of surfels alone has no mirrors, on a ground neither. */
static void it_brings_surfels_no_mirrors(void **state)
{
	(void)state;
	ts_scene *model = four_legs();
	ts_scene *without = opened(model, false, true, &none), *with = opened(model, true, true, &none);
	assert_int_equal(with->n_triangles, 2);
	assert_int_equal(without->info.n_reflectors, 0);
	same_places(without, with, "a surfel");
	ts_scene_free(without);
	ts_scene_free(with);
	ts_scene_free(model);
}

static ts_scene *of_file(const char *path, bool ground)
{
	ts_scene *scene;
	ts_params params;
	ts_params_default(&params);
	TS_PARAM_SET(&params, reflectors_count, 0);
	TS_PARAM_SET(&params, scene_ground, ground);
	require(ts_scene_load(&scene, path, &params, &none));
	return scene;
}

/* Models and rooms; the first few have legs, arms or a visor, or are surfels. */
static void the_subject_of_files_is_that_without_a_ground(void **state)
{
	(void)state;
	static const char *const files[] = {
		"armadillo_86k.glb", "damaged_helmet.glb", "bunny_splats.glb",   "cornell_box_sphere.glb",
		"room.gltf",         "splats.ply",         "instances.gltf",     "dragon_80k.glb",
		"bunny.glb",         "suzanne.glb",        "vr_gallery.glb",     "cornell_box_original.glb",
		"chess_board.glb",   "pbr_spheres.glb",    "modern_hall.glb",    "cornell_box_water.glb",
		"sponza.glb",        "sibenik.glb",        "breakfast_room.glb", "country_kitchen_partial.glb",
		"dragon_scans.glb",  "dragon_splats.glb",  "fireplace_room.glb",
	};
	char path[4096];
	u32 n = 0, most = whole_or(sizeof files / sizeof *files, 7);
	for (u32 i = 0; i < most; i++) {
		snprintf(path, sizeof path, "%s/%s", scenes_folder(), files[i]);
		if (access(path, R_OK) != 0) continue;
		n++;
		ts_scene *without = of_file(path, false), *with = of_file(path, true);
		same_places(without, with, files[i]);
		ts_scene_free(without);
		ts_scene_free(with);
	}
	if (n == 0) skip();
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_subject_is_that_without_a_ground),
		cmocka_unit_test(it_lies_under_the_model),
		cmocka_unit_test(no_mirror_reaches_through_it),
		cmocka_unit_test(the_shadow_of_the_lamp_falls_onto_it),
		cmocka_unit_test(it_brings_surfels_no_mirrors),
		cmocka_unit_test(the_subject_of_files_is_that_without_a_ground),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
