/* Explains a pixel, texel, triangle or point of a trace: which candidates competed, which won by how much, and which
 * stage dropped the others. The kernels compute again the values that no buffer holds; the probe compares the results
 * with the buffers. The families of methods hand in rows with the functions that answer. */
#ifndef TS_PROBE_PROBE_H
#define TS_PROBE_PROBE_H
#include <jansson.h>
#include "trace/read.h"

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
	const char *view; /* of a texel: its view, in a form of ts_probe_view */
	u64 index;        /* of a triangle or point; of a texel's view, read from `view` */
	u32 side;         /* of a texel's view, read from `view` */
	const i64 *key;   /* of a point: the three numbers of its key; NULL: the point is named by `index` */
} ts_probe_question;

/* How views are named in questions about texels: a prefix, a number, a dot, and a side by its name or number. */
typedef struct {
	const char *form; /* in messages */
	const char *prefix;
	const char *(*side)(u32 number);
	u32 n_sides;
} ts_probe_view;

/* ---- rows ---- */
/* Answers one kind of question about the traces of all methods that have `stage`. */
typedef struct {
	ts_probe_subject subject;
	const char *stage;
	/* Puts the answer into an empty object. Fails if the thing asked for does not exist, if the trace lacks buffers
	 * (the message names all), or if an index in a buffer is out of range. Floats on which a decision depends are
	 * objects of "value" and "bits"; each "check" says whether a recomputed value has the bits of a buffer. */
	ts_status (*answer)(ts_probe *probe, const ts_probe_question *question, json_t *object);
	const char *reports;       /* what the answer tells, for help */
	const ts_probe_view *view; /* of texels; else NULL */
} ts_probe_part;

/* Takes the rows of all families: lists ended by NULL, each ended by a row without `answer`. They must stay. The first
 * row that fits a question answers it. */
void ts_probe_use(const ts_probe_part *const *families);
/* Row i of all families' rows, from 0; NULL: there are no more. */
const ts_probe_part *ts_probe_part_at(u32 i);
/* "reflections by epr, mvr; ...": the methods whose traces a row answers for. */
enum { TS_PROBE_TEXT = 512 };
void ts_probe_methods(char text[TS_PROBE_TEXT], const ts_probe_part *part);
/* The option that asks for a subject: "--pixel X,Y". */
const char *ts_probe_option(ts_probe_subject subject);

/* ---- answers ---- */
/* Opens a probe of a trace, which must outlive the probe, of a method that a row answers for. On failure *probe is
 * NULL; otherwise release it by ts_probe_close. */
ts_status ts_probe_open(ts_probe **probe, const ts_trace *trace);
/* NULL is allowed. */
void ts_probe_close(ts_probe *probe);
/* Sets *answer to a new object, filled by the row that fits. On failure *answer is NULL. */
ts_status ts_probe_ask(ts_probe *probe, const ts_probe_question *question, json_t **answer);

#endif
