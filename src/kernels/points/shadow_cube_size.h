/* The resolution of shadow cubes from the eye's (EPR section 5.1, eq. 6; METHODS 10): Res_max times the largest d_lt /
 * d_er over the triangles in sight and the light samples; d_lt is the distance from the triangle to the light sample,
 * d_er that to the eye. */
#ifndef TS_KERNELS_POINTS_SHADOW_CUBE_SIZE_H
#define TS_KERNELS_POINTS_SHADOW_CUBE_SIZE_H
#include "kernels/base/args.h"
#include "kernels/base/closest.h"
#include "kernels/base/scene.h"

#define TS_ROWS_ts_shadow_cube_size_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_view, view, eye_view) \
	ARG(IN, u64, depth_triangle, eye_depth_triangle) \
	ARG(IN, ts_face, cubes, cube_size_face) /* of the light samples */ \
	ARG(MIN, u32, least, shadow_cube_size_least_ratio) \
	ARG(VALUE, u32, n_cubes, none)
TS_ARGS(ts_shadow_cube_size_args);

/* scatter over pixels and their samples: the least d_er / max_l d_lt. An element that shows the triangle of the element
 * before adds nothing. */
TS_FN void ts_k_shadow_cube_size_item(const ts_shadow_cube_size_args *args, u64 i)
{
	/* Leave out the sky, and the triangle of the element before. */
	u64 key = args->depth_triangle[i];
	if (key == TS_EMPTY || (i != 0u && (u32)args->depth_triangle[i - 1u] == (u32)key)) return;
	ts_corners t = ts_k_corners(&args->scene, (u32)key);
	ts_v3 eye = ts_load3(args->view->eye);
	/* Find the greatest d_lt of the light samples. */
	f32 to_light = 0.0f;
	for (u32 l = 0u; l < args->n_cubes; l++) {
		ts_v3 light = ts_load3(args->cubes[l].centre);
		to_light = ts_max(to_light, ts_length(ts_sub(ts_k_closest_on_triangle(light, t.a, t.b, t.c), light)));
	}
	/* Offer d_er / d_lt: the least quotient is the greatest ratio of EPR 5.1, eq. 6. */
	f32 to_eye = ts_length(ts_sub(ts_k_closest_on_triangle(eye, t.a, t.b, t.c), eye));
	if (to_light > 0.0f) ts_min_u32(args->least, ts_f2u(ts_put(to_eye / to_light)));
}

#endif
