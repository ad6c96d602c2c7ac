/* Building a scene: appending records. Every float is sanitized (CONTRACT rule 10) and every padding field is zero,
 * because the arrays are hashed. build_finish.c checks and freezes. */
#include <stdio.h>
#include <stdlib.h>
#include "kernels/base/vec.h"
#include "model/core.h"
#include "scene/build_parts.h"

static void fail_v(ts_build *build, const char *format, va_list arguments)
{
	if (build->failed) return;
	vsnprintf(build->message, sizeof build->message, format, arguments);
	build->failed = true;
	ts_fail_as(build->kind, "%s", build->message);
}

void ts_build_adopt(ts_build *build)
{
	if (build->failed) return;
	snprintf(build->message, sizeof build->message, "%s", ts_error_message());
	build->failed = true;
	build->kind = ts_error_kind();
}

ts_kind ts_build_about(ts_build *build, ts_kind kind)
{
	const ts_kind before = build->kind;
	if (!build->failed) build->kind = kind;
	return before;
}

void ts_build_fail(ts_build *build, const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	fail_v(build, format, arguments);
	va_end(arguments);
}

bool ts_build_failed(ts_build *build)
{
	if (build->failed || !ts_stopped(build->stop)) return build->failed;
	build->kind = TS_KIND_CANCELLED;
	ts_build_fail(build, "%s: cancelled", build->scene->name);
	return true;
}

void *ts_build_room(ts_build *build, void *array, u64 n, u64 more, size_t *capacity, size_t size, const char *what)
{
	void *grown = array;
	if (build->failed) return array;
	if (ts_grow(&grown, capacity, (size_t)(n + more), size, what) != TS_OK) ts_build_adopt(build);
	return grown;
}

/* The index after n records, which must stay below TS_NONE. */
static bool countable(ts_build *build, u32 n, const char *what)
{
	if (n >= TS_NONE - 1) ts_build_fail(build, "%s: more than %u %s", build->scene->name, TS_NONE - 1, what);
	return !ts_build_failed(build);
}

static char *text_copy(ts_build *build, const char *text)
{
	size_t bytes = strlen(text) + 1;
	char *copy = ts_alloc(bytes, 1, "a name");
	if (copy) return memcpy(copy, text, bytes);
	ts_build_adopt(build);
	return NULL;
}

static ts_path_eye *path_copy(ts_build *build, const ts_camera *camera)
{
	ts_path_eye *copy = ts_alloc(camera->n_path, sizeof *copy, "a camera's path");
	if (copy) return memcpy(copy, camera->path, camera->n_path * sizeof *copy);
	ts_build_adopt(build);
	return NULL;
}

ts_build *ts_build_new(const char *name)
{
	ts_build *build = ts_alloc_zero(1, sizeof *build, "a scene under construction");
	if (!build) return NULL;
	build->kind = TS_KIND_ARGUMENT;
	build->stop = ts_stop_here();
	build->scene = ts_alloc_zero(1, sizeof *build->scene, "a scene");
	if (build->scene) {
		build->scene->camera = TS_NONE;
		build->scene->name = text_copy(build, name);
	}
	if (!build->scene || !build->scene->name || !TS_BUILD_ROOM(build, objects, "objects")) {
		ts_build_free(build);
		return NULL;
	}
	build->scene->objects[build->scene->n_objects++] = (ts_object){.reflector = TS_NONE};
	return build;
}

void ts_build_free(ts_build *build)
{
	if (!build) return;
	ts_scene_free(build->scene);
	ts_build_motions_free(build);
	free(build);
}

