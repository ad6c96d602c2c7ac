/* Which tables `bench` has. */
#include <stdlib.h>
#include "bench.h"
#include "bench_paper.h"
#include "truths.h"

enum { RUNS = 3 };

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

/* The parameters are as typed; each row says how many mirrors or pixels it has. */
void ts_bench_head(ts_report *report, const ts_job *job, bool sized)
{
	const ts_params *p = &job->params;
	char size[48] = "";
	if (sized)
		snprintf(size, sizeof size, "%u x %u pixels, ", (unsigned)TS_PARAM(p, width), (unsigned)TS_PARAM(p, height));
	ts_report_line(report, "%sframe %u, %u threads", size, (unsigned)TS_PARAM(p, frame), (unsigned)job->how.threads);
	ts_report_run(report, job);
}

ts_status ts_bench_truth(const ts_truth_kind **judge, const ts_job *job)
{
	u32 truths;
	char names[64];
	*judge = NULL;
	const char *typed = job->judged ? job->truth : "C";
	if (ts_truths_find(&truths, "reflections", typed) != TS_OK) return TS_ERROR;
	if ((truths & (truths - 1)) != 0) {
		ts_truths_list(names, sizeof names, "reflections", ", ");
		return ts_fail("bench: one truth is compared with, not several; write --truth=%s or none", names);
	}
	const ts_truth_kind *const *kind = ts_truths();
	while (truths != 0 && ts_truth_bit(*kind) != truths) kind++;
	*judge = truths != 0 ? *kind : NULL;
	return TS_OK;
}

#define BY_ITSELF "method truth"
#define FILES "output force"

const ts_bench_row ts_bench_rows[] = {
	{ "ivir-1", "iVIR: soft shadows; also of models in TS_SCENES", BY_ITSELF " objects", .paper = &ts_ivir_1 },
	{ "ivir-2", "iVIR: reflections", BY_ITSELF, .paper = &ts_ivir_2 },
	{ "ivir-3", "iVIR: omnidirectional shadows", BY_ITSELF, .paper = &ts_ivir_3 },
	{ "epr-1", "EPR: shading operations", BY_ITSELF, .paper = &ts_epr_1 },
	{ "epr-2", "EPR: times, points, and errors against truth C or --truth", "method", .paper = &ts_epr_2 },
	{ "epr-3", "EPR: omnidirectional shadows", BY_ITSELF, .paper = &ts_epr_3 },
	{ "epr-6", "EPR: speed against accuracy as density, sampling and faces vary", "method",
	  .run = ts_bench_sweep },
	{ "ssagh-1", "SSAGH: frames a second by size of the image; --objects takes sizes, WxH; also of models in TS_SCENES",
	  BY_ITSELF " size", .paper = &ts_ssagh_1 },
	{ "ssagh-segments", "SSAGH: labels of algorithm 1 beside connected components",
	  BY_ITSELF " objects runs", .run = ts_bench_segments },
	{ "ssagh-5", "SSAGH: the curves c and s; no scene", "", .takes = FILES " json", .run = ts_bench_curves },
	{ "ssagh-7", "SSAGH: errors of integrals with the cosine; no scene", "", .takes = FILES " json",
	  .run = ts_bench_cosines },
	{ "mega-10", "MegaViews and ManyLoDs as views become many; --objects are paths of light", BY_ITSELF,
	  .paper = &ts_mega_10 },
	{ "mega-10-bounces", "the same of four bounces", BY_ITSELF, .paper = &ts_mega_10_bounces },
	{ "mega-12", "MegaViews: as maps become large; --objects are texels a side", BY_ITSELF, .paper = &ts_mega_12 },
	{ "mega-13", "MegaViews: as octrees become deep; --objects are levels", BY_ITSELF, .paper = &ts_mega_13 },
	{ "mega-16", "MegaViews: what gathering culls; --objects are levels", BY_ITSELF, .paper = &ts_mega_16 },
	{ "mega-particles", "MegaViews: of particles at random in the air; --objects are how many", BY_ITSELF,
	  .paper = &ts_mega_particles },
	{ "nv40", "surface splatting: surfels a second and fragments a pixel; --objects takes sizes",
	  BY_ITSELF " size", .paper = &ts_nv40 },
	{ "backends", "each stage in C and on every OpenCL device, of one frame by one --method (epr); and builds",
	  "truth " FILES, .run = ts_bench_backends, .runs = 5 },
	{ "start", "the seconds from opening --backend to its first frames", "truth " FILES, .run = ts_bench_start },
	{ 0 }
};

ts_table ts_bench_list(void)
{
	static const ts_column columns[] = { { "name", "table", false }, { "doc", "what it measures", false }, { 0 } };
	ts_table table = ts_table_begin("benches", "", columns);
	for (const ts_bench_row *row = ts_bench_rows; row->name != NULL; row++) {
		ts_table_text(&table, row->name);
		ts_table_text(&table, row->doc);
	}
	return table;
}

ts_status ts_bench_run(const ts_bench_row *row, const ts_job *job)
{
	ts_job own = *job;
	if (own.runs == 0) own.runs = row->runs != 0 ? row->runs : RUNS;
	if (ts_selftest_require() != TS_OK) return TS_ERROR;
	ts_measure_keep_memory();
	return row->paper != NULL ? ts_paper_bench(&own, row->paper) : row->run(&own);
}
