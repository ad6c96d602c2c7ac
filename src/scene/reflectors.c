/* The added reflectors (EPR 4.2; METHODS 4): golden-angle phases on ellipses around the middle of the hall's floor,
 * turning like the eye, and one radius for all, so that their mean projected diameter at frame 0 is reflectors.px. */
#include <stdlib.h>
#include "kernels/base/pose.h"
#include "model/core.h"
#include "scene/sources.h"
#include "scene/view.h"

#define INNER 0.6f          /* of half the hall */
#define CLEARANCE 0.16f     /* from the eye, in halves of the hall */
#define WIDEST 0.35f        /* radius, of the shorter half of the hall */
#define WIDEST_BESIDE 0.12f /* radius beside a thing, of half the box's diagonal */
#define TALLEST 0.25f       /* diameter, of the image's height, where rays find the places */
#define ROOMY 1.05f         /* clearance about a mirror, in radii */
#define CLOSE 0.984375f     /* of the requested mean; mirrors may grow by the rest within their clearance */
enum { N_TRIES = 128, N_ROUNDS = 6 };

/* Inputs of the reflectors' places. */
typedef struct {
	ts_space hall;
	ts_view eye;
	u32 n;
	const ts_rays *rays; /* NULL: the paths alone decide the places */
	bool stands, open;   /* the eye stands still; there are no walls */
} floor_plan;

static f32 fraction(f32 x) { return x - ts_floor(x); }

static void plan_make(floor_plan *plan, const ts_scene *scene, const ts_params *params, const char *camera,
                      const ts_rays *rays)
{
	ts_info seen = scene->info;
	ts_params first = *params;
	u32 index = ts_scene_camera(scene, camera);
	if (rays == NULL) ts_view_choose(&seen, index != TS_NONE ? &scene->cameras[index] : NULL);
	TS_PARAM_SET(&first, frame, 0);
	ts_view_eye(&plan->eye, &seen, &first);
	plan->hall = ts_view_hall(&scene->info);
	plan->n = TS_PARAM(params, reflectors_count);
	plan->rays = rays;
	plan->stands = seen.circles == TS_CIRCLES_NOT;
	plan->open = ts_view_is_open(&scene->info);
}

/* The size of the ellipse in halves of the hall: equal areas per reflector, except near the eye. */
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

/* Projected diameter of a unit sphere in pixels: by its axial depth where the eye can see it, otherwise by its
 * distance. */
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

/* Mean projected diameter of unit spheres at the reflectors' places of frame 0. */
static f32 mean_pixels_across(const floor_plan *plan, const ts_object *objects)
{
	f32 sum = 0.0f;
	for (u32 i = 0; i < plan->n; i++) {
		ts_pose pose = ts_k_pose(&objects[i], 0);
		sum = sum + pixels_across(&plan->eye, pose.centre);
	}
	return sum / (f32)plan->n;
}

static f32 widest(const floor_plan *plan)
{
	bool beside = plan->rays != NULL && plan->open;
	if (beside) return ts_length(plan->hall.half) * WIDEST_BESIDE;
	return ts_min(plan->hall.half.x, plan->hall.half.z) * WIDEST;
}

static ts_v3 place_of(const ts_object *object) { return ts_k_pose(object, 0).centre; }

/* Whether a ball of that radius may be at p in frame 0, beside the n placed ones. */
static bool is_free(const floor_plan *plan, ts_v3 p, f32 radius, const ts_object *objects, u32 n)
{
	f32 clear = radius * ROOMY;
	if (ts_length(ts_sub(p, ts_load3(plan->eye.eye))) < 3.0f * radius) return false;
	for (u32 i = 0; i < n; i++) {
		if (ts_length(ts_sub(place_of(&objects[i]), p)) < 2.1f * radius) return false;
	}
	return ts_rays_clearance(plan->rays, p, clear) >= clear && !ts_rays_is_inside(plan->rays, p);
}

/* Whether the eye sees p, and a ball there is not too large in the image. */
static bool is_seen(const floor_plan *plan, ts_v3 p, f32 radius)
{
	f32 depth, height = (f32)plan->eye.height;
	if (!ts_view_holds(&plan->eye, p, 0.0f, &depth)) return false;
	return 2.0f * radius * plan->eye.focal <= depth * height * (1.5f * TALLEST) &&
	       ts_rays_free_between(plan->rays, ts_load3(plan->eye.eye), p);
}

/* Whether the reflector may keep its path without rays. */
static bool keeps_path(const floor_plan *plan, const ts_object *object, f32 radius, const ts_object *objects, u32 n)
{
	ts_v3 p = place_of(object);
	if (plan->open || !is_free(plan, p, radius, objects, n)) return false;
	if (plan->stands) return is_seen(plan, p, radius);
	return ts_rays_free_between(plan->rays, ts_load3(plan->eye.eye), p) ||
	       ts_rays_free_between(plan->rays, plan->hall.middle, p);
}

