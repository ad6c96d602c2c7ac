/* Area lights and their samples. All arithmetic is the kernels' (CONTRACT rule 4). */
#include "scene/lamp.h"
#include "kernels/base/shade.h"
#include "scene/view.h"

#define WIDEST 3.73205089569091796875f /* tangent of 75 degrees */

static f32 diagonal(ts_space space) { return ts_length(space.half); }

/* From the middle of the hall, in halves of it. */
static ts_v3 in_hall(ts_space hall, f32 x, f32 y, f32 z)
{
	return ts_v3_make(hall.middle.x + x * hall.half.x, hall.middle.y + y * hall.half.y,
	                  hall.middle.z + z * hall.half.z);
}

/* Beyond the middle of the floor, where the walls and things near them catch light and shadow; without walls the middle
 * of the thing. */
static ts_v3 lamp_target(const ts_info *info)
{
	ts_space hall = ts_view_hall(info);
	return ts_view_is_open(info) ? hall.middle : in_hall(hall, -0.5f, -0.75f, -0.375f);
}

f32 ts_lamp_distance(const ts_info *info)
{
	return diagonal(ts_view_hall(info)) / ts_sin_turn(TS_LAMP_FOV / 720.0f * TS_LAMP_FULL);
}

static f32 half_tangent(f32 degrees)
{
	f32 turns = degrees / 720.0f;
	return ts_sin_turn(turns) / ts_cos_turn(turns);
}

static void set_cone(ts_light *light, f32 inner_cosine, f32 outer_cosine)
{
	light->spot_scale = ts_put(1.0f / (inner_cosine - outer_cosine));
	light->spot_offset = ts_put(-outer_cosine * light->spot_scale);
}

/* From the lamp's target to the lamp. */
static ts_v3 way_to_spot(const ts_info *info, ts_v3 target)
{
	ts_space hall = ts_view_hall(info);
	if (!ts_view_is_open(info)) return ts_sub(in_hall(hall, 0.75f, 0.625f, 0.625f), target);
	return ts_scale(ts_normalize(ts_v3_make(0.5f, 1.0f, 0.375f)), ts_lamp_distance(info));
}

static ts_v3 place_of_ball(const ts_info *info)
{
	ts_space hall = ts_view_hall(info);
	return ts_view_is_open(info) ? in_hall(hall, 0.5f, 2.0f, 0.375f) : in_hall(hall, 0.0f, 0.25f, 0.0f);
}

void ts_lamp_stands(ts_stand stands[TS_N_STANDS], const ts_info *info)
{
	ts_v3 target = lamp_target(info);
	ts_store3(stands[TS_STAND_SPOT].position, ts_add(target, way_to_spot(info, target)));
	ts_store3(stands[TS_STAND_SPOT].target, target);
	ts_store3(stands[TS_STAND_BALL].position, place_of_ball(info));
	ts_store3(stands[TS_STAND_BALL].target, target);
}

void ts_lamp_spot(ts_light *light, const ts_info *info, const ts_stand *stands, const ts_params *params)
{
	const ts_stand *at = stands != NULL ? &stands[TS_STAND_SPOT] : NULL;
	ts_v3 target = at != NULL ? ts_load3(at->target) : lamp_target(info);
	ts_v3 way = at != NULL ? ts_sub(ts_load3(at->position), target) : way_to_spot(info, target);
	memset(light, 0, sizeof *light);
	light->kind = TS_LIGHT_KIND_SPOT;
	f32 distance = ts_length(way), candela = TS_PARAM(params, light_irradiance) * (distance * distance);
	ts_store3(light->position, ts_add(target, way));
	ts_store3(light->direction, ts_neg(ts_normalize(way)));
	ts_store3(light->intensity, ts_v3_make(candela, candela, candela));
	f32 turns = TS_PARAM(params, lamp_fov) / 720.0f; /* half the angle */
	set_cone(light, ts_cos_turn(turns * TS_LAMP_FULL), ts_cos_turn(turns * TS_LAMP_BORDER));
}

void ts_lamp_ball(ts_light *light, const ts_info *info, const ts_stand *stands, const ts_params *params)
{
	ts_space hall = ts_view_hall(info);
	f32 distance = hall.half.y, candela = TS_PARAM(params, light_irradiance) * (distance * distance);
	memset(light, 0, sizeof *light);
	light->kind = TS_LIGHT_KIND_POINT;
	ts_store3(light->position, stands != NULL ? ts_load3(stands[TS_STAND_BALL].position) : place_of_ball(info));
	ts_store3(light->intensity, ts_v3_make(candela, candela, candela));
}

f32 ts_lamp_radius(const ts_light *light, const ts_info *info, const ts_params *params)
{
	bool sun = light->kind == TS_LIGHT_KIND_DIRECTIONAL;
	return ts_put(sun ? TS_PARAM(params, lamp_radius) : TS_PARAM(params, lamp_radius) * diagonal(ts_view_hall(info)));
}

