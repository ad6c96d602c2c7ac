/* Comparing a candidate with a reference, buffer by buffer in the order of the pipeline: exactly, unless told
 * otherwise. */
#ifndef TS_TRACE_COMPARE_H
#define TS_TRACE_COMPARE_H
#include "../trace/field.h"
#include "order.h"
#include "../trace/read.h"
#include "relax.h"

typedef enum {
	TS_NOT_JUDGED, /* the reference lacks it, or neither has it */
	TS_MISSING,    /* the candidate lacks it */
	TS_IGNORED,
	TS_SAME,
	TS_UNLIKE,
} ts_judgement;

/* One difference. */
typedef struct {
	u64 element; /* in the reference's order */
	u32 field, component;
	u64 ref, cand; /* bits; an index of the candidate is mapped to the reference's order */
} ts_difference;

typedef struct {
	ts_judgement judgement;
	u64 n_ref, n_cand;               /* elements */
	u64 n_different;                 /* elements, those without a partner included */
	u64 n_missing, n_extra, n_twice; /* records of a set without a partner; the last: whose key is there twice */
	u64 missing_key, extra_key;
	u64 n_tied;                 /* texels where another of the tied records won, as it may */
	u64 n_relaxed;              /* elements that only a relaxation let pass */
	u64 n_masked;               /* elements that the mask left out */
	u64 n_undecided;            /* elements that differ where the reference does not decide */
	bool has_first;             /* false: only partners are missing */
	ts_difference first, worst; /* worst: of floats, by ulps */
	i64 worst_ulps;
	u8 *marks; /* set by the caller: receives 1 for each element that differs; NULL: not wanted */
} ts_verdict;

typedef struct {
	ts_verdict verdict[TS_N_BUFFERS];
	u32 n_judged, n_unlike, n_missing;
	bool forced;        /* judged by ts_compare_forced */
	ts_buffer_id first; /* first buffer, in the order of the pipeline, that is unlike; TS_N_BUFFERS: none */
} ts_comparison;

/* TS_OK: all that was judged is the same; TS_DIFFERENT; TS_ERROR: could not, also where nothing could be judged or a
 * shape that the frame fixes is another. The comparison is filled in either of the first two cases. */
ts_status ts_compare(ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                     const ts_relaxations *relaxations);

/* Judges one buffer that both have. Of *verdict only `marks` is read. */
ts_status ts_compare_buffer(ts_verdict *verdict, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                            const ts_order *order, const ts_relaxations *relaxations);

#endif
