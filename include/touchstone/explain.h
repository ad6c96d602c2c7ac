/* What one item of a stage computes, line by line: each parameter, variable, decision, result and store of its kernel,
 * with values and bits. Of two traces, the first line that differs. */
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

/* The question; all but `bytes` and `stage` may be 0: then only the launches of the stage are listed. */
typedef struct {
	size_t bytes; /* sizeof(ts_explain_options) */
	const char *stage;
	const char *buffer; /* the item that gave an element of this buffer, which the stage makes, its value; */
	uint64_t element;   /* this one */
	int item_said;      /* without a buffer: not 0: */
	uint64_t item;      /* this item of each launch, */
	const char *kernel; /* of launches of this kernel; NULL: of all */
	int primitives;     /* not 0: also what functions do that are no kernel's own */
	uint64_t lines;     /* that are told, at most; 0: 20000 */
	int as_text;        /* not 0: as lines for people */
} ts_explain_options;

/* Answers of `trace`. inputs: its stage is given these buffers first, as ts_replay gives a candidate's; NULL: its own.
 * other: the same of a second trace, given its buffers, beside the first; NULL: none. One of the two at most.
 * TS_OK: told; of two traces all lines are the same. TS_DIFFERENT: they are not. *answer is an object as
 * `explain --json` has it, or, as_text, a list of texts, one a line; where lines are left out, the last text, and no
 * other, begins with a digit: their number. Release by ts_tree_free; NULL on failure. */
TS_API ts_status ts_explain_item(ts_context *context, ts_tree **answer, const ts_explain_options *options,
                                 const ts_trace *trace, const ts_trace *inputs, const ts_trace *other);

#ifdef __cplusplus
}
#endif
#endif
