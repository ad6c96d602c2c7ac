/* A scene from its maker's own arrays: build_finish.c checks their contents, as for files. */
#include <float.h>
#include "model/table.h"
#include "scene/build_parts.h"
#include "scene/sources.h"

static void check_arrays(ts_build *build, const ts_scene_arrays *a, const ts_scene_options *o)
{
	const struct {
		const char *name;
		const void *array;
		u32 n;
		size_t aligned;
	} given[] = {{"vertices", a->vertices, a->n_vertices, _Alignof(ts_vertex)},
	             {"triangles", a->triangles, a->n_triangles, _Alignof(ts_triangle)},
	             {"materials", a->materials, a->n_materials, _Alignof(ts_material)},
	             {"slots", a->slots, a->n_slots, _Alignof(ts_slot)},
	             {"images", a->images, a->n_images, _Alignof(ts_image_array)},
	             {"lights", a->lights, a->n_lights, _Alignof(ts_light)},
	             {"objects", a->objects, a->n_objects, _Alignof(ts_object)},
	             {"surfels", a->surfels, a->n_surfels, _Alignof(ts_surfel)},
	             {"cameras", a->cameras, a->n_cameras, _Alignof(ts_camera_array)}};
	for (u32 i = 0; i < sizeof given / sizeof *given; i++) {
		if (given[i].n == 0) continue;
		if (given[i].array == NULL)
			ts_build_fail(build, "%s: %s is NULL; %u are said to be there", build->scene->name, given[i].name,
			              given[i].n);
		else if ((uintptr_t)given[i].array % given[i].aligned != 0)
			ts_build_fail(build, "%s: %s is not aligned to %zu bytes", build->scene->name, given[i].name,
			              given[i].aligned);
	}
	if (o->reflector != NULL || o->animation != NULL) {
		ts_build_fail(build, "%s: %s: arrays have no named nodes; NULL would be right", build->scene->name,
		              o->reflector != NULL ? "reflector" : "animation");
	}
	if (a->n_objects > 0 && a->objects[0].reflector != TS_NONE) {
		ts_build_fail(build, "%s: object 0 is a mirror; it is the static scene", build->scene->name);
	}
}

/* The floats of a record, by their places in words. */
typedef struct {
	u32 at[32], n;
} floats;

static floats floats_of(const char *record)
{
	size_t n_fields;
	floats f = {.n = 0};
	u32 at = 0;
	const ts_field_info *fields = ts_field_table(&n_fields);
	for (size_t i = 0; i < n_fields; i++) {
		if (strcmp(fields[i].record, record) != 0) continue;
		for (u32 k = 0; k < fields[i].count; k++, at++) {
			if (fields[i].type[0] == 'f') f.at[f.n++] = at;
		}
	}
	return f;
}

