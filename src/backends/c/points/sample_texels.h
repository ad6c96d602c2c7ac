/* The texels that the samples of a reflective pixel read: those of ts_k_lookup. */
#ifndef TS_BACKENDS_C_POINTS_SAMPLE_TEXELS_H
#define TS_BACKENDS_C_POINTS_SAMPLE_TEXELS_H
#include "kernels/points/mirror_pixel.h"
#include "kernels/points/samples.h"

enum { TS_SAMPLE_ROOM = 32 }; /* samples of a pixel, in whole vectors */

typedef struct {
	f32 x[TS_SAMPLE_ROOM], y[TS_SAMPLE_ROOM];
} ts_sample_offsets;

ts_sample_offsets ts_sample_offsets_of(u32 n_samples);
/* Indices of the texels in a cube of n texels per side. Elements of `to` beyond the last sample are written too. */
void ts_sample_texels(u32 to[TS_SAMPLE_ROOM], const ts_sample_offsets *o, const ts_pixel *of, ts_v3 eye, u32 n);

#endif
