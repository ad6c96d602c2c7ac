/* Freezing a scene: missing parts are added (METHODS 4), every index and range is checked, so that no kernel has to,
 * and the vertices of each object become one range. */
#include <stdio.h>
#include <stdlib.h>
#include "kernels/base/shade.h"
#include "model/core.h"
#include "scene/build_parts.h"
#include "scene/sources.h"
#include "scene/surfel.h"
#include "scene/view.h"

static void give_material(ts_build *build)
{
	ts_scene *scene = build->scene;
	u32 fallback = TS_NONE;
	for (u32 i = 0; i < scene->n_triangles && !ts_build_failed(build); i++) {
		if (scene->triangles[i].material != TS_NONE) continue;
		ts_material plain = ts_material_default();
		if (fallback == TS_NONE) fallback = ts_build_material(build, &plain);
		scene->triangles[i].material = fallback;
	}
}

static void give_light(ts_build *build, const ts_params *params)
{
	ts_scene *scene = build->scene;
	scene->info.ambient = 0.0f;
	if (scene->n_lights > 0) return;
	f32 irradiance = TS_PARAM(params, light_irradiance);
	ts_light sun = {.kind = TS_LIGHT_KIND_DIRECTIONAL, .intensity = {irradiance, irradiance, irradiance}};
	ts_store3(sun.direction, ts_v3_make(-0.4f, -1.0f, -0.3f));
	ts_build_light(build, &sun);
	scene->info.ambient = ts_san(TS_PARAM(params, light_ambient));
}

static void check_triangles(ts_build *build)
{
	const ts_scene *scene = build->scene;
	for (u32 i = 0; i < scene->n_triangles && !ts_build_failed(build); i++) {
		const ts_triangle *t = &scene->triangles[i];
		for (u32 k = 0; k < 3; k++)
			if (t->vertex[k] >= scene->n_vertices)
				ts_build_fail(build, "%s: triangle %u: vertex %u does not exist; there are %u", scene->name, i,
				              t->vertex[k], scene->n_vertices);
		if (t->material >= scene->n_materials)
			ts_build_fail(build, "%s: triangle %u: material %u does not exist; there are %u", scene->name, i,
			              t->material, scene->n_materials);
		if (build->failed) return;
		u32 object = scene->vertices[t->vertex[0]].object;
		if (object != scene->vertices[t->vertex[1]].object || object != scene->vertices[t->vertex[2]].object)
			ts_build_fail(build, "%s: triangle %u: its corners belong to different objects", scene->name, i);
	}
}

/* Bound of |x|, |y| and |z|, wherever the vertex's object moves. */
static f32 reach(const ts_scene *scene, const ts_vertex *vertex)
{
	const ts_object *o = &scene->objects[vertex->object];
	f32 x = ts_abs(vertex->position[0]), y = ts_abs(vertex->position[1]), z = ts_abs(vertex->position[2]);
	if (o->period == 0) return ts_max(ts_max(x, y), z);
	f32 across = ts_max(ts_abs(o->centre[0]) + ts_abs(o->axis[0]), ts_abs(o->centre[2]) + ts_abs(o->axis[1]));
	return ts_max(x + z + across, y + ts_abs(o->centre[1]) + ts_abs(o->bob));
}

static void check_vertices(ts_build *build)
{
	const ts_scene *scene = build->scene;
	for (u32 i = 0; i < scene->n_vertices && !ts_build_failed(build); i++) {
		f32 far = reach(scene, &scene->vertices[i]);
		if (far > TS_COORDINATE_LIMIT)
			ts_build_fail(build, "%s: vertex %u: coordinate %g; the limit is 16777216 after all transforms",
			              scene->name, i, (double)far);
	}
	for (u32 i = 1; i < scene->n_objects && !build->failed; i++)
		if (scene->objects[i].n_vertices == 0) ts_build_fail(build, "%s: object %u has no vertices", scene->name, i);
}

