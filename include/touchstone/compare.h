/* SPDX-License-Identifier: Apache-2.0 */
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
#include <touchstone/tree.h>
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
	uint32_t first;     /* at most this many differences of each buffer are reported; 0: one */
	const char *stages; /* "scene,split,...": only buffers that these stages make are judged; NULL: all */
	int lent;           /* ts_replay only: not 0: the reference's outputs stand in for those that the candidate lacks */
} ts_compare_options;

/* Compares a candidate with a reference of the same method, in the order of the stages. The verdicts do not refer to
 * the traces.
 * In: options NULL: everything must have the same bits.
 * Out: *verdicts is to be released by ts_verdicts_free; NULL with TS_ERROR.
 * Returns: TS_OK if all that was judged is the same, TS_DIFFERENT if not, TS_ERROR if the traces could not be compared
 * or nothing could be judged. */
TS_API ts_status ts_compare(ts_context *context, ts_verdicts **verdicts, const ts_trace *reference,
                            const ts_trace *candidate, const ts_compare_options *options);

/* Runs one stage on the candidate's inputs, and compares what the stage makes with the candidate's outputs. The
 * reference's inputs stand in for those that the candidate lacks. An output that the candidate lacks is "missing". A
 * candidate without any output is an error, and so are inputs that the stage cannot run on.
 * In: candidate NULL: the reference is judged. options: as for ts_compare; `forced` and `stages` are not read. With
 *   `lent`, outputs that neither trace has are "missing", and not an error.
 * Out, Returns: as for ts_compare. */
TS_API ts_status ts_replay(ts_context *context, ts_verdicts **verdicts, const char *stage, const ts_trace *reference,
                           const ts_trace *candidate, const ts_compare_options *options);

/* Runs one stage on the inputs that ts_replay would take, and returns what the stage makes as a trace.
 * Out: *trace is to be released by ts_trace_close; NULL on failure. */
TS_API ts_status ts_trace_replay(ts_context *context, ts_trace **trace, const char *stage, const ts_trace *reference,
                                 const ts_trace *candidate);

/* How a buffer was judged. */
typedef enum {
	TS_NOT_JUDGED, /* the reference lacks it and its digest, or neither has it */
	TS_MISSING,    /* the candidate lacks it */
	TS_IGNORED,
	TS_UNABLE, /* the right values are not known: `why` says the reason */
	TS_SAME,
	TS_UNLIKE,
} ts_judgement;

/* The verdict on one buffer. */
typedef struct {
	const char *stage; /* that makes the buffer, or "scene" */
	const char *buffer;
	const char *verdict;               /* "same", "different", "missing", "ignored", "not judged" */
	const char *why;                   /* why the buffer could not be judged, or has another shape or digest; or "" */
	uint64_t n_reference, n_candidate; /* elements */
	uint64_t n_different;              /* elements that differ, those without a partner included */
	uint64_t n_missing, n_extra;       /* records of a set that the candidate lacks, and that only it has */
	uint64_t n_relaxed;                /* elements that only a relaxation let pass */
	uint64_t n_masked;                 /* elements that the mask left out */
	uint64_t n_undecided;              /* elements that differ where the reference does not decide */
	ts_judgement judgement;
	uint32_t number;    /* of the stage in names of files; 0: the scene */
	int by_digest;      /* not 0: a file is left out, so digests were compared, and no elements */
	int by_counts;      /* not 0: prefix sums, judged by their counts, as a wrong count moves all later sums */
	uint64_t n_tied;    /* texels where another of the tied records won, which is allowed */
	int64_t worst_ulps; /* largest distance of floats */
	double seconds;     /* time that judging took */
	int has_first;      /* not 0: `first_element` is the first element of both that differs */
	uint64_t first_element;
	const char *first; /* the first difference, and how many there are; "" if none */
	const char *line;  /* the same with stage, buffer and the state of the inputs; "" if none */
	const char *note;  /* a remark on the difference; "" if none */
	const char *file;  /* ts_replay: the file whose elements were judged, or the buffer's name */
	int cropped;       /* ts_replay: not 0: the file holds a crop */
	const char *text;  /* ts_replay: how the elements first differ from the right ones; "" if they do not */
} ts_verdict_info;

/* The verdict on buffer i, from 0. The order is that of the stages and of their buffers in the reference; a replay has
 * verdicts on the outputs of its stage. NULL behind the last. */
TS_API const ts_verdict_info *ts_verdicts_at(const ts_verdicts *verdicts, size_t i);

/* A difference. The first divergence is the first difference of the first stage that differs. */
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
	const char *line;                  /* all of it in one line, the last that `touchstone compare` prints */
	const char *spot;                  /* field and component: "normal[1]"; "" for a scalar */
	uint32_t bytes; /* of each value; 0: counts of a prefix sum; `element` is the sum behind the count */
} ts_divergence;

/* The first divergence; NULL: nothing differs. */
TS_API const ts_divergence *ts_verdicts_first(const ts_verdicts *verdicts);

/* Difference i of buffer b, which counts as in ts_verdicts_at: records without a partner first, then elements, each in
 * their order. The lines of all but the first leave out stage, buffer and inputs. NULL behind the last that
 * ts_compare_options.first asked for. */
TS_API const ts_divergence *ts_verdicts_difference(const ts_verdicts *verdicts, size_t b, size_t i);

/* How many elements differ in a field of a record. */
typedef struct {
	const char *field;
	uint64_t n_different;
} ts_field_count;

/* Field i of the fields of buffer b in which elements differ; NULL behind the last, and for buffers without fields. */
TS_API const ts_field_count *ts_verdicts_field(const ts_verdicts *verdicts, size_t b, size_t i);

/* All differences as an object: what `compare --json` prints without the verdicts on buffers and stages. Release it by
 * ts_tree_free; NULL without memory. */
TS_API ts_tree *ts_verdicts_tree(const ts_verdicts *verdicts);

/* Compares one buffer, which both traces have. Sets marks[e] to 1 if element e of the reference's n differs, otherwise
 * to 0.
 * In: options: as for ts_compare; `forced` and `stages` are not read.
 * Returns: TS_OK if no element differs; TS_DIFFERENT; TS_SKIPPED if the order of the points is not known because the
 *   candidate lacks their keys. */
TS_API ts_status ts_compare_marks(ts_context *context, uint8_t *marks, size_t n, const char *buffer,
                                  const ts_trace *reference, const ts_trace *candidate,
                                  const ts_compare_options *options);

/* Not 0 if two floats are equal, or close enough by the options' ulp, abs and rel. options NULL: equal only. A NaN
 * never passes. */
TS_API int ts_float_passes(const ts_compare_options *options, float reference, float candidate);

enum { TS_FLOAT_TEXT = 96 };
/* A float as text, as in a divergence: "1 = 0x1p+0 (3f800000)". */
TS_API void ts_float_text(char text[TS_FLOAT_TEXT], float value);

/* Releases verdicts; NULL is allowed. */
TS_API void ts_verdicts_free(ts_verdicts *verdicts);

#ifdef __cplusplus
}
#endif
#endif
