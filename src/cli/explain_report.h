/* What `explain` prints, as text and as JSON. */
#ifndef TS_CLI_EXPLAIN_REPORT_H
#define TS_CLI_EXPLAIN_REPORT_H
#include "../explain/explain.h"
#include "../study/table.h"

typedef struct {
	const ts_stage *stage;
	const ts_question *question;
	const ts_trace *trace, *inputs, *other; /* inputs, other: NULL if there is none */
	const ts_explanation *a, *b;            /* of trace and of other, which may be NULL */
} ts_told_what;

/* TS_DIFFERENT if the two explanations differ. */
ts_status ts_explain_report(const ts_told_what *what, bool json);

#endif
