/* Seams of hulls (METHODS 11): how the irradiance of hulls changes from pixel to pixel beside that of `direct`, and how
 * many triangles of light that face the corners of boxes count there. */
#ifndef TS_HULLS_TOOLS_BORDERS_H
#define TS_HULLS_TOOLS_BORDERS_H
#include "../../../kernels/hulls/corner.h"

/* Two runs of one image; arrays of a pixel, irradiance of three channels. */
typedef struct {
	const ts_gpixel *pixels;
	const u32 *boxes;          /* hull.box */
	const f32 *hulls, *direct; /* indirect.irradiance */
	u32 width, height, grid;   /* the grid: texels a side */
} ts_borders_of;

/* Of neighbouring pixels, beside or below each other, of like depth (2 %) and normal (cosine 0.99) all |change of
 * hulls - change of direct| by all irradiance of direct, summed over channels. NAN where there are no such pixels, or
 * no light. */
typedef struct {
	double across; /* in two blocks of the grid */
	double within; /* in one box */
} ts_borders;
ts_borders ts_borders_measure(const ts_borders_of *of);

/* Pairs of a corner and a triangle of light that has its front to the corner. */
typedef struct {
	u64 facing;
	u64 counted; /* that the ramp of facing leaves some of */
	u64 full;    /* that it leaves all of */
} ts_facing_pairs;
ts_facing_pairs ts_facing_count(const ts_moment *corners, u64 n_corners, const ts_patch *patches, u64 n_patches);

#endif
