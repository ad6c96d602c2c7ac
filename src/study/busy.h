/* How busy other processes keep the machine during a measurement: the system's count of busy processor time, less that
 * of this process and of its ended children. */
#ifndef TS_STUDY_BUSY_H
#define TS_STUDY_BUSY_H
#include "model/core.h"

typedef struct {
	double seconds, all, own; /* of a monotonic clock; busy, of all processors; busy, of this process */
	bool known;               /* false where the system has no such count */
} ts_busy;

ts_busy ts_busy_now(void);
/* A lower bound of the average number of processors that other processes used between two readings (the system counts
 * in ticks); NAN where it is not known. */
double ts_busy_others(const ts_busy *before, const ts_busy *after);
/* A tenth of the processors: if other processes use more, no time is judged. */
double ts_busy_limit(void);

#endif