void ts_scene_free(ts_scene *scene)
{
	if (!scene) return;
	for (u32 i = 0; i < scene->n_cameras; i++) {
		free(scene->cameras[i].name);
		free(scene->cameras[i].path);
	}
	for (u32 i = 0; i < scene->n_nodes; i++) free(scene->nodes[i].name);
	for (u32 i = 0; i < scene->n_notes; i++) free(scene->notes[i]);
	free(scene->name);
	free(scene->vertices);
	free(scene->triangles);
	free(scene->materials);
	free(scene->slots);
	free(scene->images);
	free(scene->texels);
	free(scene->lights);
	free(scene->objects);
	free(scene->surfels);
	free(scene->cameras);
	free(scene->nodes);
	free(scene->stands);
	free(scene->path);
	free(scene->motion);
	free(scene->notes);
	free(scene);
}

static void sanitize(f32 *to, const f32 *from, u32 n)
{
	for (u32 i = 0; i < n; i++) to[i] = ts_san(from[i]);
}

static void sanitize_unit(f32 *to, const f32 *from)
{
	f32 clean[3];
	sanitize(clean, from, 3);
	ts_store3(to, ts_normalize(ts_load3(clean)));
}

/* A colour's channels are from 0 to 1; how many were not is noted at the end. */
static void take_colour(ts_build *build, f32 *to, const f32 *from, u32 n)
{
	bool outside = false;
	for (u32 i = 0; i < n; i++) {
		f32 x = ts_san(from[i]);
		to[i] = ts_clamp(x, 0.0f, 1.0f);
		outside |= to[i] != x;
	}
	build->n_outside += outside;
}

static void take_vertex(ts_build *build, ts_vertex *v, const ts_vertex *vertex, u32 object)
{
	v->object = object;
	v->pad = 0;
	sanitize(v->position, vertex->position, 3);
	sanitize_unit(v->normal, vertex->normal);
	sanitize_unit(v->tangent, vertex->tangent);
	bool no_tangent = v->tangent[0] == 0.0f && v->tangent[1] == 0.0f && v->tangent[2] == 0.0f;
	v->tangent[3] = no_tangent ? 0.0f : ts_san(vertex->tangent[3]) < 0.0f ? -1.0f : 1.0f;
	sanitize(v->uv, vertex->uv, 4);
	take_colour(build, v->colour, vertex->colour, 4);
}

u32 ts_build_vertex(ts_build *build, const ts_vertex *vertex)
{
	ts_scene *scene = build->scene;
	if (!countable(build, scene->n_vertices, "vertices") || !TS_BUILD_ROOM(build, vertices, "vertices")) return 0;
	take_vertex(build, &scene->vertices[scene->n_vertices], vertex, build->object);
	scene->objects[build->object].n_vertices++;
	return scene->n_vertices++;
}

u32 ts_build_vertex_moving(ts_build *build, const ts_vertex *vertex, const ts_vertex *own)
{
	build->own =
		ts_build_room(build, build->own, build->n_own, 1, &build->capacity.own, sizeof *build->own, "moving vertices");
	if (build->failed) return 0;
	u32 index = ts_build_vertex(build, vertex);
	u64 n_outside = build->n_outside; /* the vertex is counted once */
	if (!build->failed) take_vertex(build, &build->own[build->n_own++], own, build->object);
	build->n_outside = n_outside;
	return index;
}

void ts_build_move(ts_build *build, u32 first, ts_v3 by)
{
	for (u32 i = first; i < build->scene->n_vertices; i++) {
		f32 *position = build->scene->vertices[i].position;
		ts_store3(position, ts_add(ts_load3(position), by));
	}
}

void ts_build_triangle(ts_build *build, u32 a, u32 b, u32 c, u32 material)
{
	ts_scene *scene = build->scene;
	if (!countable(build, scene->n_triangles, "triangles") || !TS_BUILD_ROOM(build, triangles, "triangles")) return;
	scene->triangles[scene->n_triangles++] = (ts_triangle){{a, b, c}, material};
}

ts_material ts_material_default(void)
{
	return (ts_material){
		.base = {1.0f, 1.0f, 1.0f, 1.0f},
		.roughness = 1.0f,
		.normal_scale = 1.0f,
		.occlusion = 1.0f,
		.alpha_cutoff = 0.5f,
		.slot = {TS_NONE, TS_NONE, TS_NONE, TS_NONE, TS_NONE},
	};
}