/* Candidate k: along a ray of the eye; false if it would hide a thing, or is outside the hall. */
static bool candidate(ts_v3 *p, const floor_plan *plan, u32 k)
{
	f32 x = 0.08f + 0.84f * fraction(0.7548777f * (f32)k), y = 0.1f + 0.8f * fraction(0.56984f * (f32)k);
	f32 share = fraction(0.618034f * (f32)k), distance;
	ts_v3 eye = ts_load3(plan->eye.eye);
	ts_v3 way = ts_view_way(&plan->eye, x * (f32)plan->eye.width, y * (f32)plan->eye.height);
	f32 size = ts_length(plan->hall.half), far = ts_length(ts_sub(plan->hall.middle, eye));
	bool hits = ts_rays_cast(&distance, plan->rays, eye, way, far + 3.0f * size) != TS_NONE;
	if (plan->open) {
		f32 along = far + (share - 0.5f) * size;
		*p = ts_mad(eye, way, along);
		return !hits || distance > far + size;
	}
	*p = ts_mad(eye, way, distance * (0.25f + 0.65f * share));
	ts_v3 in = ts_sub(*p, plan->hall.middle), half = plan->hall.half;
	return ts_abs(in.x) <= half.x && ts_abs(in.y) <= half.y && ts_abs(in.z) <= half.z;
}

/* A path about the middle of the hall, through p in frame 0. */
static ts_object path_through(const floor_plan *plan, ts_v3 p, f32 radius)
{
	f32 hx = plan->open ? 1.0f : plan->hall.half.x, hz = plan->open ? 1.0f : plan->hall.half.z;
	f32 x = (p.x - plan->hall.middle.x) / hx, z = (p.z - plan->hall.middle.z) / hz;
	f32 size = ts_length(ts_v3_make(x, 0.0f, z)), turns = ts_atan2(ts_san(z), ts_san(x)) * 0.15915494f;
	f32 phase = fraction(turns + 1.0f), bob = ts_min(plan->hall.half.y * 0.04f, radius * 0.25f);
	ts_object object = {.period = TS_FRAMES_A_TURN, .phase = phase, .bob = bob, .spin = 2.0f};
	f32 height = p.y - bob * ts_sin_turn(phase + phase);
	ts_store3(object.centre, ts_v3_make(plan->hall.middle.x, height, plan->hall.middle.z));
	object.axis[0] = ts_put(hx * size);
	object.axis[1] = ts_put(hz * size);
	return object;
}

/* Whether a mirror at p covers a thing without walls about it. */
static bool covers(const floor_plan *plan, ts_v3 p, f32 radius)
{
	f32 distance;
	ts_v3 eye = ts_load3(plan->eye.eye), right = ts_load3(plan->eye.right), up = ts_load3(plan->eye.up);
	for (u32 k = 0; k < 4 && plan->open; k++) {
		f32 x = k & 1 ? radius : -radius, y = k & 2 ? radius : -radius;
		ts_v3 way = ts_normalize(ts_sub(ts_mad(ts_mad(p, right, x), up, y), eye));
		f32 far = ts_length(ts_sub(p, eye)) + ts_length(plan->hall.half);
		if (ts_rays_cast(&distance, plan->rays, eye, way, far) != TS_NONE) return true;
	}
	return false;
}

/* The distance to the nearest of the n placed reflectors. */
static f32 apart(ts_v3 p, const ts_object *objects, u32 n)
{
	f32 least = TS_RAYS_FAR;
	for (u32 i = 0; i < n; i++) least = ts_min(least, ts_length(ts_sub(place_of(&objects[i]), p)));
	return least;
}

/* Chooses the free candidate in sight that is farthest from the others; one that covers a thing only where all do.
 * False if there is none. */
static bool find_place(ts_object *object, const floor_plan *plan, u32 i, f32 radius, const ts_object *objects)
{
	f32 best = -1.0f;
	bool uncovered = false;
	for (u32 k = 0; k < N_TRIES; k++) {
		ts_v3 p;
		bool clear = candidate(&p, plan, k + 1);
		if (uncovered && !clear) continue;
		f32 far = apart(p, objects, i);
		bool better = far > best || (clear && !uncovered);
		if (!better || !is_free(plan, p, radius, objects, i) || !is_seen(plan, p, radius)) continue;
		clear = clear && !covers(plan, p, radius);
		if (clear != uncovered ? !clear : far <= best) continue;
		best = far;
		uncovered = clear;
		*object = path_through(plan, p, radius);
	}
	return best >= 0.0f;
}

/* Returns how many have no free place and keep their paths. */
static u32 place_round(const floor_plan *plan, ts_object *objects, f32 radius)
{
	u32 n_lost = 0;
	for (u32 i = 0; i < plan->n; i++) {
		ts_object own = path(plan, i, radius);
		objects[i] = own;
		if (keeps_path(plan, &own, radius, objects, i)) continue;
		n_lost += !find_place(&objects[i], plan, i, radius, objects);
	}
	return n_lost;
}

