/* `bench backends`: each stage in C and on every device, on the same frame, beside limits of scattering. The columns
 * take turns within a run, so that other load on the machine affects all equally; the first turn is not counted. */
#include "study/bench_backends.h"
#include <stdlib.h>
#include "kernels/base/bench.h"

enum { OFFERS = 1 << 23 }; /* per launch, at least */

static const ts_launch bench_min = TS_LAUNCH(bench_min, TS_ALL);

static ts_status fill(ts_backend *backend, ts_frame *frame, u64 n)
{
	if (ts_frame_make1(frame, TS_B_cube_face_depth_triangle, n) == NULL) return TS_ERROR;
	ts_status status = backend->fill(backend, frame, TS_B_cube_face_depth_triangle, 0xff);
	return status == TS_OK ? backend->finish(backend) : status;
}

/* Launches follow each other without a wait, so that a device is never idle between them. */
static ts_status offer(ts_backend *backend, ts_frame *frame, u32 n, u32 launches)
{
	ts_bench_min_args args = {.texels = ts_frame_handle(frame, TS_B_cube_face_depth_triangle), .n_texels = n};
	ts_status status = TS_OK;
	for (args.distance = launches; status == TS_OK && args.distance-- > 0;) {
		status = backend->launch(backend, frame, &bench_min, &args, n);
	}
	return status == TS_OK ? backend->finish(backend) : status;
}

/* 64-bit atomic minima a second at random texels of a buffer of that size, of which four in five lower their texel. */
static ts_status offer_atomics(double *a_second, const ts_how *how, u64 bytes)
{
	u32 n = (u32)(bytes / sizeof(u64)), launches = n < OFFERS ? OFFERS / n : 1;
	ts_c_backend c;
	ts_frame frame = {.bytes = 0};
	ts_c_begin(&c, how->threads);
	ts_backend *backend = how->backend != NULL ? how->backend : &c.backend;
	ts_status status = fill(backend, &frame, n);
	double begin = ts_seconds();
	if (status == TS_OK) status = offer(backend, &frame, n, launches);
	*a_second = (double)n * launches / (ts_seconds() - begin);
	ts_frame_clear(&frame);
	return status;
}

const u32 ts_bench_limit_mib[TS_BENCH_ATOMICS] = {1, 16, 128};

static ts_status begin(ts_bench_table *table)
{
	u32 n_rows = TS_BENCH_COLUMNS * TS_BENCH_ROWS;
	table->n_runs = table->job->runs;
	table->notes = json_array();
	table->samples = ts_alloc_zero(n_rows, table->n_runs * sizeof *table->samples, "the times");
	ts_status status = table->samples != NULL ? ts_bench_columns_open(table) : TS_ERROR;
	for (u32 i = 0; i < n_rows && status == TS_OK; i++) {
		table->column[i / TS_BENCH_ROWS].samples[i % TS_BENCH_ROWS] = table->samples + (size_t)i * table->n_runs;
	}
	return status;
}

static void end(ts_bench_table *table)
{
	ts_bench_columns_close(table);
	ts_bench_frame_close(&table->frame);
	json_decref(table->notes);
	free(table->samples);
}

static ts_status run_frame(const ts_bench_table *table, ts_bench_column *c, u32 run)
{
	ts_status status = ts_bench_frame_run(&table->frame, &c->how, &c->last);
	for (u32 k = 0; k < c->last.n_timings; k++) c->samples[k][run] = c->last.timings[k].seconds;
	c->samples[TS_BENCH_ALL][run] = c->last.seconds;
	return status;
}

static ts_status run_limit(const ts_bench_table *table, ts_bench_column *c, u32 run, u32 limit)
{
	ts_progress("atomic limit", (u64)(c - table->column) + 1, table->n_columns);
	return offer_atomics(&c->samples[TS_BENCH_LIMIT + limit][run], &c->how, (u64)ts_bench_limit_mib[limit] << 20);
}

static ts_status run_limits(ts_bench_table *table, u32 run)
{
	ts_status status = TS_OK;
	for (u32 i = 0; status == TS_OK && i < TS_BENCH_ATOMICS * table->n_columns; i++) {
		status = run_limit(table, &table->column[i % table->n_columns], run, i / table->n_columns);
	}
	return status;
}

static ts_status take_turns(ts_bench_table *table, u32 run)
{
	ts_status status = TS_OK;
	for (u32 i = 0; status == TS_OK && i < table->n_columns; i++) status = run_frame(table, &table->column[i], run);
	return status == TS_OK ? run_limits(table, run) : status;
}

/* Not counted. A device that cannot run the frame is left out. */
static ts_status take_first_turns(ts_bench_table *table)
{
	for (u32 i = 0; i < table->n_columns;) {
		ts_status status = run_frame(table, &table->column[i], 0);
		if (status == TS_OK) {
			i++;
		} else if (!ts_bench_column_leave_out(table, i)) {
			return status;
		}
	}
	return run_limits(table, 0);
}

static ts_status measure(ts_bench_table *table)
{
	ts_status status = take_first_turns(table);
	for (u32 run = 0; status == TS_OK && run < table->n_runs; run++) status = take_turns(table, run);
	return status;
}

static void print_notes(ts_bench_table *table)
{
	size_t i;
	json_t *note;
	if (json_array_size(table->notes) > 0) ts_report_line(table->report, "%s", "");
	json_array_foreach (table->notes, i, note) ts_report_line(table->report, "%s", json_string_value(note));
	ts_report_value(table->report, "notes", json_incref(table->notes));
}

static ts_status print(ts_bench_table *table)
{
	ts_report *report = table->report;
	ts_bench_head(report, table->job, true);
	ts_bench_frame_report(&table->frame, report);
	ts_report_line(report, "median of %u, the columns by turns", (unsigned)table->n_runs);
	ts_report_value(report, "runs", json_integer(table->n_runs));
	ts_bench_print_columns(table);
	ts_bench_print_times(table);
	ts_bench_print_rates(table);
	ts_status status = ts_bench_print_builds(table);
	print_notes(table);
	return status;
}

ts_status ts_bench_backends(const ts_job *job)
{
	ts_report report;
	ts_bench_table *table = ts_alloc_zero(1, sizeof *table, "a table");
	if (table == NULL) return TS_ERROR;
	*table = (ts_bench_table){.job = job, .report = &report};
	ts_report_begin(&report, job->output.json);
	ts_status status = ts_bench_frame_open(&table->frame, job);
	if (status == TS_OK) status = begin(table);
	if (status == TS_OK) status = measure(table);
	if (status == TS_OK) status = print(table);
	end(table);
	free(table);
	if (status == TS_OK) return ts_report_end(&report);
	ts_report_discard(&report);
	return status;
}
