/* Cube sizes from the eye's resolution (EPR section 3.5; METHODS 2): the larger side of the projected box of the
 * reflector, with hysteresis. */
#ifndef TS_KERNELS_POINTS_CUBE_SIZE_H
#define TS_KERNELS_POINTS_CUBE_SIZE_H
#include "kernels/base/args.h"
#include "kernels/base/pose.h"
#include "kernels/raster/clip.h"

#define TS_ROWS_ts_cube_size_args(ARG) \
	ARG(IN, ts_vertex, vertices, scene_vertex) \
	ARG(IN, ts_object, objects, scene_object) \
	ARG(IN_OPT, ts_motion, motions, scene_motion) \
	ARG(WORK_IN, u32, reflector_objects, other) /* object of each reflector */ \
	ARG(IN, ts_view, view, eye_view) \
	ARG(OUT, ts_face, cubes, cube_size_face) /* n on entry: the size in the frame before, 0 at first */ \
	ARG(VALUE, u32, n_objects, none) \
	ARG(VALUE, u32, n_motion, none) /* frames of the motions, or 0 */ \
	ARG(VALUE, u32, frame, none) \
	ARG(VALUE, u32, n_max, none) \
	ARG(VALUE, u32, hysteresis, none) \
	ARG(VALUE, u32, fixed, none) /* side of every cube; 0: sides are adapted */ \
	ARG(VALUE, u32, all, none)   /* not 0: also cubes out of sight */
TS_ARGS(ts_cube_size_args);

typedef struct {
	f32 x0, y0, x1, y1;
	u32 seen;
} ts_extent;

/* Grows an extent by a point of the image. */
TS_FN void ts_k_extent_add(ts_extent *e, ts_v2 p)
{
	e->x0 = e->seen != 0u ? ts_min(e->x0, p.x) : p.x;
	e->y0 = e->seen != 0u ? ts_min(e->y0, p.y) : p.y;
	e->x1 = e->seen != 0u ? ts_max(e->x1, p.x) : p.x;
	e->y1 = e->seen != 0u ? ts_max(e->y1, p.y) : p.y;
	e->seen = 1u;
}

/* The extent of the projected edges of a box, clipped at the near plane but not at the image. */
TS_FN ts_extent ts_k_box_extent(const ts_camera_k *view, ts_v3 lo, ts_v3 hi)
{
	ts_plane near = ts_k_near_plane(view);
	ts_extent r;
	r.seen = 0u;
	r.x0 = 0.0f;
	r.y0 = 0.0f;
	r.x1 = 0.0f;
	r.y1 = 0.0f;
	for (u32 edge = 0u; edge < 12u; edge++) {
		/* Name the corners by a bit for each axis; those of an edge differ in one bit. */
		u32 axis = edge >> 2;
		u32 first = ((edge & 1u) << ((axis + 1u) % 3u)) | (((edge >> 1) & 1u) << ((axis + 2u) % 3u));
		u32 second = first | (1u << axis);
		/* Move both corners into the view. */
		ts_corner a = ts_k_to_view(view, ts_v3_make((first & 1u) != 0u ? hi.x : lo.x, (first & 2u) != 0u ? hi.y : lo.y,
		                                            (first & 4u) != 0u ? hi.z : lo.z));
		ts_corner b =
			ts_k_to_view(view, ts_v3_make((second & 1u) != 0u ? hi.x : lo.x, (second & 2u) != 0u ? hi.y : lo.y,
		                                  (second & 4u) != 0u ? hi.z : lo.z));
		/* Cut the edge at the near plane, from the corner beyond it. */
		f32 da = ts_k_plane_side(&near, &a);
		f32 db = ts_k_plane_side(&near, &b);
		if (da < 0.0f && db < 0.0f) continue;
		if (da < 0.0f) a = ts_k_cut(&b, db, &a, da, view->near);
		if (db < 0.0f) b = ts_k_cut(&a, da, &b, db, view->near);
		/* Grow the extent by both ends. */
		ts_k_extent_add(&r, ts_k_project(view, &a));
		ts_k_extent_add(&r, ts_k_project(view, &b));
	}
	return r;
}

/* Texels along a side of a cube: N = min(floor(w), N_max - 1) + 1, at least 16, where w is the larger side of the box
 * on the screen; N of the frame before where it would change by less than the hysteresis (EPR 3.5); 0 out of sight. */
TS_FN u32 ts_k_resize_n(const ts_cube_size_args *args, const ts_camera_k *view, ts_v3 lo, ts_v3 hi, u32 before)
{
	ts_extent e = ts_k_box_extent(view, lo, hi);
	bool on_screen =
		e.seen != 0u && e.x1 >= 0.0f && e.y1 >= 0.0f && e.x0 <= (f32)view->width && e.y0 <= (f32)view->height;
	if (!on_screen && args->all == 0u) return 0u;
	if (args->fixed != 0u) return args->fixed;
	i32 whole = ts_floor_i32(ts_max(e.x1 - e.x0, e.y1 - e.y0));
	i32 wanted = ts_max_i32(ts_min_i32(whole, (i32)args->n_max - 1) + 1, 16);
	i32 change = ts_max_i32(wanted - (i32)before, (i32)before - wanted);
	return before != 0u && change < (i32)args->hysteresis ? before : (u32)wanted;
}

/* map over reflectors: box and ball of the vertices in this frame (METHODS 2), and the size of the cube */
TS_FN void ts_k_cube_size_item(const ts_cube_size_args *args, u64 i)
{
	/* Find the reflector's pose in this frame. */
	u32 index = args->reflector_objects[i];
	TS_GLOBAL const ts_object *object = &args->objects[index];
	TS_GLOBAL const ts_vertex *first = args->vertices + object->first_vertex;
	ts_pose pose = ts_k_pose_at(args->objects, args->n_objects, index, args->motions, args->n_motion, args->frame);
	/* Bound the vertices by a box. */
	ts_v3 lo = ts_k_pose_point(&pose, ts_load3(first->position));
	ts_v3 hi = lo;
	for (u32 k = 1u; k < object->n_vertices; k++) {
		ts_v3 p = ts_k_pose_point(&pose, ts_load3(first[k].position));
		lo = ts_min3(lo, p);
		hi = ts_max3(hi, p);
	}
	/* Bound the vertices by a ball about the box's centre. */
	ts_v3 centre = ts_scale(ts_add(lo, hi), 0.5f);
	f32 radius = 0.0f;
	for (u32 k = 0u; k < object->n_vertices; k++) {
		ts_v3 p = ts_k_pose_point(&pose, ts_load3(first[k].position));
		radius = ts_max(radius, ts_length(ts_sub(p, centre)));
	}
	/* Size the cube for the eye's pixels (EPR 3.5), and write the record. */
	ts_camera_k view = ts_k_view(args->view);
	TS_GLOBAL ts_face *cube = &args->cubes[i];
	cube->n = ts_k_resize_n(args, &view, lo, hi, cube->n);
	ts_store3(cube->centre, centre);
	ts_store3(cube->box_min, lo);
	ts_store3(cube->box_max, hi);
	cube->radius = ts_put(radius);
	cube->near = ts_put(radius * TS_NEAR_OF_RADIUS);
	cube->object = index;
}

#endif
