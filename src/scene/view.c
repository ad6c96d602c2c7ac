/* The eye: a camera of the scene, or on an ellipse around the middle of the hall (METHODS 2). */
#include "scene/view.h"

#define EYE_HEIGHT 0.35f /* of the box, above its floor: inside a room the picture is a visitor's */
#define TARGET_HEIGHT 0.3f

static ts_space space_between(ts_v3 low, ts_v3 high)
{
	ts_v3 half = ts_scale(ts_sub(high, low), 0.5f);
	f32 greatest = ts_max(ts_max(half.x, half.y), half.z);
	f32 least = greatest > 0.0f ? greatest * 0.03125f : 1.0f;
	return (ts_space){ts_scale(ts_add(low, high), 0.5f), ts_max3(half, ts_v3_make(least, least, least))};
}

ts_space ts_view_box(const ts_info *info) { return space_between(ts_load3(info->box_min), ts_load3(info->box_max)); }

ts_space ts_view_hall(const ts_info *info)
{
	return space_between(ts_v3_make(info->hall_min[0], info->box_min[1], info->hall_min[1]),
	                     ts_v3_make(info->hall_max[0], info->box_max[1], info->hall_max[1]));
}

void ts_view_aim(f32 right[3], f32 up[3], f32 back[3], ts_v3 eye, ts_v3 target)
{
	ts_v3 z = ts_normalize(ts_sub(eye, target));
	ts_v3 x = ts_normalize(ts_cross(ts_v3_make(0.0f, 1.0f, 0.0f), z));
	if (!(ts_dot(x, x) > 0.0f)) x = ts_v3_make(1.0f, 0.0f, 0.0f);
	ts_store3(right, x);
	ts_store3(up, ts_normalize(ts_cross(z, x)));
	ts_store3(back, z);
}

static void look_at(ts_view *view, ts_v3 eye, ts_v3 target)
{
	ts_store3(view->eye, eye);
	ts_view_aim(view->right, view->up, view->back, eye, target);
}

bool ts_view_is_open(const ts_info *info)
{
	ts_space box = ts_view_box(info), hall = ts_view_hall(info);
	return box.half.x == hall.half.x && box.half.z == hall.half.z;
}

/* Turns of the circling eye since frame 0. */
static f32 turns_of(const ts_params *params)
{
	u32 frame = TS_PARAM(params, frame) % TS_FRAMES_A_TURN * TS_PARAM(params, eye_turns);
	return (f32)(frame % TS_FRAMES_A_TURN) / (f32)TS_FRAMES_A_TURN;
}

static void circle(ts_view *view, const ts_info *info, const ts_params *params)
{
	ts_space hall = ts_view_hall(info);
	f32 factor = TS_PARAM(params, eye_distance) == TS_EYE_NEAR ? 0.35f : 0.9f;
	f32 turns = turns_of(params);
	f32 across = hall.half.x * factor;
	f32 along = hall.half.z * factor;
	f32 floor = hall.middle.y - hall.half.y;
	f32 height = hall.half.y + hall.half.y;
	ts_v3 eye = ts_v3_make(hall.middle.x + across * ts_cos_turn(turns), floor + height * EYE_HEIGHT,
	                       hall.middle.z + along * ts_sin_turn(turns));
	look_at(view, eye, ts_v3_make(hall.middle.x, floor + height * TARGET_HEIGHT, hall.middle.z));
}

#define HELD 0.9f /* of the image's half sides, for the box */

/* The distance from the middle of the box at which the image has all its corners. */
static f32 distance_to_hold(ts_v3 half, const ts_view *view, f32 tangent_up, f32 tangent_across)
{
	f32 distance = 0.0f;
	for (u32 k = 0; k < 8; k++) {
		ts_v3 c = ts_v3_make(k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z);
		f32 x = ts_abs(ts_dot(c, ts_load3(view->right))) / (tangent_across * HELD);
		f32 y = ts_abs(ts_dot(c, ts_load3(view->up))) / (tangent_up * HELD);
		distance = ts_max(distance, ts_dot(c, ts_load3(view->back)) + ts_max(x, y));
	}
	return distance;
}

