/* Seams of hulls (FIGURES 24): the change of the irradiance of hulls from pixel to pixel, against that of `direct`, and
 * the number of triangles of light that count at the corners of boxes that they face. */
#ifndef TS_METHODS_HULLS_TOOLS_BORDERS_H
#define TS_METHODS_HULLS_TOOLS_BORDERS_H
#include "kernels/hulls/corner.h"

/* Two runs of one image: arrays with an element per pixel; irradiance has three channels. */
typedef struct {
	const ts_gpixel *pixels;
	const u32 *boxes;          /* hull.box */
	const f32 *hulls, *direct; /* indirect.irradiance */
	u32 width, height, grid;   /* the grid: texels a side */
} ts_borders_of;

/* Over neighbouring pixels, beside or below each other, with similar depth (2 %) and normal (cosine 0.99): the sum of
 * |change of hulls - change of direct| over the sum of the irradiance of direct, of all channels. NAN if there are no
 * such pixels, or no light. */
typedef struct {
	double across; /* in two blocks of the grid */
	double within; /* in one box */
} ts_borders;
ts_borders ts_borders_measure(const ts_borders_of *of);

/* Pairs of a corner and a triangle of light that faces the corner. */
typedef struct {
	u64 facing;
	u64 counted; /* to which the ramp of corner.facing leaves a share */
	u64 full;    /* to which the ramp leaves the whole */
} ts_facing_pairs;
ts_facing_pairs ts_facing_count(const ts_moment *corners, u64 n_corners, const ts_patch *patches, u64 n_patches);

#endif
