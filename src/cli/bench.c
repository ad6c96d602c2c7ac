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
void ts_bench_head(ts_report *report, const ts_cli *cli, bool sized)
{
	const ts_params *p = &cli->params;
	char size[48] = "";
	if (sized) snprintf(size, sizeof size, "%u x %u pixels, ", (unsigned)p->width, (unsigned)p->height);
	ts_report_line(report, "%sframe %u, %u threads", size, (unsigned)p->frame, (unsigned)cli->how.threads);
	ts_report_run(report, cli);
}

ts_status ts_bench_truth(const ts_truth_kind **judge, const ts_cli *cli)
{
	u32 truths;
	char names[64];
	*judge = NULL;
	const char *typed = ts_cli_given(cli, TS_OPT_TRUTH) ? cli->truth : "C";
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

#define FILES (TS_OPT_OUTPUT | TS_OPT_FORCE)

static const struct {
	const char *name;
	u64 without;                  /* options that say nothing here */
	const ts_paper_table *paper;  /* NULL: `run` */
	ts_status (*run)(const ts_cli *cli);
} tables[] = {
	{ "ivir-1", TS_OPT_METHOD | TS_OPT_TRUTH | TS_OPT_OBJECTS, &ts_ivir_1, NULL },
	{ "ivir-2", TS_OPT_METHOD | TS_OPT_TRUTH, &ts_ivir_2, NULL },
	{ "ivir-3", TS_OPT_METHOD | TS_OPT_TRUTH, &ts_ivir_3, NULL },
	{ "epr-1", TS_OPT_METHOD | TS_OPT_TRUTH, &ts_epr_1, NULL },
	{ "epr-2", TS_OPT_METHOD, &ts_epr_2, NULL },
	{ "epr-3", TS_OPT_METHOD | TS_OPT_TRUTH, &ts_epr_3, NULL },
	{ "epr-6", TS_OPT_METHOD, NULL, ts_bench_sweep },
	{ "backends", TS_OPT_TRUTH | FILES, NULL, ts_bench_backends },
	{ "ssagh-1", TS_OPT_METHOD | TS_OPT_TRUTH | TS_OPT_SIZE, &ts_ssagh_1, NULL },
	{ "ssagh-segments", TS_OPT_METHOD | TS_OPT_OBJECTS | TS_OPT_RUNS | TS_OPT_TRUTH, NULL, ts_bench_segments },
	{ "ssagh-5", ~(FILES | TS_OPT_JSON), NULL, ts_bench_curves },
	{ "ssagh-7", ~(FILES | TS_OPT_JSON), NULL, ts_bench_cosines },
	{ "mega-10", TS_OPT_METHOD | TS_OPT_TRUTH, &ts_mega_10, NULL },
	{ "mega-10-bounces", TS_OPT_METHOD | TS_OPT_TRUTH, &ts_mega_10_bounces, NULL },
	{ "mega-12", TS_OPT_METHOD | TS_OPT_TRUTH, &ts_mega_12, NULL },
	{ "mega-13", TS_OPT_METHOD | TS_OPT_TRUTH, &ts_mega_13, NULL },
	{ "mega-16", TS_OPT_METHOD | TS_OPT_TRUTH, &ts_mega_16, NULL },
	{ "mega-particles", TS_OPT_METHOD | TS_OPT_TRUTH, &ts_mega_particles, NULL },
	{ "nv40", TS_OPT_METHOD | TS_OPT_TRUTH | TS_OPT_SIZE, &ts_nv40, NULL },
	{ "start", TS_OPT_TRUTH | FILES, NULL, ts_bench_start },
};
enum { N_TABLES = sizeof tables / sizeof tables[0] };

static ts_status unknown(const char *name)
{
	ts_nearest nearest = ts_nearest_begin(name);
	for (size_t i = 0; i < N_TABLES; i++) ts_nearest_offer(&nearest, tables[i].name);
	return ts_fail("bench: no table \"%s\"; the nearest is %s, and \"%s help bench\" lists all", name, nearest.best,
	               ts_program);
}

ts_status ts_bench_command(ts_cli *cli)
{
	size_t i = 0;
	const ts_option *o = ts_option_table;
	while (i < N_TABLES && strcmp(tables[i].name, cli->arguments[0]) != 0) i++;
	if (i == N_TABLES) return unknown(cli->arguments[0]);
	while (o->name != NULL && !ts_cli_given(cli, o->bit & tables[i].without)) o++;
	if (o->name != NULL) return ts_fail("bench %s: takes no --%s", tables[i].name, o->name);
	if (ts_selftest_require() != TS_OK) return TS_ERROR;
	ts_measure_keep_memory();
	return tables[i].paper != NULL ? ts_paper_bench(cli, tables[i].paper) : tables[i].run(cli);
}
