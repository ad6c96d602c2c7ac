/* `bench TABLE`: which tables there are. */
#include <stdlib.h>
#include "bench.h"
#include "bench_paper.h"
#include "truths.h"

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
	if (sized) snprintf(size, sizeof size, "%u x %u pixels, ", (unsigned)p->width, (unsigned)p->height);
	ts_report_line(report, "%sframe %u, %u threads", size, (unsigned)p->frame, (unsigned)job->how.threads);
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
	const ts_truth_kind *kind = ts_truth_table;
	while (truths != 0 && ts_truth_bit(kind) != truths) kind++;
	*judge = truths != 0 ? kind : NULL;
	return TS_OK;
}

#define FILES (TS_OPT(OUTPUT) | TS_OPT(FORCE))

#define BY_ITSELF (TS_OPT(METHOD) | TS_OPT(TRUTH))

/* A paper's table, or what `run` measures. */
static const struct {
	const char *name, *doc;
	u64 without;                  /* options that say nothing here */
	const ts_paper_table *paper;
	ts_status (*run)(const ts_job *job);
	u32 runs;                     /* unless --runs says how many; 0: RUNS */
} tables[] = {
	{ "ivir-1", "iVIR: soft shadows; also of models in TS_SCENES", BY_ITSELF | TS_OPT(OBJECTS), .paper = &ts_ivir_1 },
	{ "ivir-2", "iVIR: reflections", BY_ITSELF, .paper = &ts_ivir_2 },
	{ "ivir-3", "iVIR: omnidirectional shadows", BY_ITSELF, .paper = &ts_ivir_3 },
	{ "epr-1", "EPR: shading operations", BY_ITSELF, .paper = &ts_epr_1 },
	{ "epr-2", "EPR: times, points, and errors against truth C or --truth", TS_OPT(METHOD), .paper = &ts_epr_2 },
	{ "epr-3", "EPR: omnidirectional shadows", BY_ITSELF, .paper = &ts_epr_3 },
	{ "epr-6", "EPR: speed against accuracy as density, sampling and faces vary", TS_OPT(METHOD),
	  .run = ts_bench_sweep },
	{ "ssagh-1", "SSAGH: frames a second by size of the image; --objects takes sizes, WxH; also of models in TS_SCENES",
	  BY_ITSELF | TS_OPT(SIZE), .paper = &ts_ssagh_1 },
	{ "ssagh-segments", "SSAGH: labels of algorithm 1 beside connected components",
	  BY_ITSELF | TS_OPT(OBJECTS) | TS_OPT(RUNS), .run = ts_bench_segments },
	{ "ssagh-5", "SSAGH: the curves c and s; no scene", ~(FILES | TS_OPT(JSON)), .run = ts_bench_curves },
	{ "ssagh-7", "SSAGH: errors of integrals with the cosine; no scene", ~(FILES | TS_OPT(JSON)),
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
	  BY_ITSELF | TS_OPT(SIZE), .paper = &ts_nv40 },
	{ "backends", "each stage in C and on every OpenCL device, of one frame by one --method (epr); and builds",
	  TS_OPT(TRUTH) | FILES, .run = ts_bench_backends, .runs = 5 },
	{ "start", "the seconds from opening --backend to its first frames", TS_OPT(TRUTH) | FILES, .run = ts_bench_start },
};
enum { RUNS = 3, N_TABLES = sizeof tables / sizeof tables[0] };

ts_table ts_bench_list(void)
{
	static const ts_column columns[] = { { "name", "table", false }, { "doc", "what it measures", false }, { 0 } };
	ts_table table = ts_table_begin("benches", "", columns);
	for (size_t i = 0; i < N_TABLES; i++) {
		ts_table_text(&table, tables[i].name);
		ts_table_text(&table, tables[i].doc);
	}
	return table;
}

static ts_status unknown(const char *name)
{
	ts_nearest nearest = ts_nearest_begin(name);
	for (size_t i = 0; i < N_TABLES; i++) ts_nearest_offer(&nearest, tables[i].name);
	return ts_fail("bench: no table \"%s\"; the nearest is %s, and \"%s list benches\" lists all", name, nearest.best,
	               ts_program);
}

ts_status ts_bench_command(ts_cli *cli)
{
	size_t i = 0;
	while (i < N_TABLES && strcmp(tables[i].name, cli->arguments[0]) != 0) i++;
	if (i == N_TABLES) return unknown(cli->arguments[0]);
	for (u32 k = 0; k < TS_N_OPTIONS; k++) {
		bool refused = (cli->given & tables[i].without) >> k & 1;
		if (refused) return ts_fail("bench %s: takes no --%s", tables[i].name, ts_option_table[k].name);
	}
	if (cli->job.runs == 0) cli->job.runs = tables[i].runs != 0 ? tables[i].runs : RUNS;
	if (ts_selftest_require() != TS_OK) return TS_ERROR;
	ts_measure_keep_memory();
	return tables[i].paper != NULL ? ts_paper_bench(&cli->job, tables[i].paper) : tables[i].run(&cli->job);
}
