/* The alpha mask of a piece's samples, with the bits of ts_k_is_cut: values that the samples share are computed once,
 * and only the alpha of texels is read. */
#ifndef TS_BACKENDS_C_POINTS_SAMPLE_MASK_H
#define TS_BACKENDS_C_POINTS_SAMPLE_MASK_H
#include "kernels/raster/lattice.h"

typedef struct {
	ts_v2 corner[3]; /* of the triangle, in the lattice */
	f32 alpha[3];    /* of its vertices */
	f32 factor, cutoff;
	const ts_slot *slot; /* NULL: no texture */
	ts_v2 uv[3];
	ts_texture_level level[2];
	u32 next; /* weight of the second level, in 1/256; 0: there is none */
} ts_sample_mask;

/* The mask of a piece of a triangle with a masked material; the scale of the piece's frame is above 0. */
ts_sample_mask ts_sample_mask_of(const ts_arrays *scene, const ts_align *frame, u32 triangle);
bool ts_sample_mask_cuts(const ts_sample_mask *mask, i32 x, i32 y);

#endif