static void check_materials(ts_build *build)
{
	const ts_scene *scene = build->scene;
	for (u32 i = 0; i < scene->n_materials; i++) {
		const ts_material *m = &scene->materials[i];
		for (u32 k = 0; k < TS_N_SLOTS; k++)
			if (m->slot[k] != TS_NONE && m->slot[k] >= scene->n_slots)
				ts_build_fail(build, "%s: material %u: texture reference %u does not exist; there are %u", scene->name,
				              i, m->slot[k], scene->n_slots);
		if (m->flags > (TS_DOUBLE_SIDED | TS_MASKED | TS_UNLIT))
			ts_build_fail(build, "%s: material %u: flags %u; 0 to 7 are known", scene->name, i, m->flags);
	}
	for (u32 i = 0; i < scene->n_slots; i++) {
		const ts_slot *s = &scene->slots[i];
		if (s->image >= scene->n_images)
			ts_build_fail(build, "%s: texture reference %u: image %u does not exist; there are %u", scene->name, i,
			              s->image, scene->n_images);
		if (s->uv_set > 1)
			ts_build_fail(build, "%s: texture reference %u: TEXCOORD_%u; 0 and 1 are read", scene->name, i, s->uv_set);
		if (s->wrap[0] > TS_CLAMP || s->wrap[1] > TS_CLAMP)
			ts_build_fail(build, "%s: texture reference %u: wrap modes %u and %u; 0, 1 and 2 are known", scene->name, i,
			              s->wrap[0], s->wrap[1]);
	}
}

static void check_lights(ts_build *build)
{
	const ts_scene *scene = build->scene;
	for (u32 i = 0; i < scene->n_lights; i++) {
		const ts_light *l = &scene->lights[i];
		bool aimless = l->direction[0] == 0.0f && l->direction[1] == 0.0f && l->direction[2] == 0.0f;
		if (l->kind > TS_LIGHT_KIND_SPOT)
			ts_build_fail(build, "%s: light %u: kind %u; 0, 1 and 2 are known", scene->name, i, l->kind);
		if (l->kind != TS_LIGHT_KIND_POINT && aimless)
			ts_build_fail(build, "%s: light %u: no direction; it must have a length above zero", scene->name, i);
	}
}

/* Stable, by object. The objects' counts are already right. */
static void group_vertices(ts_build *build)
{
	ts_scene *scene = build->scene;
	bool grouped = true;
	u32 first = 0;
	for (u32 i = 0; i < scene->n_objects; i++) {
		scene->objects[i].first_vertex = first;
		first += scene->objects[i].n_vertices;
	}
	for (u32 i = 1; i < scene->n_vertices; i++)
		grouped = grouped && scene->vertices[i - 1].object <= scene->vertices[i].object;
	if (grouped) return;
	ts_vertex *vertices = ts_alloc(scene->n_vertices, sizeof *vertices, "vertices");
	u32 *place = ts_alloc(scene->n_vertices, sizeof *place, "places of vertices");
	u32 *next = ts_alloc(scene->n_objects, sizeof *next, "places of objects");
	if (vertices && place && next) {
		for (u32 i = 0; i < scene->n_objects; i++) next[i] = scene->objects[i].first_vertex;
		for (u32 i = 0; i < scene->n_vertices; i++) {
			place[i] = next[scene->vertices[i].object]++;
			vertices[place[i]] = scene->vertices[i];
		}
		for (u32 i = 0; i < scene->n_triangles; i++)
			for (u32 k = 0; k < 3; k++) scene->triangles[i].vertex[k] = place[scene->triangles[i].vertex[k]];
		ts_vertex *old = scene->vertices;
		scene->vertices = vertices;
		vertices = old;
	} else {
		ts_build_adopt(build);
	}
	free(vertices);
	free(place);
	free(next);
}

/* Counts static triangles, which are those of the file. Degenerate by CONTRACT rule 35. */
static void count_triangles(ts_build *build)
{
	ts_scene *scene = build->scene;
	u32 n_given = build->placed ? build->n_given : scene->n_triangles;
	for (u32 i = 0; i < n_given; i++) {
		const ts_vertex *v[3];
		for (u32 k = 0; k < 3; k++) v[k] = &scene->vertices[scene->triangles[i].vertex[k]];
		if (scene->objects[v[0]->object].period != 0) continue;
		ts_v3 a = ts_load3(v[0]->position);
		ts_v3 n = ts_cross(ts_sub(ts_load3(v[1]->position), a), ts_sub(ts_load3(v[2]->position), a));
		scene->n_triangles_file++;
		scene->n_degenerate += ts_flush(ts_dot(n, n)) == 0.0f;
	}
}

u32 ts_scene_camera(const ts_scene *scene, const char *name)
{
	for (u32 i = 0; name && i < scene->n_cameras; i++)
		if (strcmp(scene->cameras[i].name, name) == 0) return i;
	return TS_NONE;
}

