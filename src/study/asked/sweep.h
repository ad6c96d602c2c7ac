/* Parameters of which several values were typed, --set NAME=A,B,C: every combination is a render, and a line of CSV. */
#ifndef TS_STUDY_ASKED_SWEEP_H
#define TS_STUDY_ASKED_SWEEP_H
#include "study/asked/job.h"

/* Adds the values of one parameter, separated by commas; each is checked. `text` must stay. */
ts_status ts_sweep_add(ts_sweep *sweep, const ts_params *params, const char *name, const char *values);
/* How many combinations there are. */
u32 ts_sweep_count(const ts_sweep *sweep);
/* Sets the parameters of combination i; the value of parameter k is also copied to values[k]. */
ts_status ts_sweep_set(const ts_sweep *sweep, u32 i, ts_params *params, char values[TS_MAX_SWEEPS][TS_SWEEP_TEXT]);

#endif
