/* The eye: a camera of the scene, or on an ellipse around the middle of the hall (METHODS 2). */
#include "view.h"

#define EYE_HEIGHT 0.35f /* of the box, above its floor: inside a room the picture is that of a visitor */
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

static void look_at(ts_view *view, ts_v3 eye, ts_v3 target)
{
	ts_v3 back = ts_normalize(ts_sub(eye, target));
	ts_v3 right = ts_normalize(ts_cross(ts_v3_make(0.0f, 1.0f, 0.0f), back));
	ts_store3(view->eye, eye);
	ts_store3(view->right, right);
	ts_store3(view->up, ts_normalize(ts_cross(back, right)));
	ts_store3(view->back, back);
}

static void circle(ts_view *view, const ts_info *info, const ts_params *params)
{
	ts_space hall = ts_view_hall(info);
	f32 factor = TS_PARAM(params, eye_distance) == TS_EYE_NEAR ? 0.35f : 0.9f;
	f32 turns = (f32)(TS_PARAM(params, frame) % TS_FRAMES_A_TURN) / (f32)TS_FRAMES_A_TURN;
	f32 across = hall.half.x * factor;
	f32 along = hall.half.z * factor;
	f32 floor = hall.middle.y - hall.half.y;
	f32 height = hall.half.y + hall.half.y;
	ts_v3 eye = ts_v3_make(hall.middle.x + across * ts_cos_turn(turns), floor + height * EYE_HEIGHT,
	                       hall.middle.z + along * ts_sin_turn(turns));
	look_at(view, eye, ts_v3_make(hall.middle.x, floor + height * TARGET_HEIGHT, hall.middle.z));
}

/* So far from the middle of the box that the ball about it fits into the image. */
static void circle_outside(ts_view *view, const ts_info *info, const ts_params *params)
{
	ts_space box = ts_view_box(info);
	f32 turns = (f32)(TS_PARAM(params, frame) % TS_FRAMES_A_TURN) / (f32)TS_FRAMES_A_TURN;
	f32 distance = ts_length(box.half) / ts_sin_turn(TS_PARAM(params, eye_fov) / 720.0f);
	ts_v3 way = ts_normalize(ts_v3_make(ts_sin_turn(turns), EYE_HEIGHT, ts_cos_turn(turns)));
	look_at(view, ts_mad(box.middle, way, distance), box.middle);
}

void ts_view_eye(ts_view *view, const ts_info *info, const ts_params *params)
{
	if (info->circles != 0 && TS_PARAM(params, eye_distance) == TS_EYE_OUTSIDE) {
		circle_outside(view, info, params);
	} else if (info->circles != 0) {
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
	view->near = ts_put(ts_length(ts_view_box(info).half) * 0.0009765625f);
}

void ts_view_choose(ts_info *info, const ts_camera *camera)
{
	info->circles = camera == NULL;
	if (camera == NULL) return;
	ts_store3(info->eye, ts_load3(camera->eye));
	ts_store3(info->right, ts_load3(camera->right));
	ts_store3(info->up, ts_load3(camera->up));
	ts_store3(info->back, ts_load3(camera->back));
	info->yfov = ts_put(camera->yfov);
}
