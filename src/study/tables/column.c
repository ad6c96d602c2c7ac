/* The columns of a table. */
#include <math.h>
#include "study/tables/paper.h"

void ts_bench_derive(double *values, const double *measured, const double *before, const ts_bench_figure *figures)
{
	const ts_expression_values all = {measured, values, before};
	for (u32 i = 0; figures[i].key != NULL; i++)
		if (isnan(values[i]) && (measured != NULL || !figures[i].measured))
			values[i] = ts_expression_value(figures[i].terms, figures[i].n_terms, &all);
}

void ts_bench_cell(ts_table *table, const ts_bench_figure *figure, double value)
{
	if (figure->decimals == TS_WHOLE && fabs(value) < 9e15) {
		ts_table_count(table, (i64)value);
	} else {
		ts_table_known(table, value, figure->decimals);
	}
}
