/* Arithmetic vectors: every primitive that a device must compute with the same bits (CONTRACT rule 32), over the rows
 * that ts_vector_make fills. One kernel for the primitives of all methods, and one for those of each family that has
 * some. */
#ifndef TS_KERNELS_VECTORS_VECTORS_ARGS_H
#define TS_KERNELS_VECTORS_VECTORS_ARGS_H
#include "kernels/base/args.h"
#include "kernels/vectors/vectors_row.h"

#define TS_ROWS_ts_vectors_args(ARG) \
	ARG(WORK_IN, u32, in, tallies)   /* rows of in_words */ \
	ARG(WORK, u32, out, other)       /* rows of out_words, from a multiple of 8 bytes on */ \
	ARG(VALUE, u32, primitive, none) /* index in the list of the kernel */ \
	ARG(VALUE, u32, in_words, none) \
	ARG(VALUE, u32, out_words, none)
TS_ARGS(ts_vectors_args);

/* Defines the kernel of a list, TS_LIST_<kernel>(VECTOR), which has a VECTOR(name) for each ts_k_vector_<name>. */
#define TS_VECTOR_PLACE(name) TS_PLACE_##name,
#define TS_VECTOR_CASE(name) \
	case TS_PLACE_##name: \
		ts_k_vector_##name(out, in); \
		break;
#define TS_VECTORS(kernel) \
	enum { TS_LIST_##kernel(TS_VECTOR_PLACE) TS_N_##kernel }; \
	TS_FN void ts_k_##kernel##_item(const ts_vectors_args *args, u64 i) \
	{ \
		TS_GLOBAL const u32 *in = args->in + i * args->in_words; \
		TS_GLOBAL u32 *out = args->out + i * args->out_words; \
		switch (args->primitive) { \
			TS_LIST_##kernel(TS_VECTOR_CASE) \
		} \
	}

#endif
