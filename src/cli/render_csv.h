/* Renders as lines of CSV. */
#ifndef TS_CLI_RENDER_CSV_H
#define TS_CLI_RENDER_CSV_H
#include "render.h"

typedef struct {
	const ts_sweep *sweep;
	char values[TS_MAX_SWEEPS][TS_SWEEP_TEXT]; /* of this combination */
	bool headed;                               /* the names of the columns were printed */
} ts_csv;

/* Prints a line a method: the swept parameters, milliseconds, reflective pixels, counters, and the RMSE of image and
 * reflective pixels against each truth that was asked for; before the first line the names of the columns. */
void ts_render_csv(const ts_render *render, ts_csv *csv);

#endif
