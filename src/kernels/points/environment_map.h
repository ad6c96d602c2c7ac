/* The copy pass of environment maps: writes the colours of the nearest points to level 0 of the mip chain (iVIR section
 * 5; METHODS 9). */
#ifndef TS_KERNELS_POINTS_ENVIRONMENT_MAP_H
#define TS_KERNELS_POINTS_ENVIRONMENT_MAP_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/points/colour_code.h"
#include "kernels/raster/texel_place.h"

#define TS_ROWS_ts_environment_map_args(ARG) \
	ARG(INNER, ts_illuminate_args, to, none) /* without its depth_triangle */ \
	ARG(IN, u32, colours, scatter_colour)    /* of all cubes */ \
	ARG(VALUE, f32, exposure, none)
TS_ARGS(ts_environment_map_args);

/* map over texels of the batch */
TS_FN void ts_k_environment_map_item(const ts_environment_map_args *args, u64 i)
{
	ts_texel_place place = ts_k_texel_place(&args->to, i);
	u32 code = args->colours[args->to.cubes[args->to.first_cube].offset + i];
	ts_v3 radiance = code != TS_NONE ? ts_k_colour_radiance(code, args->exposure) : ts_k_background();
	u64 first = ts_k_mip_first(args->to.cubes, args->to.first_cube, place.cube);
	TS_GLOBAL f32 *out = args->to.mip + (first + place.inside) * 4u;
	ts_store3(out, radiance);
	out[3] = 1.0f;
}

#endif