/* Around the box: as near as the image holds its corners, or as far as the ball about it requires. */
static void circle_outside(ts_view *view, const ts_info *info, const ts_params *params)
{
	ts_space box = ts_view_box(info);
	f32 turns = turns_of(params);
	f32 half_fov = TS_PARAM(params, eye_fov) / 720.0f, sine = ts_sin_turn(half_fov);
	f32 distance = ts_length(box.half) / sine;
	ts_v3 way = ts_normalize(ts_v3_make(ts_sin_turn(turns), EYE_HEIGHT, ts_cos_turn(turns)));
	look_at(view, ts_mad(box.middle, way, distance), box.middle);
	if (info->circles == TS_CIRCLES_HALL) return;
	f32 up = sine / ts_cos_turn(half_fov);
	f32 across = up * (f32)TS_PARAM(params, width) / (f32)TS_PARAM(params, height);
	ts_store3(view->eye, ts_mad(box.middle, way, distance_to_hold(box.half, view, up, across)));
}

static bool is_outside(const ts_info *info, const ts_params *params)
{
	u32 distance = TS_PARAM(params, eye_distance);
	return distance == TS_EYE_OUTSIDE || (distance == TS_EYE_FAR && info->circles == TS_CIRCLES_OUTSIDE);
}

void ts_view_eye(ts_view *view, const ts_info *info, const ts_params *params)
{
	if (info->circles != TS_CIRCLES_NOT && is_outside(info, params)) {
		circle_outside(view, info, params);
	} else if (info->circles != TS_CIRCLES_NOT) {
		circle(view, info, params);
	} else {
		memcpy(view->eye, info->eye, sizeof view->eye);
		memcpy(view->right, info->right, sizeof view->right);
		memcpy(view->up, info->up, sizeof view->up);
		memcpy(view->back, info->back, sizeof view->back);
	}
	f32 half_turns = info->yfov > 0.0f ? info->yfov * 0.5f : TS_PARAM(params, eye_fov) / 720.0f;
	f32 height = (f32)TS_PARAM(params, height) * ts_cos_turn(half_turns);
	view->width = TS_PARAM(params, width);
	view->height = TS_PARAM(params, height);
	view->focal = ts_put(height / (2.0f * ts_sin_turn(half_turns)));
	view->near = ts_put(ts_length(ts_view_box(info).half) * TS_NEAR_OF_RADIUS);
}

void ts_view_on_path(ts_view *view, const ts_info *info, const ts_path_eye *path, u32 n, const ts_params *params)
{
	ts_info there = *info;
	u32 frame = TS_PARAM(params, frame);
	if (n > 0) {
		bool repeats = info->circles == TS_CIRCLES_PATH;
		const ts_path_eye *at = &path[repeats ? frame % n : frame < n ? frame : n - 1];
		there.circles = TS_CIRCLES_NOT;
		there.yfov = at->yfov;
		memcpy(there.eye, at->eye, sizeof there.eye);
		memcpy(there.right, at->right, sizeof there.right);
		memcpy(there.up, at->up, sizeof there.up);
		memcpy(there.back, at->back, sizeof there.back);
	}
	ts_view_eye(view, &there, params);
}

u32 ts_view_period(const ts_info *info, u32 n)
{
	if (n > 0) return info->circles == TS_CIRCLES_PATH ? n : 1;
	return info->circles != TS_CIRCLES_NOT ? TS_FRAMES_A_TURN : 1;
}

ts_v3 ts_view_way(const ts_view *view, f32 x, f32 y)
{
	f32 right = (x - (f32)view->width * 0.5f) / view->focal, up = ((f32)view->height * 0.5f - y) / view->focal;
	ts_v3 way = ts_mad(ts_neg(ts_load3(view->back)), ts_load3(view->right), right);
	return ts_normalize(ts_mad(way, ts_load3(view->up), up));
}

bool ts_view_holds(const ts_view *view, ts_v3 p, f32 margin, f32 *depth)
{
	ts_v3 d = ts_sub(p, ts_load3(view->eye));
	f32 z = -ts_dot(d, ts_load3(view->back));
	f32 x = view->focal * ts_abs(ts_dot(d, ts_load3(view->right)));
	f32 y = view->focal * ts_abs(ts_dot(d, ts_load3(view->up)));
	*depth = z;
	return z > 0.0f && x <= z * ((f32)view->width * 0.5f - margin) && y <= z * ((f32)view->height * 0.5f - margin);
}

void ts_view_choose(ts_info *info, const ts_camera *camera)
{
	info->circles = camera == NULL ? TS_CIRCLES_HALL : TS_CIRCLES_NOT;
	if (camera == NULL) return;
	ts_store3(info->eye, ts_load3(camera->eye));
	ts_store3(info->right, ts_load3(camera->right));
	ts_store3(info->up, ts_load3(camera->up));
	ts_store3(info->back, ts_load3(camera->back));
	info->yfov = ts_put(camera->yfov);
}
