/* Work of rays that may take long: see work.h. */
#include "truth/work.h"
#include "model/core.h"

static const double first = 0.5, lengthy = 10; /* seconds: measured before an estimate; least printed one */

ts_work ts_work_begin(const char *label, u64 rays)
{
	ts_progress(label, 0, 1);
	return (ts_work){.label = label, .rays = rays, .begin = ts_seconds()};
}

void ts_work_at(ts_work *work, u64 done, u64 all)
{
	double seconds = ts_seconds() - work->begin;
	ts_progress(work->label, done, all);
	if (work->reported || done == 0 || done >= all || seconds < first) return;
	work->reported = true;
	double total = seconds * (double)all / (double)done;
	if (total < lengthy) return;
	if (work->rays > 0) {
		ts_say("%s: %llu rays, about %.0f s", work->label, (unsigned long long)work->rays, total);
	} else {
		ts_say("%s: about %.0f s", work->label, total);
	}
}

void ts_work_end(const ts_work *work) { ts_progress(work->label, 1, 1); }