/* Seed k of n of a sunflower, in the unit disc (Vogel 1979). */
static ts_v2 seed(u32 k, u32 n)
{
	f32 r = n > 1 ? ts_sqrt(((f32)k + 0.5f) / (f32)n) : 0.0f;
	f32 turns = TS_GOLDEN_TURN * (f32)k;
	return ts_v2_make(r * ts_cos_turn(turns), r * ts_sin_turn(turns));
}

typedef struct {
	ts_v3 right, up, back;
} axes;

static axes axes_of(ts_v3 back)
{
	ts_v3 pole = ts_abs(back.y) < 0.99f ? ts_v3_make(0.0f, 1.0f, 0.0f) : ts_v3_make(1.0f, 0.0f, 0.0f);
	ts_v3 right = ts_normalize(ts_cross(pole, back));
	return (axes){right, ts_normalize(ts_cross(back, right)), back};
}

static void set_axes(ts_offscreen *view, axes a)
{
	ts_store3(view->right, a.right);
	ts_store3(view->up, a.up);
	ts_store3(view->back, a.back);
}

/* The whole scene, seen along the sun's rays. */
static void view_of_sun(ts_offscreen *view, axes middle, ts_v2 at, f32 radius, const ts_info *info)
{
	ts_space box = ts_view_box(info);
	f32 half = diagonal(box) * 1.03125f;
	ts_v3 aside = ts_mad(ts_scale(middle.right, at.x * radius), middle.up, at.y * radius);
	axes a = axes_of(ts_normalize(ts_add(middle.back, aside)));
	set_axes(view, a);
	ts_store3(view->eye, ts_mad(box.middle, a.back, half * 1.0625f));
	view->orthographic = 1;
	view->near = ts_put(half * TS_NEAR_OF_RADIUS);
	view->focal = ts_put((f32)view->width / (2.0f * half));
	view->reach[0] = view->reach[1] = ts_put(half);
}

/* Tangent of the angle from a spot light's axis to the border of its cone. */
static f32 cone_tangent(const ts_light *light)
{
	f32 cosine = light->spot_scale > 0.0f ? -light->spot_offset / light->spot_scale : 0.0f;
	if (!(cosine > 0.25f)) return WIDEST;
	return ts_sqrt(ts_max(1.0f - cosine * cosine, 0.0f)) / cosine;
}

static f32 tangent_of(const ts_light *light, const ts_lens *lens)
{
	bool own = lens->own && light->kind == TS_LIGHT_KIND_SPOT;
	return ts_clamp(own ? cone_tangent(light) : half_tangent(lens->fov), 0.015625f, WIDEST);
}

void ts_lamp_view(ts_offscreen *view, const ts_light *light, f32 radius, u32 k, u32 n, const ts_info *info,
                  const ts_lens *lens)
{
	ts_v2 at = seed(k, n);
	ts_v3 position = ts_load3(light->position);
	memset(view, 0, sizeof *view);
	view->width = view->height = lens->side;
	view->object = TS_NONE;
	bool point = light->kind == TS_LIGHT_KIND_POINT;
	ts_v3 back = point ? ts_normalize(ts_sub(position, lamp_target(info))) : ts_neg(ts_load3(light->direction));
	axes a = axes_of(ts_dot(back, back) > 0.0f ? back : ts_v3_make(0.0f, 1.0f, 0.0f));
	if (light->kind == TS_LIGHT_KIND_DIRECTIONAL) {
		view_of_sun(view, a, at, radius, info);
		return;
	}
	f32 tangent = tangent_of(light, lens);
	set_axes(view, a);
	ts_store3(view->eye, ts_mad(ts_mad(position, a.right, at.x * radius), a.up, at.y * radius));
	view->near = ts_put(diagonal(ts_view_box(info)) * TS_NEAR_OF_RADIUS);
	view->focal = ts_put((f32)view->width / (2.0f * tangent));
	view->reach[0] = view->reach[1] = ts_put(tangent);
}

void ts_lamp_cube(ts_face *cube, const ts_light *light, f32 radius, u32 k, u32 n, const ts_info *info, u32 side)
{
	f32 y = n > 1 ? 1.0f - (2.0f * (f32)k + 1.0f) / (f32)n : 0.0f;
	f32 r = n > 1 ? ts_sqrt(ts_max(1.0f - y * y, 0.0f)) : 0.0f, turns = TS_GOLDEN_TURN * (f32)k;
	ts_v3 at = ts_scale(ts_v3_make(r * ts_cos_turn(turns), y, r * ts_sin_turn(turns)), radius);
	ts_v3 centre = ts_add(ts_load3(light->position), at);
	memset(cube, 0, sizeof *cube);
	cube->radius = ts_put(diagonal(ts_view_box(info)));
	cube->near = ts_put(cube->radius * TS_NEAR_OF_RADIUS);
	cube->n = side;
	cube->object = TS_NONE;
	ts_store3(cube->centre, centre);
	ts_store3(cube->box_min, centre);
	ts_store3(cube->box_max, centre);
}
