/* The tables of `bench backends`. */
#include <string.h>
#include "study/bench_backends.h"

/* The texts of a table with one column per backend, and optionally one per ratio. */
typedef struct {
	ts_column column[TS_MAX_COLUMNS];
	char key[TS_MAX_COLUMNS][32], head[TS_MAX_COLUMNS][48];
	u32 n;
} headings;

static const ts_column about_columns[] = {{"column", "column", false},
                                          {"device", "device", false},
                                          {"compiler", "compiler", false},
                                          {"flags", "flags", false},
                                          {0}};

static void add_heading(headings *h, const char *key, const char *head)
{
	snprintf(h->key[h->n], sizeof h->key[0], "%s", key);
	snprintf(h->head[h->n], sizeof h->head[0], "%s", head);
	h->column[h->n] = (ts_column){h->key[h->n], h->head[h->n], h->n > 0};
	h->n++;
}

static double median(const ts_bench_table *table, u32 column, u32 row)
{
	return ts_median(table->column[column].samples[row], table->n_runs);
}

static bool is_device(const ts_bench_table *table, u32 column) { return column > table->reference; }

void ts_bench_print_columns(const ts_bench_table *table)
{
	ts_c_backend c;
	ts_c_begin(&c, 1);
	ts_table t = ts_table_begin("columns", "Columns", about_columns);
	for (u32 i = 0; i < table->n_columns; i++) {
		const ts_bench_column *column = &table->column[i];
		const ts_backend *backend = is_device(table, i) ? column->how.backend : &c.backend;
		ts_table_text(&t, column->name);
		ts_table_text(&t, column->device);
		ts_table_text(&t, backend->compiler);
		ts_table_text(&t, backend->flags);
	}
	ts_report_table(table->report, &t);
}

static void time_headings(headings *h, const ts_bench_table *table)
{
	char key[32], head[48];
	const char *reference = table->column[table->reference].name;
	*h = (headings){.n = 0};
	add_heading(h, "stage", "time, ms");
	for (u32 i = 0; i < table->n_columns; i++) add_heading(h, table->column[i].name, table->column[i].name);
	for (u32 i = table->reference + 1; i < table->n_columns; i++) {
		snprintf(key, sizeof key, "%s_ratio", table->column[i].name);
		snprintf(head, sizeof head, "%s / %s", table->column[i].name, reference);
		add_heading(h, key, head);
	}
}

static void time_row(ts_table *t, const ts_bench_table *table, const char *name, u32 row)
{
	double reference = median(table, table->reference, row);
	ts_table_text(t, name);
	for (u32 i = 0; i < table->n_columns; i++) ts_table_real(t, 1e3 * median(table, i, row), 2);
	for (u32 i = table->reference + 1; i < table->n_columns; i++) {
		if (reference > 0) {
			ts_table_real(t, median(table, i, row) / reference, 2);
		} else {
			ts_table_none(t);
		}
	}
}

void ts_bench_print_times(const ts_bench_table *table)
{
	headings h;
	time_headings(&h, table);
	ts_table t = ts_table_begin("milliseconds", "Time", h.column);
	t.timed = true;
	const ts_measure *m = &table->column[0].last;
	for (u32 k = 0; k < m->n_timings; k++) time_row(&t, table, m->timings[k].stage, k);
	time_row(&t, table, "all", TS_BENCH_ALL);
	ts_report_table(table->report, &t);
}

/* A stage's counter divided by its time. */
static void counter_row(ts_table *t, const ts_bench_table *table, const char *name, const char *counter, u32 stage)
{
	ts_table_text(t, name);
	for (u32 i = 0; i < table->n_columns; i++) {
		const ts_counter *n = ts_measure_counter(&table->column[i].last, counter);
		ts_table_real(t, 1e-6 * (double)n->value / median(table, i, stage), 2);
	}
}

static void splat_rows(ts_table *t, const ts_bench_table *table)
{
	const ts_measure *m = &table->column[0].last;
	const ts_timing *splat = ts_measure_timing(m, "splat");
	if (splat == NULL) return;
	u32 stage = (u32)(splat - m->timings);
	counter_row(t, table, "splat: points", "points", stage);
	counter_row(t, table, "splat: point-view scatters", "point-view scatters", stage);
	counter_row(t, table, "splat: texel writes", "texel writes", stage);
}

void ts_bench_print_rates(const ts_bench_table *table)
{
	headings h = {.n = 0};
	add_heading(&h, "rate", "millions a second");
	for (u32 i = 0; i < table->n_columns; i++) add_heading(&h, table->column[i].name, table->column[i].name);
	ts_table t = ts_table_begin("millions_a_second", "Scattering", h.column);
	t.timed = true;
	splat_rows(&t, table);
	for (u32 limit = 0; limit < TS_BENCH_ATOMICS; limit++) {
		char name[64];
		snprintf(name, sizeof name, "64-bit atomic minimum, random texels of %u MiB",
		         (unsigned)ts_bench_limit_mib[limit]);
		ts_table_text(&t, name);
		for (u32 i = 0; i < table->n_columns; i++)
			ts_table_real(&t, 1e-6 * median(table, i, TS_BENCH_LIMIT + limit), 2);
	}
	ts_report_table(table->report, &t);
}
