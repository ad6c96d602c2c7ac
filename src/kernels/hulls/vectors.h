/* Primitives of gathered light: spherical Gaussians, triangles of light, and lobes of surfaces (gaussian.h,
 * form_factor.h). */
#ifndef TS_KERNELS_HULLS_VECTORS_H
#define TS_KERNELS_HULLS_VECTORS_H
#include "kernels/hulls/form_factor.h"
#include "kernels/hulls/gaussian.h"
#include "kernels/vectors/vectors_args.h"

TS_VECTOR_FLOAT(sg_cosine, ts_k_sg_cosine(TS_A, TS_B, in[2], in[3]))
TS_VECTOR_FLOAT(sg_sharpness, ts_k_sg_sharpness(TS_A, in[1]))
TS_VECTOR_FLOAT(solid_angle,
                ts_k_solid_angle(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u), ts_row_v3(in, 9u)))
TS_VECTOR_FLOAT(form_factor, ts_k_form_factor(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u),
                                              ts_row_v3(in, 9u), ts_row_v3(in, 12u)))

/* mu, lambda and phi. */
TS_FN ts_sg ts_row_sg(TS_GLOBAL const u32 *row, u32 k)
{
	return ts_sg_make(ts_row_f32(row, k), ts_row_f32(row, k + 1u), ts_row_v3(row, k + 2u));
}

TS_FN void ts_set_sg(TS_GLOBAL u32 *row, const ts_sg *g)
{
	ts_set_f32(row, 0u, g->mu);
	ts_set_f32(row, 1u, g->lambda);
	ts_set_v3(row + 2u, g->phi);
}

TS_VECTOR(sg_product)
{
	ts_sg a = ts_row_sg(in, 0u);
	ts_sg b = ts_row_sg(in, 5u);
	ts_sg both = ts_k_sg_product(&a, &b);
	ts_set_sg(out, &both);
}

TS_VECTOR(gloss_lobe)
{
	ts_sg lobe = ts_k_gloss_lobe(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_f32(in, 6u));
	ts_set_sg(out, &lobe);
}

#define TS_LIST_hulls_vectors(VECTOR) \
	VECTOR(sg_cosine) \
	VECTOR(sg_sharpness) \
	VECTOR(solid_angle) \
	VECTOR(form_factor) \
	VECTOR(sg_product) \
	VECTOR(gloss_lobe)
/* map over rows */
TS_VECTORS(hulls_vectors)

#endif
