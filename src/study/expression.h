/* Expressions over figures: `100 * (1 - epr.ms.frame / mvr.ms.frame)`. A quotient by 0 is missing, as
 * is what is computed from what is missing. growth(a, b) is e, where a grows as b^e since the row before. */
#ifndef TS_STUDY_EXPRESSION_H
#define TS_STUDY_EXPRESSION_H
#include "kernels/base/compat.h"
#include "model/core.h"

enum { TS_EXPRESSION_DEPTH = 16 };

typedef enum {
	TS_TERM_NUMBER,
	TS_TERM_MEASURED, /* measured figure `at` */
	TS_TERM_FIGURE,   /* figure `at` of the table */
	TS_TERM_ADD,      /* operators take the last two values */
	TS_TERM_SUBTRACT,
	TS_TERM_MULTIPLY,
	TS_TERM_DIVIDE,
	TS_TERM_GROWTH,
} ts_term_kind;

/* A step of an expression, operands first. */
typedef struct {
	ts_term_kind kind;
	u32 at;
	double number;
} ts_term;

/* What an expression is made of: finds a name, of which `n` characters stand at `text`, and writes the term for it.
 * Fails with a message without a place. */
typedef ts_status ts_expression_name(void *user, const char *text, size_t n, ts_term *term);

/* Reads an expression up to the end of `text` and writes its terms, of which there is room for *n; afterwards *n is
 * their number. On failure *at is where in `text`; the message does not name a place. */
ts_status ts_expression_read(ts_term *terms, u32 *n, const char *text, const char **at, ts_expression_name *name,
                             void *user);

/* Values by index: measured figures, those of the table, and those of the table in the row before, or NULL. */
typedef struct {
	const double *measured, *figures, *before;
} ts_expression_values;
double ts_expression_value(const ts_term *terms, u32 n, const ts_expression_values *values);

#endif
