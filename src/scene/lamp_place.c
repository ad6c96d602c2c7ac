/* Places of lamps are judged by how many points in sight of the eye they light. */
#include "scene/sources.h"
#include "scene/view.h"

enum { N_ACROSS = 16, N_DOWN = 9, N_POINTS = N_ACROSS * N_DOWN, N_TARGETS = 16 };
#define ENOUGH_OF_SPOT 0.2f /* of the points in sight */
#define ENOUGH_OF_BALL 0.5f
#define CLEARANCE 0.02f /* of half the diagonal of the hall */

/* The eye's view. */
typedef struct {
	const ts_rays *rays;
	ts_v3 at[N_POINTS], normal[N_POINTS]; /* towards the eye */
	u32 n;
	f32 clear;
	ts_v3 target[N_TARGETS];
	u32 n_targets;
} sight;

static void see(sight *s, const ts_info *info, const ts_params *params)
{
	ts_view view;
	ts_params first = *params;
	TS_PARAM_SET(&first, frame, 0);
	ts_view_eye(&view, info, &first);
	s->n = 0;
	for (u32 i = 0; i < N_POINTS; i++) {
		f32 x = ((f32)(i % N_ACROSS) + 0.5f) / (f32)N_ACROSS, y = ((f32)(i / N_ACROSS) + 0.5f) / (f32)N_DOWN, distance;
		ts_v3 eye = ts_load3(view.eye), way = ts_view_way(&view, x * (f32)view.width, y * (f32)view.height);
		u32 hit = ts_rays_cast(&distance, s->rays, eye, way, TS_RAYS_FAR);
		if (hit == TS_NONE) continue;
		ts_v3 normal = ts_rays_normal(s->rays, hit);
		s->normal[s->n] = ts_dot(normal, way) < 0.0f ? normal : ts_neg(normal);
		s->at[s->n++] = ts_mad(eye, way, distance * 0.998f);
	}
}

/* The hall's own, the middle of its floor, the mean of the points in sight, and some of these; for a thing without
 * walls, which the lamp must light whole, only its middle. */
static void choose_targets(sight *s, const ts_info *info)
{
	ts_stand own[TS_N_STANDS];
	ts_space hall = ts_view_hall(info);
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_lamp_stands(own, info);
	for (u32 i = 0; i < s->n; i++) sum = ts_add(sum, ts_scale(s->at[i], 1.0f / (f32)s->n));
	s->n_targets = ts_view_is_open(info) ? 1 : N_TARGETS;
	s->target[0] = ts_load3(own[TS_STAND_SPOT].target);
	s->target[1] = ts_sub(hall.middle, ts_v3_make(0.0f, 0.75f * hall.half.y, 0.0f));
	s->target[2] = s->n > 0 ? sum : s->target[1];
	for (u32 k = 3; k < N_TARGETS; k++) s->target[k] = s->n > 0 ? s->at[k * s->n / N_TARGETS] : s->target[1];
}

/* The share of the points that a lamp lights: in its cone, with the default lamp.fov, around the direction to its
 * target, on surfaces that face it. Without a target: all around, on any surfaces, as at best half of those of a closed
 * thing face a ball. */
static f32 lit_by(const sight *s, ts_v3 lamp, const ts_v3 *target)
{
	u32 n = 0;
	f32 cone = ts_cos_turn(TS_LAMP_FOV / 720.0f * TS_LAMP_BORDER);
	ts_v3 axis = target != NULL ? ts_normalize(ts_sub(*target, lamp)) : lamp;
	for (u32 i = 0; i < s->n; i++) {
		ts_v3 way = ts_normalize(ts_sub(s->at[i], lamp));
		if (target != NULL && (ts_dot(way, axis) < cone || ts_dot(s->normal[i], way) >= 0.0f)) continue;
		n += ts_rays_free_between(s->rays, lamp, s->at[i]);
	}
	return s->n > 0 ? (f32)n / (f32)s->n : 0.0f;
}

static bool is_free(const sight *s, ts_v3 lamp)
{
	return ts_rays_clearance(s->rays, lamp, s->clear) >= s->clear && !ts_rays_is_inside(s->rays, lamp);
}

/* Finds the best target from there; returns the share that it lights. */
static f32 aim(ts_v3 *target, const sight *s, ts_v3 lamp)
{
	f32 most = -1.0f;
	for (u32 k = 0; k < s->n_targets; k++) {
		f32 lit = ts_length(ts_sub(s->target[k], lamp)) > 0.0f ? lit_by(s, lamp, &s->target[k]) : -1.0f;
		if (lit > most) *target = s->target[k];
		most = ts_max(most, lit);
	}
	return most;
}

/* Place i of a lattice in the hall, the corners last; around a thing without walls, on three rings above it. */
static ts_v3 lattice(const ts_info *info, u32 i, bool spot)
{
	static const f32 steps[5] = {0.0f, 0.4f, -0.4f, 0.75f, -0.75f};
	ts_space hall = ts_view_hall(info);
	if (!ts_view_is_open(info)) {
		ts_v3 at = ts_v3_make(steps[i % 5], 0.625f - 0.375f * (f32)(i / 25), steps[i / 5 % 5]);
		return ts_add(hall.middle, ts_mul(at, hall.half));
	}
	f32 turns = (f32)(i % 25) / 25.0f;
	ts_v3 way = ts_v3_make(ts_sin_turn(turns), 0.5f + 0.5f * (f32)(i / 25), ts_cos_turn(turns));
	return ts_mad(hall.middle, ts_normalize(way), spot ? ts_lamp_distance(info) : 2.0f * ts_length(hall.half));
}

/* Returns whether it found a place other than the stand's own. */
static bool place(ts_stand *stand, const sight *s, const ts_info *info, bool spot)
{
	ts_v3 lamp = ts_load3(stand->position), target = ts_load3(stand->target);
	f32 enough = spot ? ENOUGH_OF_SPOT : ENOUGH_OF_BALL, most = -1.0f;
	bool moved = false;
	if (is_free(s, lamp)) most = lit_by(s, lamp, spot ? &target : NULL);
	for (u32 i = 0; i < 75 && most < enough; i++) {
		ts_v3 at = lattice(info, i, spot), to = target;
		if (!is_free(s, at)) continue;
		f32 lit = spot ? aim(&to, s, at) : lit_by(s, at, NULL);
		if (lit <= most) continue;
		most = lit;
		ts_store3(stand->position, at);
		ts_store3(stand->target, to);
		moved = true;
	}
	return moved;
}

bool ts_lamp_place(ts_stand stands[TS_N_STANDS], const ts_info *info, const ts_rays *rays, const ts_params *params,
                   const f32 *given)
{
	sight s = {.rays = rays, .clear = ts_length(ts_view_hall(info).half) * CLEARANCE};
	see(&s, info, params);
	choose_targets(&s, info);
	ts_lamp_stands(stands, info);
	bool moved = given != NULL;
	for (u32 k = 0; k < TS_N_STANDS; k++) {
		if (given == NULL) {
			moved |= place(&stands[k], &s, info, k == TS_STAND_SPOT);
			continue;
		}
		ts_v3 lamp = ts_load3(given), target = ts_load3(stands[k].target);
		aim(&target, &s, lamp);
		ts_store3(stands[k].position, lamp);
		ts_store3(stands[k].target, target);
	}
	return moved;
}