static f32 unit_range(ts_build *build, f32 value, const char *field)
{
	f32 x = ts_san(value);
	f32 clamped = ts_clamp(x, 0.0f, 1.0f);
	if (clamped != x)
		ts_build_note(build, "material %u: %s %g is outside 0 to 1, read as %g", build->scene->n_materials, field,
		              (double)x, (double)clamped);
	return clamped;
}

u32 ts_build_material(ts_build *build, const ts_material *material)
{
	ts_scene *scene = build->scene;
	if (!countable(build, scene->n_materials, "materials") || !TS_BUILD_ROOM(build, materials, "materials")) return 0;
	ts_material *m = &scene->materials[scene->n_materials];
	*m = *material;
	for (u32 k = 0; k < 4; k++) m->base[k] = unit_range(build, material->base[k], "base colour");
	sanitize(m->emissive, material->emissive, 3);
	m->metallic = unit_range(build, material->metallic, "metallic");
	m->roughness = unit_range(build, material->roughness, "roughness");
	m->occlusion = unit_range(build, material->occlusion, "occlusion strength");
	m->normal_scale = ts_san(material->normal_scale);
	m->alpha_cutoff = ts_san(material->alpha_cutoff);
	m->pad[0] = m->pad[1] = 0;
	return scene->n_materials++;
}

u32 ts_build_slot(ts_build *build, const ts_slot *slot)
{
	ts_scene *scene = build->scene;
	if (!countable(build, scene->n_slots, "texture references") || !TS_BUILD_ROOM(build, slots, "texture references"))
		return 0;
	ts_slot *s = &scene->slots[scene->n_slots];
	*s = *slot;
	sanitize(s->transform, slot->transform, 6);
	s->pad[0] = s->pad[1] = 0;
	return scene->n_slots++;
}

void ts_build_light(ts_build *build, const ts_light *light)
{
	ts_scene *scene = build->scene;
	if (!countable(build, scene->n_lights, "lights") || !TS_BUILD_ROOM(build, lights, "lights")) return;
	ts_light *l = &scene->lights[scene->n_lights++];
	*l = (ts_light){.kind = light->kind, .range = ts_san(light->range)};
	sanitize(l->position, light->position, 3);
	sanitize_unit(l->direction, light->direction);
	sanitize(l->intensity, light->intensity, 3);
	l->spot_scale = ts_san(light->spot_scale);
	l->spot_offset = ts_san(light->spot_offset);
}

void ts_build_camera(ts_build *build, const ts_camera *camera)
{
	ts_scene *scene = build->scene;
	if (!countable(build, scene->n_cameras, "cameras") || !TS_BUILD_ROOM(build, cameras, "cameras")) return;
	char *name = text_copy(build, camera->name ? camera->name : "");
	if (!name) return;
	ts_camera *c = &scene->cameras[scene->n_cameras++];
	*c = (ts_camera){.name = name, .yfov = ts_san(camera->yfov), .n_path = camera->n_path};
	if (c->n_path > 0) c->path = path_copy(build, camera);
	sanitize(c->eye, camera->eye, 3);
	sanitize(c->right, camera->right, 3);
	sanitize(c->up, camera->up, 3);
	sanitize(c->back, camera->back, 3);
}

void ts_build_node(ts_build *build, const char *name, u64 n_triangles)
{
	ts_scene *scene = build->scene;
	if (!countable(build, scene->n_nodes, "nodes") || !TS_BUILD_ROOM(build, nodes, "nodes")) return;
	char *copy = text_copy(build, name);
	if (copy) scene->nodes[scene->n_nodes++] = (ts_named_node){copy, n_triangles};
}

