/* Objects that the file animates (METHODS 2). While a scene is built they stand as at frame 0, so that box, hall, eye,
 * mirrors and lamps are found around them; at the end their vertices return to their own space. */
#include <inttypes.h>
#include <stdlib.h>
#include "model/core.h"
#include "scene/build_parts.h"

void ts_build_motion(ts_build *build, const ts_motion *frames, u32 n)
{
	if (build->failed) return;
	build->motions = ts_build_room(build, build->motions, build->n_motions, 1, &build->capacity.motions,
	                               sizeof *build->motions, "moving objects");
	ts_motion *copy = build->failed ? NULL : ts_alloc(n, sizeof *copy, "places of a moving object");
	if (copy == NULL) {
		ts_build_adopt(build);
		return;
	}
	memcpy(copy, frames, n * sizeof *copy);
	build->motions[build->n_motions].object = build->object;
	build->motions[build->n_motions++].frames = copy;
	build->n_frames = n;
}

void ts_build_motions_free(ts_build *build)
{
	for (u32 i = 0; i < build->n_motions; i++) free(build->motions[i].frames);
	free(build->motions);
	free(build->own);
}

/* Bound of |x|, |y| and |z| of an object's vertices at a frame; reach: the same in its own space. */
static f32 farthest(const ts_motion *at, const f32 reach[3])
{
	f32 far = 0.0f;
	for (u32 i = 0; i < 3; i++) {
		f32 sum = ts_abs(at->origin[i]);
		for (u32 k = 0; k < 3; k++) sum += ts_abs(at->linear[3 * i + k]) * reach[k];
		far = ts_max(far, sum);
	}
	return far;
}

static void check_reach(ts_build *build)
{
	const ts_scene *scene = build->scene;
	f32(*reach)[3] = ts_alloc_zero(scene->n_objects, sizeof *reach, "extents of objects");
	if (reach == NULL) ts_build_adopt(build);
	for (u32 i = 0; i < scene->n_vertices && reach != NULL; i++) {
		const ts_vertex *v = &scene->vertices[i];
		for (u32 k = 0; k < 3; k++) reach[v->object][k] = ts_max(reach[v->object][k], ts_abs(v->position[k]));
	}
	for (u32 m = 0; m < build->n_motions && reach != NULL; m++) {
		u32 object = build->motions[m].object;
		for (u32 frame = 0; frame < build->n_frames; frame++) {
			f32 far = farthest(&build->motions[m].frames[frame], reach[object]);
			if (far > TS_COORDINATE_LIMIT)
				ts_build_fail(build, "%s: object %u: coordinate %g at frame %u of its animation; the limit is 16777216",
				              scene->name, object, (double)far, frame);
		}
	}
	free(reach);
}

static void give_motion(ts_build *build)
{
	ts_scene *scene = build->scene;
	u64 n = (u64)build->n_frames * scene->n_objects;
	if (n > TS_MOTION_MAX_PLACES) {
		ts_build_fail(build, "%s: %u frames of %u objects are %" PRIu64 " places; at most %u are kept", scene->name,
		              build->n_frames, scene->n_objects, n, TS_MOTION_MAX_PLACES);
		return;
	}
	scene->motion = ts_alloc_zero(n, sizeof *scene->motion, "places of moving objects");
	if (scene->motion == NULL) {
		ts_build_adopt(build);
		return;
	}
	scene->n_motion = build->n_frames;
	for (u32 m = 0; m < build->n_motions; m++)
		for (u32 frame = 0; frame < scene->n_motion; frame++)
			scene->motion[(u64)frame * scene->n_objects + build->motions[m].object] = build->motions[m].frames[frame];
}

void ts_build_set_in_motion(ts_build *build)
{
	ts_scene *scene = build->scene;
	if (build->n_motions == 0) return;
	for (u32 m = 0; m < build->n_motions; m++) scene->objects[build->motions[m].object].period = build->n_frames;
	for (u32 i = 0, own = 0; i < scene->n_vertices && own < build->n_own; i++)
		if (scene->vertices[i].object == build->own[own].object) scene->vertices[i] = build->own[own++];
	check_reach(build);
	if (!build->failed) give_motion(build);
}
