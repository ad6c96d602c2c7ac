/* Added after the triangles: the eye, the subject of the pictures, a ground, mirrors and lamps. */
#include <stdlib.h>
#include <string.h>
#include "kernels/base/vec.h"
#include "model/core.h"
#include "scene/build_parts.h"
#include "scene/sources.h"
#include "scene/view.h"

#define GROUND 2.5f /* half a side, in half diagonals of the scene's box */

/* A square under the box of a scene without a ground: shadows need a receiver. */
static void lay_ground(ts_build *build, const ts_info *info)
{
	ts_space box = ts_view_box(info);
	f32 reach = ts_length(box.half) * GROUND, floor = info->box_min[1];
	ts_material material = ts_material_default();
	ts_build_select(build, 0);
	u32 corner[4], grey = ts_build_material(build, &material);
	for (u32 k = 0; k < 4; k++) {
		ts_vertex v = {.position = {box.middle.x + (k == 0 || k == 3 ? -reach : reach), floor,
		                            box.middle.z + (k < 2 ? reach : -reach)},
		               .normal = {0.0f, 1.0f, 0.0f},
		               .colour = {0.5f, 0.5f, 0.5f, 1.0f}};
		corner[k] = ts_build_vertex(build, &v);
	}
	ts_build_triangle(build, corner[0], corner[1], corner[2], grey);
	ts_build_triangle(build, corner[0], corner[2], corner[3], grey);
}

#define EYE_NAME "--eye"

/* Static ones; as many may be added on paths. */
enum { MOST_MIRRORS = 1000 };

static bool is_finite(const f32 *x, u32 n)
{
	for (u32 i = 0; i < n; i++) {
		if (!(ts_abs(x[i]) <= TS_COORDINATE_LIMIT)) return false;
	}
	return true;
}

static void check_point(ts_build *build, const char *what, const f32 *point)
{
	if (point != NULL && !is_finite(point, 3))
		ts_build_fail(build, "%s: %s: a coordinate is not finite or beyond 16777216", build->scene->name, what);
}

static void check_options(ts_build *build, const ts_scene_options *o)
{
	check_point(build, "eye", o->eye);
	check_point(build, "target", o->target);
	check_point(build, "lamp", o->lamp);
	if (o->target != NULL && o->eye == NULL)
		ts_build_fail(build, "%s: target: an eye that looks at it must be given, too", build->scene->name);
	if (o->path != NULL && (o->eye != NULL || o->target != NULL || o->camera != NULL))
		ts_build_fail(build, "%s: path: %s is asked for, too; choose one of them", build->scene->name,
		              o->camera != NULL ? "a camera" : "an eye or target");
	if (o->eye != NULL && o->camera != NULL)
		ts_build_fail(build, "%s: eye: camera %s is asked for, too; choose one of them", build->scene->name, o->camera);
	if (o->eye != NULL && o->target != NULL && memcmp(o->eye, o->target, 3 * sizeof(f32)) == 0)
		ts_build_fail(build, "%s: eye: it is its target; it must look at another point", build->scene->name);
	if (o->n_mirrors > MOST_MIRRORS || (o->n_mirrors > 0 && o->mirrors == NULL))
		ts_build_fail(build, "%s: %u mirrors; at most %d, and an array of them, would be right", build->scene->name,
		              o->n_mirrors, MOST_MIRRORS);
	for (u32 i = 0; i < o->n_mirrors && !build->failed; i++) {
		if (!is_finite(o->mirrors[i], 4))
			ts_build_fail(build, "%s: mirror %u: a number is not finite or beyond 16777216", build->scene->name, i);
		if (!(o->mirrors[i][3] > 0.0f))
			ts_build_fail(build, "%s: mirror %u: its radius must be above 0", build->scene->name, i);
	}
}

static void add_eye(ts_build *build, const ts_scene_options *o)
{
	ts_camera camera = {.name = EYE_NAME};
	ts_v3 eye = ts_load3(o->eye), target = ts_view_box(&ts_build_peek(build)->info).middle;
	if (o->target != NULL) target = ts_load3(o->target);
	if (ts_length(ts_sub(eye, target)) == 0.0f) target = ts_sub(target, ts_v3_make(0.0f, 0.0f, 1.0f));
	ts_store3(camera.eye, eye);
	ts_view_aim(camera.right, camera.up, camera.back, eye, target);
	ts_build_camera(build, &camera);
}

/* The camera's name; NULL: the eye circles. */
static const char *choose(ts_build *build, const ts_scene_options *o, bool find)
{
	if (o->eye != NULL) add_eye(build, o);
	if (build->failed) return NULL;
	if (o->path != NULL) return ts_path_add(build, o->path, o->own_fov != 0);
	if (o->eye != NULL) return EYE_NAME;
	if (o->camera != NULL) return strcmp(o->camera, TS_CAMERA_CIRCLE) != 0 ? o->camera : NULL;
	return find && build->scene->n_cameras > 0 ? build->scene->cameras[0].name : NULL;
}

/* Rays against the triangles so far; NULL if the build fails. */
static ts_rays *rays_of(ts_build *build)
{
	ts_rays *rays = build->failed ? NULL : ts_rays_new(build->scene);
	if (rays == NULL) ts_build_adopt(build);
	return rays;
}

