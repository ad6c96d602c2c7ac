/* Judging a port: buffer by buffer against a reference, or one stage given the port's own inputs.
 *
 *   ts_verdicts *verdicts;
 *   if (ts_replay(context, &verdicts, "splat", reference, candidate, NULL) == TS_DIFFERENT)
 *           puts(ts_verdicts_first(verdicts)->line);
 *   ts_verdicts_free(verdicts); */
#ifndef TOUCHSTONE_COMPARE_H
#define TOUCHSTONE_COMPARE_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/context.h>
#include <touchstone/status.h>
#include <touchstone/trace.h>
#ifdef __cplusplus
extern "C" {
#endif

/* What was judged, and how. */
typedef struct ts_verdicts ts_verdicts;

/* How to compare. All members but `bytes` may be 0: then everything must have the same bits. */
typedef struct {
	size_t bytes;        /* sizeof(ts_compare_options) */
	int forced;          /* not 0: each stage is judged given the candidate's own inputs */
	int decided;         /* not 0: only what the reference decides is judged; it must have its margins */
	uint64_t ulp;        /* floats may differ by this many ulps, */
	double abs, rel;     /* or by this much, or by this part of the reference; no number passes for an infinity */
	uint64_t allow;      /* this many elements of a buffer may differ */
	const char *ignore;  /* "BUFFER,BUFFER.field,...": not judged */
	const uint8_t *mask; /* mask_height rows of mask_width: pixel buffers are judged only where it is not 0 */
	uint32_t mask_width, mask_height;
} ts_compare_options;

/* Compares a candidate with a reference of the same method, in the order of the stages. The traces are not needed
 * after.
 * In: options NULL: everything must have the same bits.
 * Out: *verdicts is to be released by ts_verdicts_free; NULL with TS_ERROR.
 * Returns: TS_OK if all that was judged is the same, TS_DIFFERENT if not, TS_ERROR if the traces could not be compared
 * or nothing could be judged. */
TS_API ts_status ts_compare(ts_context *context, ts_verdicts **verdicts, const ts_trace *reference,
                            const ts_trace *candidate, const ts_compare_options *options);

/* Runs one stage on the candidate's inputs, and compares what the stage makes with the candidate's outputs. Inputs that
 * the candidate lacks are the reference's. An output that the candidate lacks is "missing"; without any output nothing
 * can be judged: TS_ERROR. The inputs are checked first; inputs that the stage cannot run on are refused.
 * In: candidate NULL: the reference is judged. options: as for ts_compare; `forced` means nothing here.
 * Out, Returns: as for ts_compare. */
TS_API ts_status ts_replay(ts_context *context, ts_verdicts **verdicts, const char *stage, const ts_trace *reference,
                           const ts_trace *candidate, const ts_compare_options *options);

/* Runs one stage on the same inputs, and hands out what the stage makes.
 * Out: *trace is to be released by ts_trace_close; NULL on failure. */
TS_API ts_status ts_trace_replay(ts_context *context, ts_trace **trace, const char *stage, const ts_trace *reference,
                                 const ts_trace *candidate);

/* How one buffer was judged. */
typedef struct {
	const char *stage; /* that makes the buffer, or "scene" */
	const char *buffer;
	const char *verdict;               /* "same", "different", "missing", "ignored", "not judged" */
	const char *why;                   /* why the buffer could not be judged, or has another shape; otherwise "" */
	uint64_t n_reference, n_candidate; /* elements */
	uint64_t n_different;              /* elements that differ, those without a partner included */
	uint64_t n_missing, n_extra;       /* records of a set that the candidate lacks, and that only it has */
	uint64_t n_relaxed;                /* elements that only a relaxation let pass */
	uint64_t n_masked;                 /* elements that the mask left out */
	uint64_t n_undecided;              /* elements that differ where the reference does not decide */
} ts_verdict_info;

/* Buffer i, from 0, of the reference's buffers in the order of the stages; after a replay, of the stage's outputs. NULL
 * behind the last. */
TS_API const ts_verdict_info *ts_verdicts_at(const ts_verdicts *verdicts, size_t i);

/* The first divergence: the first element that differs of the first stage that differs. */
typedef struct {
	const char *stage, *buffer;
	const char *how;    /* "different"; for records of a set also "missing", "not of the reference", "twice" */
	uint64_t element;   /* index in the reference; for a record that only the candidate has, its index there */
	const char *where;  /* "pixel (12, 40)", "key (piece 812, x 5, y 3)" */
	const char *field;  /* of a record; otherwise "" */
	uint32_t component; /* of the field */
	uint64_t reference_bits, candidate_bits;
	const char *reference, *candidate; /* values and bits, as text */
	int64_t ulps;                      /* from the reference to the candidate; 0: not floats; INT64_MAX: one is a NaN */
	const char *inputs;                /* "inputs identical", or which inputs differ or were not given */
	const char *line;                  /* all of it in one line, as `touchstone compare` ends */
} ts_divergence;

/* NULL: nothing differs. */
TS_API const ts_divergence *ts_verdicts_first(const ts_verdicts *verdicts);

/* Releases verdicts; NULL is allowed. */
TS_API void ts_verdicts_free(ts_verdicts *verdicts);

#ifdef __cplusplus
}
#endif
#endif
