/* Arithmetic vectors: every primitive that a device must compute with the same bits (CONTRACT rule 32), over the rows
 * that ts_vector_make fills. One kernel for the primitives of all methods, and one for those of each family that has
 * some. */
#ifndef TS_KERNELS_VECTORS_ARGS_H
#define TS_KERNELS_VECTORS_ARGS_H
#include "../base/args.h"
#include "vectors_row.h"

#define TS_ROWS_ts_vectors_args(ARG) \
	ARG(WORK_IN, u32, in, tallies)   /* rows of in_words */ \
	ARG(WORK, u32, out, other)       /* rows of out_words, from a multiple of 8 bytes on */ \
	ARG(VALUE, u32, primitive, none) /* place in the list of the kernel */ \
	ARG(VALUE, u32, in_words, none) \
	ARG(VALUE, u32, out_words, none)
TS_ARGS(ts_vectors_args);

#endif