/* Paths of all reflectors, and their radius. */
typedef struct {
	ts_object *objects;
	f32 radius;
	u32 n_lost; /* without a free place */
} placement;

/* The radius that would give the requested mean at these places. */
static f32 fitting_radius(const placement *p, const floor_plan *plan, f32 pixels)
{
	return ts_min(pixels / mean_pixels_across(plan, p->objects), widest(plan));
}

static void keep_paths(placement *p, const floor_plan *plan)
{
	for (u32 i = 0; i < plan->n; i++) p->objects[i] = path(plan, i, p->radius);
}

/* The heights depend slightly on the radius: a few rounds settle it. */
static void place_on_paths(placement *p, const floor_plan *plan, f32 pixels)
{
	for (u32 round = 0; round < 4; round++) {
		keep_paths(p, plan);
		p->radius = fitting_radius(p, plan, pixels);
	}
	keep_paths(p, plan);
}

static void swap(placement *a, placement *b)
{
	placement c = *a;
	*a = *b;
	*b = c;
}

/* Begins with the radius of `p`. Where reflectors are too small at their places, all grow and are placed anew. Where
 * more than an eighth have no free place they do not grow, or shrink until nearly all have. Last, those that are too
 * large shrink at their places, which stay free.
 * In:  other has room for as many. */
static void place_by_rays(placement *p, placement *other, const floor_plan *plan, f32 pixels)
{
	bool placed = false, crowded = false;
	other->radius = p->radius;
	for (u32 round = 0; round < N_ROUNDS; round++) {
		f32 radius = other->radius;
		other->n_lost = place_round(plan, other->objects, radius);
		bool too_many = other->n_lost * 8 > plan->n;
		if (too_many && placed) break;
		swap(p, other);
		placed = !too_many;
		crowded = crowded || too_many;
		other->radius = too_many ? radius * 0.75f : fitting_radius(p, plan, pixels);
		if (placed && (crowded || radius >= other->radius * CLOSE)) break;
	}
	f32 fitting = fitting_radius(p, plan, pixels);
	if (p->radius >= fitting * CLOSE) p->radius = fitting;
}

static void place_all(ts_build *build, placement *p, placement *other, const floor_plan *plan, f32 asked)
{
	f32 pixels = plan->rays != NULL ? ts_min(asked, (f32)plan->eye.height * TALLEST) : asked;
	place_on_paths(p, plan, pixels);
	if (plan->rays != NULL) place_by_rays(p, other, plan, pixels);
	f32 mean = p->radius * mean_pixels_across(plan, p->objects);
	if (mean < asked * CLOSE)
		ts_build_note(build, "the added reflectors are %g px across instead of reflectors.px=%g, so that they fit",
		              (double)mean, (double)asked);
	if (p->n_lost > 0) ts_build_note(build, "%u of the added reflectors have no free place in sight", p->n_lost);
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

/* Adds a static reflector. */
static void add_standing(ts_build *build, const f32 mirror[4], u32 material)
{
	ts_object object = {.period = 0};
	u32 first = ts_build_peek(build)->n_vertices;
	ts_build_object(build, &object, true);
	ts_shape_add(build, TS_SHAPE_SPHERE, mirror[3], material);
	ts_build_move(build, first, ts_load3(mirror));
}

void ts_reflectors_stand(ts_build *build, const f32 (*mirrors)[4], u32 n)
{
	for (u32 i = 0; i < n && !ts_build_failed(build); i++) {
		add_standing(build, mirrors[i], make_material(build, tints[i % N_TINTS]));
	}
	ts_build_object(build, NULL, false);
}

/* Gives each moving reflector its shape and tint. */
static void add_moving(ts_build *build, const placement *p, u32 n, const ts_params *params)
{
	u32 materials[N_TINTS];
	for (u32 i = 0; i < n; i++) {
		u32 shape = TS_PARAM(params, reflectors_shape) == TS_SHAPE_MIXED ? i % TS_SHAPE_MIXED
		                                                                 : TS_PARAM(params, reflectors_shape);
		if (i < N_TINTS) materials[i] = make_material(build, tints[i]);
		ts_build_object(build, &p->objects[i], true);
		ts_shape_add(build, shape, p->radius, materials[i % N_TINTS]);
	}
	ts_build_object(build, NULL, false);
}

void ts_reflectors_add(ts_build *build, const ts_params *params, const char *camera, const ts_rays *rays)
{
	floor_plan plan;
	if (TS_PARAM(params, reflectors_count) == 0 || ts_build_failed(build)) return;
	plan_make(&plan, ts_build_peek(build), params, camera, rays);
	ts_object *objects = ts_alloc((size_t)plan.n * 2, sizeof *objects, "the added reflectors");
	if (objects == NULL) {
		ts_build_adopt(build);
		return;
	}
	placement p = {.objects = objects}, other = {.objects = objects + plan.n};
	place_all(build, &p, &other, &plan, TS_PARAM(params, reflectors_px));
	add_moving(build, &p, plan.n, params);
	free(objects);
}