static void choose_camera(ts_build *build, const char *name)
{
	ts_scene *scene = build->scene;
	char names[256] = "";
	scene->camera = ts_scene_camera(scene, name);
	ts_view_choose(&scene->info, scene->camera != TS_NONE ? &scene->cameras[scene->camera] : NULL);
	if (!name || scene->camera != TS_NONE) return;
	ts_build_about(build, TS_KIND_ARGUMENT);
	if (scene->n_cameras == 0)
		ts_build_fail(build, "%s: camera %s: the scene has no cameras; without a name the eye circles", scene->name,
		              name);
	for (u32 i = 0; i < scene->n_cameras; i++) {
		size_t used = strlen(names);
		snprintf(names + used, sizeof names - used, "%s%s", i ? ", " : "", scene->cameras[i].name);
	}
	ts_build_fail(build, "%s: camera %s does not exist; there are: %s", scene->name, name, names);
}

static void check_surfels(ts_build *build)
{
	const ts_scene *scene = build->scene;
	for (u32 i = 0; i < scene->n_surfels && !ts_build_failed(build); i++) {
		ts_surfel s = scene->surfels[i];
		f32 far = ts_max(ts_max(ts_abs(s.centre[0]), ts_abs(s.centre[1])), ts_abs(s.centre[2]));
		const char *fault = ts_surfel_ellipse(&s, NULL);
		if (fault != NULL) ts_build_fail(build, "%s: surfel %u: %s", scene->name, i, fault);
		if (far > TS_COORDINATE_LIMIT)
			ts_build_fail(build, "%s: surfel %u: coordinate %g; the limit is 16777216 after all transforms",
			              scene->name, i, (double)far);
	}
}

/* Moves the chosen camera, if the file animates it. */
static void set_off(ts_scene *scene)
{
	ts_camera *camera = scene->camera != TS_NONE ? &scene->cameras[scene->camera] : NULL;
	if (camera == NULL || camera->n_path == 0) return;
	scene->path = camera->path;
	scene->n_path = camera->n_path;
	for (u32 i = 0; i < scene->n_path; i++) scene->path[i].yfov = scene->info.yfov;
	scene->info.circles = TS_CIRCLES_PATH;
	camera->path = NULL;
	camera->n_path = 0;
}

#define COARSE 8192.0f /* a box that has less than 1024 steps of binary32 at its greatest coordinate */
#define FAR 1024.0f    /* a box of one place is noted from here on */

/* Before mirrors are added the box is that of what the file draws. */
static void note_coarse(ts_build *build)
{
	const ts_info *info = &build->scene->info;
	f32 extent = 0.0f, far = 0.0f;
	for (u32 k = 0; k < 3; k++) {
		extent = ts_max(extent, info->box_max[k] - info->box_min[k]);
		far = ts_max(far, ts_max(ts_abs(info->box_min[k]), ts_abs(info->box_max[k])));
	}
	if (extent * COARSE < far && (extent > 0.0f || far > FAR))
		ts_build_note(build,
		              "the scene is %g large and %g from the origin, where binary32 has steps of %g: move it there",
		              (double)extent, (double)far, (double)ts_u2f(ts_f2u(far) & 0x7f800000u) * 0x1p-23);
}

static void note_colours(ts_build *build)
{
	if (build->n_outside > 0)
		ts_build_note(build,
		              "%llu vertices or points have colours outside 0 to 1, which are read as the nearest inside",
		              (unsigned long long)build->n_outside);
}

static void complete(ts_build *build, const ts_params *params, const char *camera)
{
	if (!build->failed) give_material(build);
	if (!build->failed) give_light(build, params);
	if (!build->failed) check_triangles(build);
	if (!build->failed) check_vertices(build);
	if (!build->failed) check_materials(build);
	if (!build->failed) check_lights(build);
	if (!build->failed) choose_camera(build, camera);
	if (build->failed) return;
	ts_build_measure(build);
	note_coarse(build);
	note_colours(build);
	count_triangles(build);
	ts_sample_add(build, params);
	check_surfels(build);
	if (!build->failed) set_off(build->scene);
	ts_build_set_in_motion(build);
	if (!build->failed) group_vertices(build);
}

ts_status ts_build_finish(ts_build *build, const ts_params *params, const char *camera, ts_scene **scene)
{
	*scene = NULL;
	if (!build) return TS_ERROR;
	complete(build, params, camera);
	ts_status status = TS_OK;
	if (ts_build_failed(build)) {
		status = ts_fail_as(build->kind, "%s", build->message);
	} else {
		*scene = build->scene;
		build->scene = NULL;
	}
	ts_build_free(build);
	return status;
}