/* Box, hall and eye of the build without additions: by rays, or without these by its triangles. */
static void find_subject(ts_build *build, const ts_rays *rays, const ts_params *params, const char *camera)
{
	ts_scene *scene = build->scene;
	ts_info *info = &scene->info;
	u32 index = ts_scene_camera(scene, camera);
	if (rays != NULL) {
		ts_subject_crop(info, scene);
		ts_build_walls(build);
	}
	ts_view_choose(info, index != TS_NONE ? &scene->cameras[index] : NULL);
	if (rays != NULL) ts_subject_find(info, rays, scene, params);
	build->place = *info;
	build->placed = true;
}

/* Adds ground under the whole scene, whatever part is the subject. If there are rays, they meet it from here on. */
static void add_ground(ts_build *build, ts_rays **rays, const ts_info *whole)
{
	lay_ground(build, whole);
	if (*rays == NULL) return;
	ts_rays_free(*rays);
	*rays = rays_of(build);
}

/* Surfels show no mirrors: scenes of surfels alone, or shown without the rest, get none. */
static bool shows_mirrors(const ts_scene *scene, const ts_params *params)
{
	return TS_PARAM(params, surfels_from_mesh) == 0 && (scene->n_surfels == 0 || scene->n_triangles > 0);
}

static void add_stands(ts_build *build, const ts_rays *rays, const ts_params *params, const f32 *lamp)
{
	ts_scene *scene = build->scene;
	if (rays == NULL && lamp == NULL) return;
	const ts_info *info = &ts_build_peek(build)->info;
	scene->stands = ts_alloc(TS_N_STANDS, sizeof *scene->stands, "places of lamps");
	if (scene->stands == NULL) {
		ts_build_adopt(build);
		return;
	}
	scene->n_stands = TS_N_STANDS;
	if (rays != NULL) {
		scene->n_stands = ts_lamp_place(scene->stands, info, rays, params, lamp) ? TS_N_STANDS : 0;
		return;
	}
	ts_lamp_stands(scene->stands, info);
	for (u32 k = 0; k < TS_N_STANDS; k++) ts_store3(scene->stands[k].position, ts_load3(lamp));
}

/* Options whose places are counted from the scene's origin. */
typedef struct {
	ts_scene_options options;
	f32 eye[3], target[3], lamp[3], (*mirrors)[4];
} moved;

static const f32 *counted(f32 to[3], const f32 *from, const double *origin)
{
	for (u32 k = 0; k < 3 && from != NULL; k++) to[k] = (f32)((double)from[k] - origin[k]);
	return from != NULL ? to : NULL;
}

static void move_options(moved *m, ts_build *build, const ts_scene_options *o)
{
	const double *origin = build->scene->origin;
	*m = (moved){.options = *o};
	m->options.eye = counted(m->eye, o->eye, origin);
	m->options.target = counted(m->target, o->target, origin);
	m->options.lamp = counted(m->lamp, o->lamp, origin);
	if (o->n_mirrors == 0 || o->n_mirrors > MOST_MIRRORS || o->mirrors == NULL) return;
	m->mirrors = ts_alloc(o->n_mirrors, sizeof *m->mirrors, "mirrors");
	if (m->mirrors == NULL) ts_build_adopt(build);
	for (u32 i = 0; i < o->n_mirrors && m->mirrors != NULL; i++) {
		counted(m->mirrors[i], o->mirrors[i], origin);
		m->mirrors[i][3] = o->mirrors[i][3];
	}
	m->options.mirrors = (const f32(*)[4])m->mirrors;
}

static const char *arrange(ts_build *build, const ts_params *params, const ts_scene_options *o, bool find);

const char *ts_arrange(ts_build *build, const ts_params *params, const ts_scene_options *options, bool find)
{
	static const ts_scene_options none;
	moved m;
	move_options(&m, build, options != NULL ? options : &none);
	const char *camera = arrange(build, params, &m.options, find);
	free(m.mirrors);
	return camera;
}

static const char *arrange(ts_build *build, const ts_params *params, const ts_scene_options *o, bool find)
{
	bool circle = o->camera != NULL && strcmp(o->camera, TS_CAMERA_CIRCLE) == 0;
	if (build->failed) return NULL;
	const ts_kind before = ts_build_about(build, TS_KIND_ARGUMENT);
	check_options(build, o);
	const char *camera = choose(build, o, find);
	for (u32 i = 0; i < build->scene->n_cameras && o->own_fov; i++) build->scene->cameras[i].yfov = 0.0f;
	ts_build_measure(build);
	const ts_info whole = build->scene->info;
	const bool mirrors = shows_mirrors(build->scene, params);
	ts_rays *rays = find && !circle ? rays_of(build) : NULL;
	if (!build->failed) find_subject(build, rays, params, camera);
	if (find && TS_PARAM(params, scene_ground)) add_ground(build, &rays, &whole);
	if (build->failed) {
		ts_rays_free(rays);
		return NULL;
	}
	build->n_given = build->scene->n_triangles;
	if (mirrors) ts_reflectors_add(build, params, camera, rays);
	ts_reflectors_stand(build, o->mirrors, o->n_mirrors);
	add_stands(build, rays, params, o->lamp);
	ts_rays_free(rays);
	ts_build_about(build, before);
	return camera;
}
