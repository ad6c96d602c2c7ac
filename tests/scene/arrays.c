/* Scenes from arrays: what a file holds, given as arrays, makes the scene of the file, to the bit; and arrays that make
 * no scene are refused. */
#include <math.h>
#include "methods/pipeline.h"
#include "scene/sources.h"
#include "tests/status.h"

/* The arrays of a scene that has no textures and to which nothing was added. */
static ts_scene_arrays arrays_of(const ts_scene *s, ts_camera_array *camera)
{
	ts_scene_arrays a = {.bytes = sizeof a,
	                     .name = s->name,
	                     .vertices = s->vertices,
	                     .n_vertices = s->n_vertices,
	                     .triangles = s->triangles,
	                     .n_triangles = s->n_triangles,
	                     .materials = s->materials,
	                     .n_materials = s->n_materials,
	                     .lights = s->lights,
	                     .n_lights = s->n_lights,
	                     .objects = s->objects,
	                     .n_objects = s->n_objects,
	                     .surfels = s->surfels,
	                     .n_surfels = s->n_surfels};
	if (s->n_cameras == 0) return a;
	const ts_camera *c = &s->cameras[0];
	*camera = (ts_camera_array){.name = c->name, .yfov = c->yfov};
	memcpy(camera->eye, c->eye, sizeof c->eye);
	memcpy(camera->right, c->right, sizeof c->right);
	memcpy(camera->up, c->up, sizeof c->up);
	memcpy(camera->back, c->back, sizeof c->back);
	a.cameras = camera;
	a.n_cameras = 1;
	return a;
}

static void same(const void *a, u64 n_a, const void *b, u64 n_b, size_t bytes, const char *what)
{
	if (n_a != n_b || (n_a > 0 && memcmp(a, b, (size_t)n_a * bytes) != 0)) fail_msg("%s", what);
}
#define SAME(array) same(a->array, a->n_##array, b->array, b->n_##array, sizeof *a->array, #array)

static void same_scenes(const ts_scene *a, const ts_scene *b)
{
	SAME(vertices);
	SAME(triangles);
	SAME(materials);
	SAME(lights);
	SAME(objects);
	SAME(surfels);
	SAME(stands);
	SAME(texels);
	same(&a->info, 1, &b->info, 1, sizeof a->info, "info");
}

/* With mirrors that are added to both. The file has n_materials, one of them of primitives without any. */
static void of_file(const char *path, u32 n_materials)
{
	ts_params params;
	ts_scene *bare, *file, *made;
	ts_camera_array camera;
	ts_params_default(&params);
	params.reflectors_count = 0;
	require(ts_scene_load(&bare, path, &params, NULL));
	ts_scene_arrays arrays = arrays_of(bare, &camera);
	if (bare->info.ambient != 0.0f) arrays.n_lights = 0; /* its light is the sun of scenes without any */
	arrays.n_materials = n_materials;
	for (u32 i = 0; i < bare->n_triangles; i++) {
		if (bare->triangles[i].material >= n_materials) bare->triangles[i].material = TS_NONE;
	}
	params.reflectors_count = 3;
	require(ts_scene_load(&file, path, &params, NULL));
	require(ts_scene_of_arrays(&made, &arrays, &params, &(ts_scene_options){.bytes = 0}));
	same_scenes(file, made);
	ts_scene_free(made);
	ts_scene_free(file);
	ts_scene_free(bare);
}

static void arrays_make_the_scene_of_the_file(void **state)
{
	(void)state;
	of_file("scenes/instances.gltf", 1);
	of_file("scenes/triangle.gltf", 1);
	of_file("scenes/triangle_mirror.gltf", 1);
	of_file("scenes/triangle_side.gltf", 2);
	of_file("scenes/splats.gltf", 0);
	of_file("scenes/splats.ply", 0);
}

static const u8 chequers[] = {255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 255};

static const ts_vertex corners[4] = {{.position = {-1, 0, 1}, .colour = {1, 1, 1, 1}, .uv = {0, 1}},
                                     {.position = {1, 0, 1}, .colour = {1, 1, 1, 1}, .uv = {1, 1}},
                                     {.position = {1, 0, -1}, .colour = {1, 1, 1, 1}, .uv = {1, 0}},
                                     {.position = {-1, 0, -1}, .colour = {1, 1, 1, 1}, .uv = {0, 0}}};
static const ts_triangle halves[2] = {{.vertex = {0, 1, 2}}, {.vertex = {0, 2, 3}}};

static ts_scene_arrays square(const ts_material *material, const ts_slot *slot, const ts_image_array *image)
{
	return (ts_scene_arrays){.bytes = sizeof(ts_scene_arrays),
	                         .vertices = corners,
	                         .n_vertices = 4,
	                         .triangles = halves,
	                         .n_triangles = 2,
	                         .materials = material,
	                         .n_materials = 1,
	                         .slots = slot,
	                         .n_slots = 1,
	                         .images = image,
	                         .n_images = 1};
}

