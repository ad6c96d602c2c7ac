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
	uint32_t first;     /* so many differences of each buffer are told; 0: one */
	const char *stages; /* "scene,split,...": only what these make is judged; NULL: all */
	int lent;           /* of ts_replay: not 0: outputs that the candidate lacks are judged as the reference has them */
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
 * In: candidate NULL: the reference is judged. options: as for ts_compare; `forced` and `stages` mean nothing here.
 * With `lent` it is no error where nobody has an output; all are "missing" then.
 * Out, Returns: as for ts_compare. */
TS_API ts_status ts_replay(ts_context *context, ts_verdicts **verdicts, const char *stage, const ts_trace *reference,
                           const ts_trace *candidate, const ts_compare_options *options);

/* Runs one stage on the same inputs, and hands out what the stage makes.
 * Out: *trace is to be released by ts_trace_close; NULL on failure. */
TS_API ts_status ts_trace_replay(ts_context *context, ts_trace **trace, const char *stage, const ts_trace *reference,
                                 const ts_trace *candidate);

/* How a buffer was judged. */
typedef enum {
	TS_NOT_JUDGED, /* the reference lacks it, or neither has it */
	TS_MISSING,    /* the candidate lacks it */
	TS_IGNORED,
	TS_UNABLE, /* what is right cannot be known: `why` */
	TS_SAME,
	TS_UNLIKE,
} ts_judgement;

/* The same of one buffer. */
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
	ts_judgement judgement;
	uint32_t number;        /* of the stage in names of files; 0: the scene */
	int by_counts;          /* not 0: prefix sums, of which counts are judged: a wrong one moves all sums behind it */
	uint64_t n_tied;        /* texels where another of the tied records won, as it may */
	int64_t worst_ulps;     /* largest distance of floats */
	double seconds;         /* that judging took */
	int has_first;          /* not 0: an element that both have differs, */
	uint64_t first_element; /* this one first */
	const char *first;      /* of what differs: its first difference and how many there are, */
	const char *line;       /* the same with stage, buffer and the state of the inputs, */
	const char *note;       /* and what else there is to say of it; else, and where there is nothing, "" */
	const char *file;       /* of ts_replay: the file whose elements were judged, or the buffer's name; */
	int cropped;            /* not 0: of a crop; */
	const char *told;       /* and how they first differ from what is right */
} ts_verdict_info;

/* Buffer i, from 0, of the reference's buffers in the order of the stages; after a replay, of the stage's outputs. NULL
 * behind the last. */
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
	const char *line;                  /* all of it in one line, as `touchstone compare` ends */
	const char *spot;                  /* field and component: "normal[1]"; "" of a scalar */
	uint32_t bytes; /* of each value; 0: counts, which no field holds: element is that of the sum behind */
} ts_divergence;

/* NULL: nothing differs. */
TS_API const ts_divergence *ts_verdicts_first(const ts_verdicts *verdicts);

/* Difference i of buffer b, a place of ts_verdicts_at: records without a partner, then elements, each in their order.
 * Its line is behind the first without stage, buffer and inputs. NULL behind the last that was asked for. */
TS_API const ts_divergence *ts_verdicts_difference(const ts_verdicts *verdicts, size_t b, size_t i);

/* How many elements differ in a field of a record. */
typedef struct {
	const char *field;
	uint64_t n_different;
} ts_field_count;

/* Field i of those of buffer b in which elements differ; NULL behind the last, and of what has no fields. */
TS_API const ts_field_count *ts_verdicts_field(const ts_verdicts *verdicts, size_t b, size_t i);

/* All that differs, as an object: as `compare --json` has it, but without the verdicts of buffers and stages. Release
 * by ts_tree_free; NULL without memory. */
TS_API ts_tree *ts_verdicts_tree(const ts_verdicts *verdicts);

/* Compares one buffer, which both have, and sets marks[e] to 1 for each element e of the reference's n that differs,
 * and to 0 for all others.
 * In: options: as for ts_compare; `forced` and `stages` mean nothing here.
 * Returns: TS_OK if none differs, TS_DIFFERENT; TS_SKIPPED if the buffer is of points in an order that is not known,
 * because the candidate lacks their keys. */
TS_API ts_status ts_compare_marks(ts_context *context, uint8_t *marks, size_t n, const char *buffer,
                                  const ts_trace *reference, const ts_trace *candidate,
                                  const ts_compare_options *options);

/* Not 0 if two floats are the same or pass for equal by ulp, abs and rel of the options; options NULL: the same value.
 * A NaN never does. */
TS_API int ts_float_passes(const ts_compare_options *options, float reference, float candidate);

enum { TS_FLOAT_TEXT = 96 };
/* A float as divergences tell it: "1 = 0x1p+0 (3f800000)". */
TS_API void ts_float_tell(char text[TS_FLOAT_TEXT], float value);

/* Releases verdicts; NULL is allowed. */
TS_API void ts_verdicts_free(ts_verdicts *verdicts);

#ifdef __cplusplus
}
#endif
#endif
