/* MVR's cube faces: draws every triangle into the keys depth << 32 | triangle of each face (EPR section 4.2). */
#ifndef TS_KERNELS_RASTER_CUBE_FACE_H
#define TS_KERNELS_RASTER_CUBE_FACE_H
#include "kernels/base/args.h"
#include "kernels/raster/draw.h"

#define TS_ROWS_ts_cube_face_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_face, cubes, cube_size_face) \
	ARG(MIN, u64, texels, cube_face_depth_triangle) /* of the batch */ \
	ARG(VALUE, u32, first_cube, none) \
	ARG(VALUE, u32, n_cubes, none) /* the batch */ \
	ARG(VALUE, u32, others, none)  /* other items that share the rows: band.h */
TS_ARGS(ts_cube_face_args);

/* scatter over triangles: into every face of every cube of the batch, but not into a reflector's own cube */
TS_FN void ts_k_cube_face_item(const ts_cube_face_args *args, u64 i)
{
	/* Drop a triangle without area (CONTRACT rule 35). */
	ts_band band = ts_k_band(i, args->others);
	u32 triangle = (u32)band.item;
	ts_corners t = ts_k_corners(&args->scene, triangle);
	if (args->n_cubes == 0u || ts_k_is_degenerate(t.n)) return;
	u64 first_texel = args->cubes[args->first_cube].offset;
	for (u32 r = args->first_cube; r < args->first_cube + args->n_cubes; r++) {
		/* Choose the cubes that may show the triangle. */
		TS_GLOBAL const ts_face *cube = &args->cubes[r];
		if (!ts_k_may_show(&args->scene, cube, triangle, &t)) continue;
		for (u32 face = 0u; face < 6u; face++) {
			/* Draw the triangle into the face's texels. */
			ts_camera_k view = ts_k_cube_view(cube, face);
			u64 offset = cube->offset - first_texel + (u64)face * cube->n * cube->n;
			ts_target target = ts_k_keys(args->texels + offset);
			ts_k_draw(&args->scene, &view, &t, triangle, &band, &target);
		}
	}
}

#endif
