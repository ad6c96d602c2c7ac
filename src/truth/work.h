/* Work of rays that may take long: its progress, and, said once, how long it will take by what the first rays took. The
 * clock changes nothing that is computed. */
#ifndef TS_TRUTH_WORK_H
#define TS_TRUTH_WORK_H
#include "../kernels/base/compat.h"

typedef struct {
	const char *label;
	u64 rays; /* of all of it; 0: it has none */
	double begin;
	bool said;
} ts_work;

ts_work ts_work_begin(const char *label, u64 rays);
/* `done` of `all` is done. Says on standard error how long all of it takes, if that is at least 10 s. */
void ts_work_at(ts_work *work, u64 done, u64 all);
void ts_work_end(const ts_work *work);

#endif
