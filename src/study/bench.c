/* The tables of `bench`. */
#include "study/bench.h"
#include <assert.h>
#include <stdlib.h>
#include "study/asked/truths.h"
#include "study/bench_paper.h"
#include "study/claims.h"
#include "study/frames.h"

enum { RUNS = 3, MOST = 64 };

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

/* Tables of no family. */
static const ts_bench_row general[] = {
	{"backends", "each stage in C and on every device, of one frame by one --method (epr); and builds",
     "truth " TS_BENCH_FILES, .run = ts_bench_backends, .runs = 5},
	{"speed", "stages beside Embree, bare points and the machine's limits; --scene names frames and growths",
     "truth frames", .run = ts_bench_speed, .quiet = true},
	{"start", "the seconds from opening --backend to its first frames", "truth " TS_BENCH_FILES, .run = ts_bench_start},
	{"list", "what the papers show, which table asks it, and the verdict", "", .takes = "json", .run = ts_bench_claims},
	{0},
};

static const ts_bench_row *table[MOST + 1];

static u32 append(u32 n, const ts_bench_row *row)
{
	for (; row->name != NULL; row++) {
		assert(n < MOST);
		table[n++] = row;
	}
	return n;
}

void ts_benches_use(const ts_bench_row *const *rows)
{
	u32 n = 0;
	for (; *rows != NULL; rows++) n = append(n, *rows);
	table[append(n, general)] = NULL;
}

const ts_bench_row *const *ts_benches(void) { return table; }

ts_table ts_bench_list(void)
{
	static const ts_column columns[] = {
		{"name", "table", false}, {"doc", "what it measures", false}, {"brief", "in brief", false}, {0}};
	ts_table list = ts_table_begin("benches", "", columns);
	for (const ts_bench_row *const *row = ts_benches(); *row != NULL; row++) {
		ts_table_text(&list, (*row)->name);
		ts_table_text(&list, (*row)->doc);
		if ((*row)->brief != NULL) {
			ts_table_text(&list, (*row)->brief);
		} else {
			ts_table_none(&list);
		}
	}
	return list;
}

ts_status ts_bench_run(const ts_bench_row *row, const ts_job *job)
{
	ts_job own = *job;
	if (own.runs == 0) own.runs = row->runs != 0 ? row->runs : RUNS;
	if (ts_selftest_require() != TS_OK) return TS_ERROR;
	ts_measure_keep_memory();
	return row->paper != NULL ? ts_paper_bench(&own, row->paper) : row->run(&own);
}
