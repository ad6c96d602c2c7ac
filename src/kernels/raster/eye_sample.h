/* Samples of the eye's pixels (METHODS 1): one in the middle, or four on a rotated grid. No two of the four share a row
 * or a column of 4 x 4, so that a nearly horizontal or vertical edge passes them one by one (Akenine-Moller and Strom,
 * "Graphics for the Masses", 2003). Places and order are the standard sample locations of Vulkan and Direct3D 11.
 *
 * Buffers of the eye have eye_rows rows: one picture per sample, one below the other. A sample's view is the eye's view
 * with the image shifted, so that the sample lies where the middle of the pixel was. Snapped corners move by whole
 * 1/256 pixels, so all samples see the same edges. */
#ifndef TS_KERNELS_RASTER_EYE_SAMPLE_H
#define TS_KERNELS_RASTER_EYE_SAMPLE_H
#include "kernels/raster/view.h"

#define TS_N_EYE_SAMPLES 4u

/* Places of the samples, in 1/256 pixel from the upper left corner. */
TS_CONSTANT i32 ts_eye_sample[TS_N_EYE_SAMPLES][2] = {{96, 32}, {224, 96}, {32, 160}, {160, 224}};

/* The view of a sample. samples: TS_N_EYE_SAMPLES, or 1. */
TS_FN ts_camera_k ts_k_eye_view(TS_GLOBAL const ts_view *eye, u32 samples, u32 sample)
{
	ts_camera_k r = ts_k_view(eye);
	if (samples != TS_N_EYE_SAMPLES) return r;
	r.shift_x = TS_SUB_CENTRE - ts_eye_sample[sample][0];
	r.shift_y = TS_SUB_CENTRE - ts_eye_sample[sample][1];
	r.side = 0.5f;
	return r;
}

/* The place of an element of the eye's buffers: the view of its sample, its pixel, and the first element of the
 * sample. */
typedef struct {
	ts_camera_k view;
	u64 first;
	i32 x, y;
} ts_eye_place;

TS_FN ts_eye_place ts_k_eye_place(TS_GLOBAL const ts_view *eye, u32 samples, u64 i)
{
	u64 pixels = (u64)eye->width * (u64)eye->height;
	u32 sample = (u32)(i / pixels);
	ts_eye_place r;
	r.view = ts_k_eye_view(eye, samples, sample);
	r.first = (u64)sample * pixels;
	r.x = (i32)((i - r.first) % (u64)eye->width);
	r.y = (i32)((i - r.first) / (u64)eye->width);
	return r;
}

#endif
