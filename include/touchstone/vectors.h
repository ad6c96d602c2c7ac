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

/* A primitive. */
typedef struct {
	const char *name;
	const char *rule; /* of CONTRACT, or the kernel that defines it */
	const char *doc;
	uint32_t items;                   /* rows */
	uint32_t in_words, out_words;     /* of a row */
	const char *in_dtype, *out_dtype; /* as numpy writes them */
	int composed;                     /* not 0: of several primitives, whose bits follow if theirs are right */
} ts_vector_info;

/* Primitive i, from 0, in the order in which to port them: each relies on those before it. NULL behind the last. */
TS_API const ts_vector_info *ts_vector_at(size_t i);

/* Fills `in` with the items * in_words words of a primitive's inputs, and `out` with the items * out_words words that
 * are right; each may be NULL. The words are always the same. */
TS_API ts_status ts_vector_words(ts_context *context, uint32_t *in, uint32_t *out, const char *primitive);

/* The verdict on a port's outputs. */
typedef struct {
	size_t bytes;        /* sizeof(ts_vector_judged); set by the caller */
	uint32_t n_wrong;    /* items */
	uint32_t first;      /* the first wrong one */
	uint32_t first_word; /* of its row of outputs */
	const char *fault;   /* the known fault that gives most of the wrong items; NULL: no known fault does */
	const char *remedy;
} ts_vector_judged;

/* Judges items * out_words words that a port computed from a primitive's inputs.
 * Returns: TS_OK if all are right, TS_DIFFERENT if not. */
TS_API ts_status ts_vector_check(ts_context *context, ts_vector_judged *judged, const char *primitive,
                                 const uint32_t *found);

#ifdef __cplusplus
}
#endif
#endif
