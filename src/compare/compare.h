/* Compares a candidate with a reference, buffer by buffer in the order of the pipeline: exactly, unless relaxations are
 * given. */
#ifndef TS_COMPARE_COMPARE_H
#define TS_COMPARE_COMPARE_H
#include <touchstone/compare.h>
#include "compare/difference.h"
#include "compare/order.h"
#include "compare/relax.h"

enum { TS_WHY_TEXT = 1024 };

typedef struct {
	ts_judgement judgement;
	u64 n_ref, n_cand;          /* elements */
	u64 n_different;            /* elements, with those without a partner; of prefix sums the counts */
	u64 n_missing, n_extra;     /* records of a set without a partner, in the reference and in the candidate */
	u64 n_field[TS_MAX_FIELDS]; /* elements that differ in each field of ts_fields_of */
	u64 n_tied;                 /* texels where another of the tied records won, which is allowed */
	u64 n_relaxed;              /* elements that only a relaxation let pass */
	u64 n_masked;               /* elements that the mask left out */
	u64 n_undecided;            /* elements that differ where the reference does not decide */
	bool has_first;             /* false: only partners are missing */
	ts_difference first, worst; /* worst: of floats, by ulps */
	i64 worst_ulps;
	char why[TS_WHY_TEXT]; /* TS_UNABLE: the reason; TS_UNLIKE: both shapes, if no element was compared; otherwise "" */
	bool by_digest;        /* a file is left out: `why` says how digests differ, and no element was compared */
	bool aside;            /* not counted: judged only to know whether inputs of others differ */
	double seconds;        /* of ts_compare_traces or ts_compare_forced; those of a stage are with its first output */
	/* Set by the caller. */
	u8 *marks;           /* receives 1 for each element that differs; NULL: not wanted */
	ts_differences list; /* receives the first differences: records without a partner, then elements */
} ts_verdict;

typedef struct {
	ts_verdict verdict[TS_N_BUFFERS];
	u32 n_judged, n_unlike, n_missing, n_unable;
	bool forced;               /* judged by ts_compare_forced: */
	char refusal[TS_WHY_TEXT]; /* the first reason why a stage could not be replayed from its inputs; "" if none */
	ts_buffer_id first;        /* first buffer that differs, in the order of the pipeline; TS_N_BUFFERS: none */
	ts_named *named;           /* memory of the lists of all verdicts; NULL: there are no lists */
	u32 most;                  /* differences that each list has room for */
} ts_comparison;

/* A comparison whose lists have room for the first `most` differences of each buffer; NULL with the message set on
 * failure. Release by ts_comparison_free. A comparison that is all zero has no lists. */
ts_comparison *ts_comparison_make(u32 most);
/* NULL is allowed. */
void ts_comparison_free(ts_comparison *comparison);
/* Clears everything except the memory of the lists. */
void ts_comparison_begin(ts_comparison *comparison);

/* TS_OK: all judged buffers are the same. TS_DIFFERENT: they are not. TS_ERROR: the comparison failed, or no buffer
 * could be judged although all may be, or a shape that the frame fixes differs. The comparison is filled in the first
 * two cases. */
ts_status ts_compare_traces(ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                            const ts_relaxations *relaxations);

/* Judges one buffer that both must have, as ts_compare_traces does. Of *verdict only `marks` and `list` are read.
 * TS_SKIPPED: its points are in an unknown order. */
ts_status ts_compare_alone(ts_verdict *verdict, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                           const ts_relaxations *relaxations);

/* Judges one buffer that both have. Of *verdict only `marks` and `list` are read. */
ts_status ts_compare_buffer(ts_verdict *verdict, ts_buffer_id id, const ts_trace *reference, const ts_trace *candidate,
                            const ts_order *order, const ts_relaxations *relaxations);

/* Whether the trace has the buffer's file, or at least its digest. */
bool ts_digest_known(const ts_trace_item *item);

/* Marks the buffers that the stages "scene,split,..." make. Fails if a name is of no stage, or both traces have no such
 * buffer in common. */
ts_status ts_part_make(bool part[TS_N_BUFFERS], const char *stages, const ts_trace *reference,
                       const ts_trace *candidate, const ts_relaxations *relaxations);
/* Judges the buffers outside the part that a stage with a difference has read, without counting them: by them the
 * report says whether inputs are identical. */
ts_status ts_part_inputs(ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                         const ts_relaxations *relaxations);

#endif
