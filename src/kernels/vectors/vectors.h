/* Arithmetic vectors: every primitive that a device must compute with the same bits (CONTRACT rule 32), over the rows
 * that ts_vector_make fills. */
#ifndef TS_KERNELS_VECTORS_H
#define TS_KERNELS_VECTORS_H
#include "../base/args.h"
#include "vectors_light.h"
#include "vectors_number.h"
#include "vectors_raster.h"
#include "vectors_texture.h"

#define VECTOR(name) TS_PRIMITIVE_##name,
typedef enum {
#include "vectors.def"
	TS_N_PRIMITIVES
} ts_primitive;
#undef VECTOR

#define TS_ROWS_ts_vectors_args(ARG) \
	ARG(WORK_IN, u32, in, tallies) /* rows of in_words */ \
	ARG(WORK, u32, out, other) /* rows of out_words, from a multiple of 8 bytes on */ \
	ARG(VALUE, u32, primitive, none) /* ts_primitive */ \
	ARG(VALUE, u32, in_words, none) \
	ARG(VALUE, u32, out_words, none)
TS_ARGS(ts_vectors_args);

/* map over rows */
TS_FN void ts_k_vectors_item(const ts_vectors_args *args, u64 i)
{
	TS_GLOBAL const u32 *in = args->in + i * args->in_words;
	TS_GLOBAL u32 *out = args->out + i * args->out_words;
#define VECTOR(name) case TS_PRIMITIVE_##name: ts_k_vector_##name(out, in); break;
	switch (args->primitive) {
#include "vectors.def"
	}
#undef VECTOR
}

#endif
