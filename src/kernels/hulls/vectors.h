/* Primitives of light that is gathered: spherical Gaussians and triangles that shine (gaussian.h, form_factor.h). */
#ifndef TS_KERNELS_HULLS_VECTORS_H
#define TS_KERNELS_HULLS_VECTORS_H
#include "../vectors/vectors_args.h"
#include "form_factor.h"
#include "gaussian.h"

TS_VECTOR_FLOAT(sg_cosine, ts_k_sg_cosine(TS_A, TS_B, in[2], in[3]))
TS_VECTOR_FLOAT(sg_sharpness, ts_k_sg_sharpness(TS_A, in[1]))
TS_VECTOR_FLOAT(solid_angle,
                ts_k_solid_angle(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u), ts_row_v3(in, 9u)))
TS_VECTOR_FLOAT(form_factor, ts_k_form_factor(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u),
                                              ts_row_v3(in, 9u), ts_row_v3(in, 12u)))

#define VECTOR(name) TS_PRIMITIVE_##name,
typedef enum {
#include "vectors.def"
	TS_N_HULLS_PRIMITIVES,
} ts_hulls_primitive;
#undef VECTOR

/* map over rows */
TS_FN void ts_k_hulls_vectors_item(const ts_vectors_args *args, u64 i)
{
	TS_GLOBAL const u32 *in = args->in + i * args->in_words;
	TS_GLOBAL u32 *out = args->out + i * args->out_words;
#define VECTOR(name) \
	case TS_PRIMITIVE_##name: ts_k_vector_##name(out, in); break;
	switch (args->primitive) {
#include "vectors.def"
	}
#undef VECTOR
}

#endif
