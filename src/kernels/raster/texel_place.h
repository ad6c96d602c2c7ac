/* The places of the texels of a batch of cubes, and the arguments of the kernels that shade them. */
#ifndef TS_KERNELS_RASTER_TEXEL_PLACE_H
#define TS_KERNELS_RASTER_TEXEL_PLACE_H
#include "kernels/base/args.h"
#include "kernels/base/scene.h"
#include "kernels/raster/mip.h"

#define TS_ROWS_ts_illuminate_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_face, cubes, cube_size_face) \
	ARG(IN, u64, depth_triangle, cube_face_depth_triangle) /* of the batch */ \
	ARG(OUT, f32, mip, cube_face_mip)                      /* of the batch: 4 floats per texel */ \
	ARG(VALUE, u32, first_cube, none) \
	ARG(VALUE, u32, n_cubes, none) /* the batch */ \
	ARG(VALUE, u32, level, none)   /* made by the kernel mip from the finer level */
TS_ARGS(ts_illuminate_args);

/* The place of a texel of the batch. */
typedef struct {
	u32 cube, face, x, y;
	u64 inside;
} ts_texel_place;

TS_FN ts_texel_place ts_k_texel_place(const ts_illuminate_args *args, u64 i)
{
	u64 first = args->cubes[args->first_cube].offset;
	ts_texel_place r;
	r.cube = args->first_cube;
	for (u32 k = r.cube + 1u; k < args->first_cube + args->n_cubes; k++) {
		r.cube = args->cubes[k].offset - first <= i ? k : r.cube;
	}
	u64 n = args->cubes[r.cube].n;
	r.inside = i - (args->cubes[r.cube].offset - first);
	r.face = (u32)(r.inside / (n * n));
	r.y = (u32)(r.inside / n % n);
	r.x = (u32)(r.inside % n);
	return r;
}

#endif
