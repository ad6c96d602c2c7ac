/* The tables of `bench`. */
#include "study/bench.h"
#include <stdlib.h>
#include "study/asked/truths.h"
#include "study/frames.h"

static int by_value(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

double ts_median(double *values, u32 n)
{
	qsort(values, n, sizeof *values, by_value);
	return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

ts_status ts_bench_check(const ts_job *job, const char *table)
{
	u32 rays = TS_PARAM(&job->params, truth_rays);
	return rays == 0
	           ? TS_OK
	           : ts_fail("bench %s: truth.rays=%u: tables judge by whole truths; leave it out", table, (unsigned)rays);
}

/* The parameters are as typed; each row has its own number of mirrors or pixels. */
void ts_bench_head(ts_report *report, const ts_job *job, bool sized)
{
	const ts_params *p = &job->params;
	const ts_frames *f = &job->frames;
	char size[48] = "", frames[96];
	if (sized)
		snprintf(size, sizeof size, "%u x %u pixels, ", (unsigned)TS_PARAM(p, width), (unsigned)TS_PARAM(p, height));
	snprintf(frames, sizeof frames, "frame %u", (unsigned)TS_PARAM(p, frame));
	if (f->step > 0) {
		snprintf(frames, sizeof frames, "means over %u frames from %u to %u", (unsigned)ts_frames_count(f),
		         (unsigned)f->first, (unsigned)f->last);
		ts_report_value(report, "frames", json_pack("[iii]", (int)f->first, (int)f->last, (int)f->step));
	}
	ts_report_line(report, "%s%s, %u threads", size, frames, (unsigned)job->how.threads);
	ts_report_run(report, job);
}

ts_status ts_bench_truth(const ts_truth_kind **judge, const ts_job *job, const char *effect, const char *unless)
{
	u32 truths;
	char names[64];
	*judge = NULL;
	const char *typed = job->judged ? job->truth : unless;
	if (ts_truths_find(&truths, effect, typed) != TS_OK) return TS_ERROR;
	if ((truths & (truths - 1)) != 0) {
		ts_truths_list(names, sizeof names, effect, ", ");
		return ts_fail("bench: one truth is compared with, not several; write --truth=%s or none", names);
	}
	const ts_truth_kind *const *kind = ts_truths();
	while (truths != 0 && ts_truth_bit(*kind) != truths) kind++;
	*judge = truths != 0 ? *kind : NULL;
	return TS_OK;
}
