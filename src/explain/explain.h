/* Explanations: a stage is replayed on one thread, and one item of a kernel records what it computes, line by line. */
#ifndef TS_EXPLAIN_EXPLAIN_H
#define TS_EXPLAIN_EXPLAIN_H
#include <jansson.h>
#include "explain/told.h"
#include "replay/replay.h"
#include "trace/field.h"

/* A launch of the stage. */
typedef struct {
	ts_kernel kernel;
	u64 n;    /* items */
	u64 item; /* the item that is explained; n: none */
	size_t first_line, n_lines;
} ts_explained_launch;

typedef enum {
	TS_EXPLAIN_LAUNCHES, /* no item */
	TS_EXPLAIN_ITEM,     /* that item of each launch */
	TS_EXPLAIN_ELEMENT,  /* the item that gave an element of a buffer its value */
} ts_explain_subject;

typedef struct {
	ts_explain_subject subject;
	ts_kernel kernel; /* for ITEM: only launches of this kernel; TS_N_KERNELS: of any */
	u64 item;
	ts_buffer_id buffer; /* for ELEMENT: a buffer that the stage writes */
	u64 element;
	bool primitives; /* as in ts_telling */
	u64 most;        /* lines that are kept; ts_telling.n_more counts the others */
} ts_question;

typedef struct {
	ts_load *load; /* what the stage made; places in buffers are addresses of its frame */
	ts_telling telling;
	ts_explained_launch *launch; /* in their order */
	size_t n_launches, capacity;
} ts_explanation;

/* Replays the stage and answers; `candidate` may be NULL. Fails if no launch has the item, or none wrote
 * the element. Release by ts_explain_end, also after a failure; both traces must outlive the explanation. */
ts_status ts_explain(ts_explanation *explanation, const ts_stage *stage, const ts_question *question,
                     const ts_trace *reference, const ts_trace *candidate);
void ts_explain_end(ts_explanation *explanation);

/* One number of a line's value: "1.5 (3fc00000)"; for a pointer the element that it points to: "points.piece:3". */
void ts_explain_number(char text[TS_VALUE_TEXT], const ts_explanation *explanation, const ts_told_line *line,
                       const ts_told_leaf *leaf);
/* Whether a line has a value of its own. Calls and tests have none; the value of a counter is that of all items
 * before. */
bool ts_explain_has_value(const ts_explanation *explanation, const ts_told_line *line);
/* The element that a line stores to, in the same form; "" if it stores to none. */
void ts_explain_place(char text[TS_VALUE_TEXT], const ts_explanation *explanation, const ts_told_line *line);

enum { TS_TOLD_TEXT = 8192 };
/* Line `number` without its place in the text: "half = 1.5 (3fc00000)". A long value that an earlier line has is "as in
 * line 12", counted from 1. With `other`, whose line of that number is at the same place, only the differences. */
void ts_explain_text(char text[TS_TOLD_TEXT], const ts_explanation *explanation, size_t number,
                     const ts_explanation *other);
/* The same with every value as a whole; the line of `other` at the same place is number `beside`. */
void ts_explain_full_text(char text[TS_TOLD_TEXT], const ts_explanation *explanation, size_t number,
                          const ts_explanation *other, size_t beside);
/* Whether both have a line of that number, at the same place; ts_explain_is_same: and with the same content. */
bool ts_explain_is_beside(const ts_explanation *a, const ts_explanation *b, size_t number);
bool ts_explain_is_same(const ts_explanation *a, const ts_explanation *b, size_t number);
/* Whether two have different lines, and the number of the first. */
bool ts_explain_differ(size_t *number, const ts_explanation *a, const ts_explanation *b);
/* The title of the first paragraph that leaves another value, decides otherwise or goes another way; NULL: none. */
const ts_told_site *ts_explain_parting(const ts_explanation *a, const ts_explanation *b);

/* Explanations as JSON: as lines of text for people, and as objects (report.c). */
typedef struct {
	const ts_stage *stage;
	const ts_question *question;
	const ts_trace *trace, *inputs, *other; /* inputs, other: NULL if there is none */
	const ts_explanation *a, *b;            /* of trace and of other, which may be NULL */
	bool outline;                           /* of the lines only those of an outline */
} ts_told_what;

/* New references; NULL without memory. */
json_t *ts_explain_lines(const ts_told_what *what);
json_t *ts_explain_json(const ts_told_what *what);

#endif
