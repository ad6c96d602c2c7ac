/* Primitives of light that is gathered: spherical Gaussians and triangles that shine (gaussian.h, form_factor.h). */
#ifndef TS_KERNELS_VECTORS_LIGHT_H
#define TS_KERNELS_VECTORS_LIGHT_H
#include "../hulls/form_factor.h"
#include "../hulls/gaussian.h"
#include "vectors_row.h"

TS_VECTOR_FLOAT(sg_cosine, ts_k_sg_cosine(TS_A, TS_B, in[2], in[3]))
TS_VECTOR_FLOAT(sg_sharpness, ts_k_sg_sharpness(TS_A, in[1]))
TS_VECTOR_FLOAT(solid_angle,
                ts_k_solid_angle(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u), ts_row_v3(in, 9u)))
TS_VECTOR_FLOAT(form_factor, ts_k_form_factor(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u), ts_row_v3(in, 9u),
                                              ts_row_v3(in, 12u)))

#endif