/* A texture becomes a mip chain of linear texels: the four, and their mean. */
static void a_texture_becomes_a_mip_chain(void **state)
{
	(void)state;
	ts_params params;
	ts_scene *scene;
	ts_material material = ts_material_default();
	material.slot[TS_SLOT_BASE] = 0;
	const ts_slot slot = {.transform = {1, 0, 0, 0, 1, 0}};
	const ts_image_array image = {chequers, 2, 2, 1};
	ts_scene_arrays arrays = square(&material, &slot, &image);
	ts_params_default(&params);
	require(ts_scene_of_arrays(&scene, &arrays, &params, &(ts_scene_options){.bytes = 0}));
	assert_string_equal(scene->name, "arrays");
	assert_int_equal(scene->n_images, 1);
	assert_int_equal(scene->images[0].n_levels, 2);
	assert_int_equal(scene->n_texels, 5);
	assert_int_equal(scene->texels[0], UINT64_MAX);
	assert_int_equal(scene->texels[1], 0xffff000000000000u);
	u64 red = scene->texels[4] & 0xffff;
	assert_true(red == 32767 || red == 32768);
	ts_scene_free(scene);
}

static void refuses(const ts_scene_arrays *arrays, const ts_scene_options *options, const char *words)
{
	static const ts_scene_options none;
	ts_params params;
	ts_scene *scene;
	ts_params_default(&params);
	if (ts_scene_of_arrays(&scene, arrays, &params, options != NULL ? options : &none) == TS_OK) fail_msg("%s", words);
	assert_null(scene);
	says(words);
}

static void arrays_that_make_no_scene_are_refused(void **state)
{
	(void)state;
	ts_material material = ts_material_default();
	ts_slot slot = {.transform = {1, 0, 0, 0, 1, 0}};
	ts_image_array image = {chequers, 2, 2, 1};
	const ts_scene_arrays good = square(&material, &slot, &image);
	ts_scene_arrays bad = good;
	ts_vertex moved[4];
	memcpy(moved, corners, sizeof moved);
	bad.vertices = NULL;
	refuses(&bad, NULL, "vertices is NULL; 4 are said to be there");
	bad.vertices = (const ts_vertex *)(const void *)((const char *)moved + 2);
	refuses(&bad, NULL, "vertices is not aligned to 4 bytes");
	bad = good;
	bad.n_vertices = 3;
	refuses(&bad, NULL, "vertex 3 does not exist");
	bad = good;
	bad.vertices = moved;
	moved[2].object = 1;
	refuses(&bad, NULL, "vertex 2: object 1 does not exist; there are 1");
	moved[2].object = 0;
	moved[1].normal[2] = NAN;
	refuses(&bad, NULL, "vertex 1: a number is not finite");
	moved[1].normal[2] = 0;
	moved[1].position[2] = 2e8f;
	refuses(&bad, NULL, "vertex 1: coordinate 2e+08");
	bad = good;
	bad.n_materials = 0;
	refuses(&bad, NULL, "material 0 does not exist");
	bad = good;
	material.slot[TS_SLOT_NORMAL] = 1;
	refuses(&bad, NULL, "texture reference 1 does not exist");
	material = ts_material_default();
	slot.image = 1;
	refuses(&bad, NULL, "image 1 does not exist");
	slot.image = 0;
	image.rgba = NULL;
	refuses(&bad, NULL, "image 0: rgba is NULL");
	image = (ts_image_array){chequers, 0, 2, 1};
	refuses(&bad, NULL, "each side must be 1 to 65536");
	image = (ts_image_array){chequers, 2, 2, 1};
	const ts_object mirror = {.reflector = 0};
	bad.objects = &mirror;
	bad.n_objects = 1;
	refuses(&bad, NULL, "object 0 is a mirror");
	ts_camera_array camera = {"front", {0, 1, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.1f};
	bad = good;
	bad.cameras = &camera;
	bad.n_cameras = 1;
	camera.yfov = 0.5f;
	refuses(&bad, NULL, "camera 0: an eye within");
	camera.yfov = 0.1f;
	camera.up[0] = 0.5f;
	refuses(&bad, NULL, "camera 0: an eye within");
	camera.up[0] = 0;
	for (u32 k = 0; k < 3; k++) {
		ts_camera_array far = camera;
		bad.cameras = &far;
		far.eye[k] = k == 1 ? -16777218.0f : 16777218.0f; /* the next number beyond the limit */
		refuses(&bad, NULL, "camera 0: an eye within 16777216");
	}
	refuses(&good, &(ts_scene_options){.n_mirrors = 5}, "5 mirrors; at most 1000, and an array of them");
	refuses(&good, &(ts_scene_options){.reflector = "ball"}, "no named nodes");
	refuses(&good, &(ts_scene_options){.camera = "front"}, "camera front");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(arrays_make_the_scene_of_the_file),
		cmocka_unit_test(a_texture_becomes_a_mip_chain),
		cmocka_unit_test(arrays_that_make_no_scene_are_refused),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