u32 ts_build_object(ts_build *build, const ts_object *object, bool is_reflector)
{
	ts_scene *scene = build->scene;
	build->object = 0;
	if (!object || !countable(build, scene->n_objects, "objects")) return 0;
	if (!TS_BUILD_ROOM(build, objects, "objects")) return 0;
	ts_object *o = &scene->objects[scene->n_objects];
	*o = (ts_object){.first_vertex = scene->n_vertices, .reflector = TS_NONE, .period = object->period};
	if (is_reflector) o->reflector = scene->info.n_reflectors++;
	sanitize(o->centre, object->centre, 3);
	sanitize(o->axis, object->axis, 2);
	o->phase = ts_san(object->phase);
	o->bob = ts_san(object->bob);
	o->spin = ts_san(object->spin);
	build->object = scene->n_objects;
	return scene->n_objects++;
}

void ts_build_select(ts_build *build, u32 object) { build->object = object; }

u32 ts_build_surfel(ts_build *build, const ts_surfel *surfel)
{
	ts_scene *scene = build->scene;
	if (!countable(build, scene->n_surfels, "surfels") || !TS_BUILD_ROOM(build, surfels, "surfels")) return 0;
	ts_surfel *s = &scene->surfels[scene->n_surfels];
	sanitize(s->centre, surfel->centre, 3);
	sanitize(s->u, surfel->u, 3);
	sanitize(s->v, surfel->v, 3);
	take_colour(build, s->colour, surfel->colour, 3);
	return scene->n_surfels++;
}

void ts_build_origin(ts_build *build, const double origin[3])
{
	memcpy(build->scene->origin, origin, sizeof build->scene->origin);
}

void ts_build_note(ts_build *build, const char *format, ...)
{
	ts_scene *scene = build->scene;
	char line[512];
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(line, sizeof line, format, arguments);
	va_end(arguments);
	ts_line_clean(line);
	if (!TS_BUILD_ROOM(build, notes, "notes")) return;
	char *note = text_copy(build, line);
	if (note) scene->notes[scene->n_notes++] = note;
}

/* Makes the box hold p; *found counts points. */
static void hold(ts_info *info, ts_v3 p, u64 *found)
{
	bool first = (*found)++ == 0;
	ts_store3(info->box_min, first ? p : ts_min3(ts_load3(info->box_min), p));
	ts_store3(info->box_max, first ? p : ts_max3(ts_load3(info->box_max), p));
}

/* The box of the triangles of object 0 and the centres of the surfels; without either, of all objects at rest.
 * Triangles whose corners do not exist are ignored. */
static void measure_box(ts_scene *scene)
{
	ts_info *info = &scene->info;
	u64 found = 0;
	memset(info->box_min, 0, sizeof info->box_min);
	memset(info->box_max, 0, sizeof info->box_max);
	for (int pass = 0; pass < 2 && found == 0; pass++) {
		for (u32 i = 0; i < scene->n_triangles; i++) {
			for (u32 k = 0; k < 3; k++) {
				u32 index = scene->triangles[i].vertex[k];
				if (index >= scene->n_vertices) continue;
				u32 object = scene->vertices[index].object;
				if (pass == 0 ? !ts_build_is_own(scene, object) : scene->objects[object].period != 0) continue;
				hold(info, ts_load3(scene->vertices[index].position), &found);
			}
		}
		for (u32 i = 0; i < scene->n_surfels && pass == 0; i++) hold(info, ts_load3(scene->surfels[i].centre), &found);
	}
}

void ts_build_measure(ts_build *build)
{
	ts_info *info = &build->scene->info;
	if (!build->placed) {
		measure_box(build->scene);
		ts_build_walls(build);
		return;
	}
	ts_info place = build->place;
	place.n_reflectors = info->n_reflectors;
	place.ambient = info->ambient;
	*info = place;
}

const ts_scene *ts_build_peek(ts_build *build)
{
	ts_build_measure(build);
	return build->scene;
}