/* As for files, whose numbers must be finite. */
static void check_finite(ts_build *build, const char *record, const char *noun, const void *array, u32 n, size_t bytes)
{
	const floats f = floats_of(record);
	for (u32 i = 0; i < n && !build->failed; i++) {
		for (u32 k = 0; k < f.n; k++) {
			f32 value;
			memcpy(&value, (const u8 *)array + i * bytes + 4 * (size_t)f.at[k], sizeof value);
			if (ts_abs(value) <= FLT_MAX) continue;
			ts_build_fail(build, "%s: %s %u: a number is not finite", build->scene->name, noun, i);
		}
	}
}
#define FINITE(build, record, noun, a, array) \
	check_finite(build, #record, noun, (a)->array, (a)->n_##array, sizeof *(a)->array)

static void check_numbers(ts_build *build, const ts_scene_arrays *a)
{
	FINITE(build, ts_vertex, "vertex", a, vertices);
	FINITE(build, ts_material, "material", a, materials);
	FINITE(build, ts_slot, "texture reference", a, slots);
	FINITE(build, ts_light, "light", a, lights);
	FINITE(build, ts_object, "object", a, objects);
	FINITE(build, ts_surfel, "surfel", a, surfels);
}

static void add_vertices(ts_build *build, const ts_scene_arrays *a)
{
	for (u32 i = 1; i < a->n_objects; i++) ts_build_object(build, &a->objects[i], a->objects[i].reflector != TS_NONE);
	u32 n_objects = a->n_objects > 0 ? a->n_objects : 1;
	for (u32 i = 0; i < a->n_vertices && !build->failed; i++) {
		u32 object = a->vertices[i].object;
		if (object >= n_objects) {
			ts_build_fail(build, "%s: vertex %u: object %u does not exist; there are %u", build->scene->name, i, object,
			              n_objects);
		}
		ts_build_select(build, object);
		ts_build_vertex(build, &a->vertices[i]);
	}
}

/* Checked here, because vertices and materials of added mirrors follow these. */
static void add_triangles(ts_build *build, const ts_scene_arrays *a)
{
	const char *name = build->scene->name;
	for (u32 i = 0; i < a->n_triangles && !build->failed; i++) {
		const u32 *v = a->triangles[i].vertex, material = a->triangles[i].material;
		for (u32 k = 0; k < 3; k++) {
			if (v[k] < a->n_vertices) continue;
			ts_build_fail(build, "%s: triangle %u: vertex %u does not exist; there are %u", name, i, v[k],
			              a->n_vertices);
		}
		if (material >= a->n_materials && material != TS_NONE) {
			ts_build_fail(build, "%s: triangle %u: material %u does not exist; there are %u", name, i, material,
			              a->n_materials);
		}
		ts_build_triangle(build, v[0], v[1], v[2], material);
	}
}

static void add_surfels(ts_build *build, const ts_scene_arrays *a)
{
	for (u32 i = 0; i < a->n_surfels && !build->failed; i++) ts_build_surfel(build, &a->surfels[i]);
}

static void add_looks(ts_build *build, const ts_scene_arrays *a)
{
	for (u32 i = 0; i < a->n_materials && !build->failed; i++) ts_build_material(build, &a->materials[i]);
	for (u32 i = 0; i < a->n_slots && !build->failed; i++) ts_build_slot(build, &a->slots[i]);
	for (u32 i = 0; i < a->n_images && !build->failed; i++) {
		const ts_image_array *image = &a->images[i];
		if (image->rgba == NULL) {
			ts_build_fail(build, "%s: image %u: rgba is NULL", build->scene->name, i);
		} else {
			ts_build_image(build, image->rgba, image->width, image->height, image->srgb != 0);
		}
	}
	for (u32 i = 0; i < a->n_lights && !build->failed; i++) ts_build_light(build, &a->lights[i]);
}

static bool is_camera(const ts_camera_array *c)
{
	const ts_v3 axis[3] = {ts_load3(c->right), ts_load3(c->up), ts_load3(c->back)};
	bool good = c->yfov >= 0.0f && c->yfov < 0.5f;
	for (u32 k = 0; k < 3; k++) {
		good = good && ts_abs(c->eye[k]) <= TS_COORDINATE_LIMIT;
		good = good && ts_abs(ts_dot(axis[k], axis[k]) - 1.0f) < 1e-3f;
		good = good && ts_abs(ts_dot(axis[k], axis[(k + 1) % 3])) < 1e-3f;
	}
	return good;
}

static void add_cameras(ts_build *build, const ts_scene_arrays *a)
{
	for (u32 i = 0; i < a->n_cameras && !build->failed; i++) {
		const ts_camera_array *from = &a->cameras[i];
		if (!is_camera(from)) {
			ts_build_fail(
				build,
				"%s: camera %u: an eye within 16777216, unit axes at right angles, and a yfov from 0 to below "
				"0.5 would be right",
				build->scene->name, i);
		}
		ts_camera camera = {.name = (char *)(uintptr_t)from->name, .yfov = from->yfov};
		memcpy(camera.eye, from->eye, sizeof camera.eye);
		memcpy(camera.right, from->right, sizeof camera.right);
		memcpy(camera.up, from->up, sizeof camera.up);
		memcpy(camera.back, from->back, sizeof camera.back);
		ts_build_camera(build, &camera);
	}
}

static ts_status make_scene(ts_scene **scene, ts_build *build, const ts_scene_arrays *arrays, const ts_params *params,
                            const ts_scene_options *options)
{
	check_arrays(build, arrays, options);
	if (!build->failed) check_numbers(build, arrays);
	if (!build->failed) add_looks(build, arrays);
	if (!build->failed) add_vertices(build, arrays);
	if (!build->failed) add_triangles(build, arrays);
	if (!build->failed) add_surfels(build, arrays);
	if (!build->failed) add_cameras(build, arrays);
	const char *camera = ts_arrange(build, params, options, true);
	return ts_build_finish(build, params, camera, scene);
}

ts_status ts_scene_of_arrays(ts_scene **scene, const ts_scene_arrays *arrays, const ts_params *params,
                             const ts_scene_options *options)
{
	ts_status status;
	*scene = NULL;
	ts_build *build = ts_build_new(arrays->name != NULL ? arrays->name : "arrays");
	if (build == NULL) return TS_ERROR;
	TS_PARAM_READER("scene", "arrays", status = make_scene(scene, build, arrays, params, options));
	return status;
}
