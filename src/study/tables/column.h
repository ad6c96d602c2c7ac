/* The columns of a table: expressions over what is measured of the variants of a case, and over columns before. */
#ifndef TS_STUDY_TABLES_COLUMN_H
#define TS_STUDY_TABLES_COLUMN_H
#include "study/figure.h"
#include "study/results/table.h"
#include "study/tables/expression.h"

enum { TS_BENCH_FIGURES = 96, TS_BENCH_MEASURED = 256 }; /* at most */

typedef struct {
	const char *key, *head; /* of the column */
	int decimals;           /* TS_WHOLE: a count */
	const ts_term *terms;   /* of the expression */
	u32 n_terms;
	bool timed;    /* two runs differ */
	bool measured; /* the expression itself names what is measured */
} ts_bench_figure;
enum { TS_WHOLE = -1 };

/* Computes the figures that are missing, one after the other; `figures` is ended by one without a key. `measured` has
 * all values that expressions name; `before` is the scene's row before, or NULL. */
void ts_bench_derive(double *values, const double *measured, const double *before, const ts_bench_figure *figures);
/* Appends the value of a figure as a cell. */
void ts_bench_cell(ts_table *table, const ts_bench_figure *figure, double value);

#endif
