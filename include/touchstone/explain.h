/* SPDX-License-Identifier: Apache-2.0 */
/* What one item of a stage computes, line by line: each parameter, variable, decision, result and store of its kernel,
 * with values and bits, and the titles of its paragraphs. Two traces can be compared: then the answer also names the
 * first line that differs, and the paragraph in which the traces part. */
#ifndef TOUCHSTONE_EXPLAIN_H
#define TOUCHSTONE_EXPLAIN_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/context.h>
#include <touchstone/status.h>
#include <touchstone/trace.h>
#include <touchstone/tree.h>
#ifdef __cplusplus
extern "C" {
#endif

/* The question. All members but `bytes` and `stage` may be 0: then the answer only lists the launches of the stage. */
typedef struct {
	size_t bytes; /* sizeof(ts_explain_options) */
	const char *stage;
	const char *buffer; /* a buffer that the stage makes: explains the item that gave `element` its value */
	uint64_t element;   /* its index in `buffer` */
	int item_said;      /* not 0, without a buffer: explains `item` of each launch */
	uint64_t item;
	const char *kernel; /* only launches of this kernel; NULL: all launches */
	int primitives;     /* not 0: also the lines of functions that all kernels share */
	uint64_t lines;     /* at most this many lines are kept; 0: 20000, or 1000000 for an outline */
	int as_text;        /* not 0: the answer is text for people */
	int outline;        /* not 0: each title once, with the last values of what its paragraph leaves */
} ts_explain_options;

/* Runs the stage of `trace` once more and explains what the options ask for.
 * In: inputs: the stage reads these buffers where they exist, as in ts_replay; NULL: the trace's own. other: a second
 *   trace, whose lines stand beside those of the first; NULL: none. At most one of `inputs` and `other` is given.
 * Out: *answer is an object, as `explain --json` prints it, or with as_text a list of texts, one per line. If lines
 *   are left out, the last text begins with their number; no other text begins with a digit. Release *answer by
 *   ts_tree_free; NULL on failure.
 * Returns: TS_OK; TS_DIFFERENT if a line of the two traces differs. */
TS_API ts_status ts_explain_item(ts_context *context, ts_tree **answer, const ts_explain_options *options,
                                 const ts_trace *trace, const ts_trace *inputs, const ts_trace *other);

#ifdef __cplusplus
}
#endif
#endif
