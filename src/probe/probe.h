/* Why a pixel, a texel, a triangle or a point of a trace is what it is: who competed, who won by how much, and which
 * stage lost the others. The kernels compute again the values that no buffer holds; the probe compares the results with
 * the buffers. The families of methods answer, by rows; this header has the parts that all answers share. */
#ifndef TS_TRACE_PROBE_H
#define TS_TRACE_PROBE_H
#include <jansson.h>
#include "../trace/read.h"

typedef struct ts_probe ts_probe;

/* ---- questions ---- */
typedef enum {
	TS_PROBE_PIXEL,
	TS_PROBE_TEXEL,
	TS_PROBE_TRIANGLE,
	TS_PROBE_POINT,
	TS_N_PROBE_SUBJECTS,
} ts_probe_subject;

typedef struct {
	ts_probe_subject subject;
	u32 x, y;         /* of a pixel of the eye, or of a texel */
	const char *view; /* of a texel: what it belongs to, in a form of ts_probe_view */
	u64 index;        /* of a triangle or point; of a texel's view, read from `view` */
	u32 side;         /* of a texel's view, read from `view` */
	const i64 *key;   /* of a point: the three numbers of its key; NULL: its index counts */
} ts_probe_question;

/* How views are named whose texels can be asked for: a prefix, a number, a dot, and a side by its name or number. */
typedef struct {
	const char *form; /* in messages */
	const char *prefix;
	const char *(*side)(u32 number);
	u32 n_sides;
} ts_probe_view;

/* ---- rows ---- */
/* Who answers one kind of question about the traces of all methods that have a stage. */
typedef struct {
	ts_probe_subject subject;
	const char *stage;
	/* Puts the answer into an empty object, or fails: if there is no such thing, if the trace lacks buffers (all of
	 * which are named), or if one of them names what is not there. Floats that decide are objects of "value" and
	 * "bits"; each "check" says whether what was computed again has the bits of a buffer. */
	ts_status (*answer)(ts_probe *probe, const ts_probe_question *question, json_t *object);
	const char *tells;         /* what is told, for help */
	const ts_probe_view *view; /* of texels; else NULL */
} ts_probe_part;

/* The rows of each family, ended by one without answer; the families ended by NULL. The first row that fits a question
 * answers it. Both are kept. */
void ts_probe_use(const ts_probe_part *const *families);
/* Row i of all, from 0; NULL: there are no more. */
const ts_probe_part *ts_probe_part_at(u32 i);
/* "reflections by epr, mvr; ...": the methods whose traces a row answers for. */
enum { TS_PROBE_TEXT = 512 };
void ts_probe_methods(char text[TS_PROBE_TEXT], const ts_probe_part *part);
/* How a subject is asked for: "--pixel X,Y". */
const char *ts_probe_option(ts_probe_subject subject);

/* ---- answers ---- */
/* Begins with a trace, which must stay, of a method that a row answers for. On failure *probe is NULL; else release it
 * by ts_probe_close. */
ts_status ts_probe_open(ts_probe **probe, const ts_trace *trace);
/* NULL is allowed. */
void ts_probe_close(ts_probe *probe);
/* Sets *answer to a new object, of the row that fits, or fails. On failure *answer is NULL. */
ts_status ts_probe_ask(ts_probe *probe, const ts_probe_question *question, json_t **answer);

#endif
