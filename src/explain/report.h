/* Explanations as JSON: as lines of text for people, and as objects. */
#ifndef TS_EXPLAIN_REPORT_H
#define TS_EXPLAIN_REPORT_H
#include <jansson.h>
#include "explain/explain.h"

typedef struct {
	const ts_stage *stage;
	const ts_question *question;
	const ts_trace *trace, *inputs, *other; /* inputs, other: NULL if there is none */
	const ts_explanation *a, *b;            /* of trace and of other, which may be NULL */
} ts_told_what;

/* New references; NULL without memory. */
json_t *ts_explain_lines(const ts_told_what *what);
json_t *ts_explain_json(const ts_told_what *what);

#endif
