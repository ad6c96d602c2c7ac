/* The primitives that all methods share (vectors.def). */
#ifndef TS_KERNELS_VECTORS_H
#define TS_KERNELS_VECTORS_H
#include "vectors_args.h"
#include "vectors_number.h"
#include "vectors_raster.h"
#include "vectors_texture.h"

#define VECTOR(name) TS_PRIMITIVE_##name,
typedef enum {
#include "vectors.def"
	TS_N_PRIMITIVES,
} ts_primitive;
#undef VECTOR

/* map over rows */
TS_FN void ts_k_vectors_item(const ts_vectors_args *args, u64 i)
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
