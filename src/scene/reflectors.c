/* The added reflectors (EPR 4.2; METHODS 4): golden-angle phases on ellipses around the middle of the hall's floor,
 * turning as the eye does, and one radius for all, so that their mean projected diameter at frame 0 is reflector_px. */
#include "../kernels/base/pose.h"
#include "shapes.h"
#include "sources.h"
#include "view.h"

#define INNER 0.6f      /* of half the hall */
#define CLEARANCE 0.16f /* from the eye, in halves of the hall */
#define WIDEST 0.35f    /* radius, of the shorter half of the hall */

/* What the places of the reflectors follow from. */
typedef struct {
	ts_space hall;
	ts_view eye;
	u32 n;
} floor_plan;

static f32 fraction(f32 x) { return x - ts_floor(x); }

static void plan_make(floor_plan *plan, const ts_scene *scene, const ts_params *params, const char *camera)
{
	ts_info seen = scene->info;
	ts_params first = *params;
	u32 index = ts_scene_camera(scene, camera);
	ts_view_choose(&seen, index != TS_NONE ? &scene->cameras[index] : NULL);
	TS_PARAM_SET(&first, frame, 0);
	ts_view_eye(&plan->eye, &seen, &first);
	plan->hall = ts_view_hall(&scene->info);
	plan->n = TS_PARAM(params, reflectors_count);
}

/* The size of the ellipse in halves of the hall: equal areas a reflector, but not where the eye is. */
static f32 ellipse(const floor_plan *plan, u32 i, f32 phase)
{
	f32 size = INNER * ts_sqrt(((f32)i + 0.5f) / (f32)plan->n);
	f32 x = (plan->eye.eye[0] - plan->hall.middle.x) / plan->hall.half.x;
	f32 z = (plan->eye.eye[2] - plan->hall.middle.z) / plan->hall.half.z;
	ts_v3 apart = ts_v3_make(size * ts_cos_turn(phase) - x, 0.0f, size * ts_sin_turn(phase) - z);
	if (ts_length(apart) >= CLEARANCE) return size;
	f32 away = ts_length(ts_v3_make(x, 0.0f, z));
	return away >= CLEARANCE ? away - CLEARANCE : away + CLEARANCE;
}

/* Heights spread over the lower part of the box; the reflector stands on the floor where the box is too low. */
static ts_object path(const floor_plan *plan, u32 i, f32 radius)
{
	f32 height = plan->hall.half.y + plan->hall.half.y;
	f32 phase = fraction(0.618034f * (f32)i);
	f32 size = ellipse(plan, i, phase);
	f32 bob = height * 0.02f;
	f32 up = height * (0.1f + 0.5f * fraction(0.7548777f * (f32)i));
	up = ts_min(up, height - radius - bob);
	up = ts_max(up, radius + bob);
	ts_object object = {.period = TS_FRAMES_A_TURN, .phase = phase, .bob = bob, .spin = 2.0f};
	f32 floor = plan->hall.middle.y - plan->hall.half.y;
	ts_store3(object.centre, ts_v3_make(plan->hall.middle.x, floor + up, plan->hall.middle.z));
	object.axis[0] = ts_put(plan->hall.half.x * size);
	object.axis[1] = ts_put(plan->hall.half.z * size);
	return object;
}

/* Pixels across of a sphere of radius 1 there: by its axial depth where the eye can see it, else by its distance. */
static f32 pixels_across(const ts_view *eye, ts_v3 centre)
{
	ts_v3 d = ts_sub(centre, ts_load3(eye->eye));
	f32 z = -ts_dot(d, ts_load3(eye->back));
	f32 x = eye->focal * ts_abs(ts_dot(d, ts_load3(eye->right)));
	f32 y = eye->focal * ts_abs(ts_dot(d, ts_load3(eye->up)));
	bool seen = z > 0.0f && x + x <= z * (f32)eye->width && y + y <= z * (f32)eye->height;
	f32 distance = ts_max(seen ? z : ts_length(d), eye->near);
	return 2.0f * eye->focal / distance;
}

static f32 mean_pixels_across(const floor_plan *plan, f32 radius)
{
	f32 sum = 0.0f;
	for (u32 i = 0; i < plan->n; i++) {
		ts_object object = path(plan, i, radius);
		ts_pose pose = ts_k_pose(&object, 0);
		sum = sum + pixels_across(&plan->eye, pose.centre);
	}
	return sum / (f32)plan->n;
}

/* The heights depend on the radius, a little: a few rounds settle it. */
static f32 radius_for(ts_build *build, const floor_plan *plan, f32 pixels)
{
	f32 widest = ts_min(plan->hall.half.x, plan->hall.half.z) * WIDEST;
	f32 radius = 0.0f;
	for (u32 round = 0; round < 4; round++) radius = ts_min(pixels / mean_pixels_across(plan, radius), widest);
	if (radius == widest)
		ts_build_note(build, "the added reflectors are %g px across instead of reflectors.px=%g, so that they fit",
		              (double)(radius * mean_pixels_across(plan, radius)), (double)pixels);
	return radius;
}

/* Reflectances of polished metals, most of them pale. */
static const f32 tints[][3] = {
	{0.97f, 0.96f, 0.92f}, {1.0f, 0.86f, 0.57f}, {0.85f, 0.92f, 0.98f}, {0.96f, 0.78f, 0.7f},
	{0.91f, 0.92f, 0.92f}, {0.9f, 0.97f, 0.88f}, {0.95f, 0.9f, 0.83f},  {0.93f, 0.88f, 0.97f},
};
enum { N_TINTS = sizeof tints / sizeof *tints };

static u32 make_material(ts_build *build, const f32 tint[3])
{
	ts_material material = ts_material_default();
	memcpy(material.base, tint, 3 * sizeof *tint);
	material.metallic = 1.0f;
	material.roughness = 0.05f;
	return ts_build_material(build, &material);
}

/* Surfels show no mirrors: where there is nothing else, or is to be nothing else, none are added. */
static bool is_for_surfels(ts_build *build, const ts_params *params)
{
	const ts_scene *scene = ts_build_peek(build);
	return TS_PARAM(params, surfels_from_mesh) > 0 || (scene->n_surfels > 0 && scene->n_triangles == 0);
}

void ts_reflectors_add(ts_build *build, const ts_params *params, const char *camera)
{
	floor_plan plan;
	u32 materials[N_TINTS];
	if (TS_PARAM(params, reflectors_count) == 0 || ts_build_failed(build) || is_for_surfels(build, params)) return;
	plan_make(&plan, ts_build_peek(build), params, camera);
	f32 radius = radius_for(build, &plan, TS_PARAM(params, reflectors_px));
	for (u32 i = 0; i < plan.n; i++) {
		ts_object object = path(&plan, i, radius);
		u32 shape = TS_PARAM(params, reflectors_shape) == TS_SHAPE_MIXED ? i % TS_SHAPE_MIXED
		                                                                 : TS_PARAM(params, reflectors_shape);
		if (i < N_TINTS) materials[i] = make_material(build, tints[i]);
		ts_build_object(build, &object, true);
		ts_shape_add(build, shape, radius, materials[i % N_TINTS]);
	}
	ts_build_object(build, NULL, false);
}
