/* Progress of work by rays that may take long, and once an estimate of its duration, by the time of the first rays. The
 * clock has no effect on results. */
#ifndef TS_TRUTH_WORK_H
#define TS_TRUTH_WORK_H
#include "kernels/base/compat.h"

typedef struct {
	const char *label;
	u64 rays; /* of the whole work; 0: it casts none */
	double begin;
	bool reported;
} ts_work;

ts_work ts_work_begin(const char *label, u64 rays);
/* Notes that `done` of `all` is done. Prints on standard error an estimated duration of at least 10 s. */
void ts_work_at(ts_work *work, u64 done, u64 all);
void ts_work_end(const ts_work *work);

#endif
