/* How busy others keep the machine while something is timed: the system's count of busy processor time, less that of
 * this process and of its children that have ended. */
#ifndef TS_STUDY_BUSY_H
#define TS_STUDY_BUSY_H
#include "../model/core.h"

typedef struct {
	double seconds, all, own; /* of a monotonic clock; of all processors, and of this process */
	bool known;               /* false where the system has no such count */
} ts_busy;

ts_busy ts_busy_now(void);
/* Processors that others used between two readings, on average and at least, for the system counts in ticks; NAN where
 * that is not known. */
double ts_busy_others(const ts_busy *before, const ts_busy *after);
/* If others use more, no time is judged: a tenth of the processors. */
double ts_busy_limit(void);

#endif
