/* SPDX-License-Identifier: Apache-2.0 */
/* Arithmetic vectors: inputs and outputs of every primitive that a port must compute with the same bits (CONTRACT rule
 * 32). A row holds the columns of one item as 32-bit words without padding, 64-bit values low word first. */
#ifndef TOUCHSTONE_VECTORS_H
#define TOUCHSTONE_VECTORS_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/context.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

/* What a column's elements are; those of 64 bits have two words. */
typedef enum { TS_VECTOR_F32, TS_VECTOR_I32, TS_VECTOR_U32, TS_VECTOR_I64, TS_VECTOR_U64 } ts_vector_type;

/* A column of a primitive's rows: an argument, or a result. */
typedef struct {
	const char *name; /* "" of outputs that are no record */
	ts_vector_type type;
	uint32_t count; /* elements, at least 1 */
	uint32_t word;  /* of a row: the first of the column's */
} ts_vector_column_info;

/* A primitive. */
typedef struct {
	const char *name;
	const char *rule; /* of CONTRACT, or the kernel that defines it */
	const char *doc;
	uint32_t items;                   /* rows */
	uint32_t in_words, out_words;     /* of a row */
	const char *in_dtype, *out_dtype; /* as numpy writes them */
	int composed;                     /* not 0: of several primitives, whose bits follow if theirs are right */
	int record;                       /* not 0: outputs are a record of columns with names; 0: of one without */
	uint32_t n_inputs, n_outputs;     /* columns */
	const ts_vector_column_info *inputs, *outputs;
	uint32_t n_dims;   /* 1 or 2: of the outputs as an array of out_dtype */
	uint64_t shape[2]; /* of that array: items, and elements of an item */
} ts_vector_info;

/* Primitive i, from 0, in the order in which to port them: each relies on those before it. NULL behind the last. */
TS_API const ts_vector_info *ts_vector_at(size_t i);

/* Fills `in` with the items * in_words words of a primitive's inputs, and `out` with the items * out_words words that
 * are right; each may be NULL. The words are always the same. The context keeps those of the last primitive, so that
 * ts_vector_check need not make them again. */
TS_API ts_status ts_vector_words(ts_context *context, uint32_t *in, uint32_t *out, const char *primitive);

/* The verdict on a port's outputs. Where all are right, all members but `bytes` are 0. */
typedef struct {
	size_t bytes;        /* sizeof(ts_vector_judged); set by the caller */
	uint32_t n_wrong;    /* items */
	uint32_t first;      /* the first wrong one */
	uint32_t first_word; /* of its row of outputs: where its first wrong value is */
	const char *fault;   /* the known fault that gives most of the wrong items; NULL: no known fault does */
	const char *remedy;
	uint32_t n_explained;    /* wrong items that `fault` gives */
	uint32_t first_column;   /* of the outputs: the column of that first wrong value */
	uint32_t first_element;  /* of that column */
	int first_nan;           /* not 0: a float was found that is no number; first_apart is 0 then */
	int64_t first_apart;     /* found less right: steps between floats, -0 being one below 0; of integers modulo 2^64 */
	const char *first_fault; /* a known fault that gives the first wrong item: `fault` if that does; NULL: none does */
	const char *first_remedy;
} ts_vector_judged;

/* Judges items * out_words words that a port computed from a primitive's inputs.
 * Out: *judged, unless the call fails.
 * Returns: TS_OK if all are right, TS_DIFFERENT if not. */
TS_API ts_status ts_vector_check(ts_context *context, ts_vector_judged *judged, const char *primitive,
                                 const uint32_t *found);

#ifdef __cplusplus
}
#endif
#endif
