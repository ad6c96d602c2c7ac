/* Poses: moving objects follow an ellipse, one turn in `period` frames, or the file's animation (METHODS 2). */
#ifndef TS_KERNELS_BASE_POSE_H
#define TS_KERNELS_BASE_POSE_H
#include "kernels/base/args.h"
#include "kernels/base/records.h"
#include "kernels/base/vec.h"

/* world = centre + (cos * x + sin * z, y, cos * z - sin * x), or by the matrices of `motion` */
typedef struct {
	ts_v3 centre;
	f32 cos, sin;
	u32 moves; /* 0: not at all; 1: on an ellipse; 2: by the matrices of motion */
	TS_GLOBAL const ts_motion *motion;
} ts_pose;

/* The pose of an object that follows an ellipse, or of one that stands still. */
TS_FN ts_pose ts_k_pose(TS_GLOBAL const ts_object *object, u32 frame)
{
	ts_pose r;
	/* Assume that no animation moves the object; ts_k_pose_at adds what does. */
	r.motion = NULL;
	r.moves = object->period != 0u ? 1u : 0u;
	/* Measure the way along the ellipse in turns. */
	f32 period = (f32)(r.moves != 0u ? object->period : 1u);
	f32 turns = (f32)(r.moves != 0u ? frame % object->period : 0u) / period;
	f32 angle = object->phase + turns;
	f32 twice = angle + angle;
	/* Move the centre along the ellipse in x and z, and up and down twice a turn. */
	f32 x = object->axis[0] * ts_cos_turn(angle);
	f32 y = object->bob * ts_sin_turn(twice);
	f32 z = object->axis[1] * ts_sin_turn(angle);
	/* Turn the object about the vertical axis through the centre. */
	f32 spin = object->spin * angle;
	r.centre = ts_add(ts_load3(object->centre), ts_v3_make(x, y, z));
	r.cos = ts_cos_turn(spin);
	r.sin = ts_sin_turn(spin);
	return r;
}

/* The pose by the file's animation, if there is one. Motions are sorted by frame, then by object. n_motion: their
 * number of frames; 0: there are no motions. */
TS_FN ts_pose ts_k_pose_at(TS_GLOBAL const ts_object *objects, u32 n_objects, u32 object,
                           TS_GLOBAL const ts_motion *motions, u32 n_motion, u32 frame)
{
	ts_pose r = ts_k_pose(&objects[object], frame);
	if (n_motion == 0u) return r;
	r.motion = &motions[(u64)(frame % n_motion) * n_objects + object];
	if (r.motion->moves != 0u) r.moves = 2u;
	return r;
}

TS_FN ts_v3 ts_k_pose_linear(TS_GLOBAL const f32 *rows, ts_v3 d)
{
	return ts_v3_make(ts_dot(ts_load3(rows), d), ts_dot(ts_load3(rows + 3), d), ts_dot(ts_load3(rows + 6), d));
}

TS_FN ts_v3 ts_k_pose_turn(const ts_pose *pose, ts_v3 d)
{
	f32 x = ts_diff_of_products(pose->cos, d.x, -pose->sin, d.z);
	f32 z = ts_diff_of_products(pose->cos, d.z, pose->sin, d.x);
	return ts_v3_make(x, d.y, z);
}

/* A static object's vertices are world coordinates already and keep their bits. */
TS_FN ts_v3 ts_k_pose_point(const ts_pose *pose, ts_v3 p)
{
	if (pose->moves == 2u) return ts_add(ts_k_pose_linear(pose->motion->linear, p), ts_load3(pose->motion->origin));
	return pose->moves != 0u ? ts_add(pose->centre, ts_k_pose_turn(pose, p)) : p;
}

TS_FN ts_v3 ts_k_pose_normal(const ts_pose *pose, ts_v3 n)
{
	if (pose->moves == 2u) return ts_normalize(ts_k_pose_linear(pose->motion->normal, n));
	return ts_k_pose_turn(pose, n);
}

TS_FN ts_v3 ts_k_pose_tangent(const ts_pose *pose, ts_v3 t)
{
	if (pose->moves == 2u) return ts_normalize(ts_k_pose_linear(pose->motion->linear, t));
	return ts_k_pose_turn(pose, t);
}

#define TS_ROWS_ts_pose_args(ARG) \
	ARG(IN, ts_vertex, vertices, scene_vertex) \
	ARG(IN, ts_object, objects, scene_object) \
	ARG(IN_OPT, ts_motion, motions, scene_motion) \
	ARG(OUT, ts_vertex, posed, pose_vertex) \
	ARG(VALUE, u32, n_objects, none) \
	ARG(VALUE, u32, n_motion, none) /* frames of the motions, or 0 */ \
	ARG(VALUE, u32, frame, none)
TS_ARGS(ts_pose_args);

/* map over vertices */
TS_FN void ts_k_pose_item(const ts_pose_args *args, u64 i)
{
	/* Find the pose of the vertex's object. */
	ts_vertex v = args->vertices[i];
	ts_pose pose = ts_k_pose_at(args->objects, args->n_objects, v.object, args->motions, args->n_motion, args->frame);
	if (pose.moves != 0u) {
		/* Move position, normal and tangent (METHODS 2). */
		ts_v3 p = ts_k_pose_point(&pose, ts_v3_make(v.position[0], v.position[1], v.position[2]));
		ts_v3 n = ts_k_pose_normal(&pose, ts_v3_make(v.normal[0], v.normal[1], v.normal[2]));
		ts_v3 t = ts_k_pose_tangent(&pose, ts_v3_make(v.tangent[0], v.tangent[1], v.tangent[2]));
		v.position[0] = ts_put(p.x);
		v.position[1] = ts_put(p.y);
		v.position[2] = ts_put(p.z);
		v.normal[0] = ts_put(n.x);
		v.normal[1] = ts_put(n.y);
		v.normal[2] = ts_put(n.z);
		v.tangent[0] = ts_put(t.x);
		v.tangent[1] = ts_put(t.y);
		v.tangent[2] = ts_put(t.z);
		/* Invert the handedness of tangents where the motion mirrors the object. */
		if (pose.moves == 2u && pose.motion->moves == 2u) v.tangent[3] = ts_put(-v.tangent[3]);
	}
	args->posed[i] = v;
}

#endif
