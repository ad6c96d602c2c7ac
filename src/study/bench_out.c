/* The output of a table of `bench`: its report on standard output and, with -o, in a folder, each table also as CSV. */
#include <stdlib.h>
#include "output/file.h"
#include "study/bench.h"
#include "study/results/folder.h"

static void put_cell(FILE *out, const json_t *value)
{
	if (json_is_integer(value)) {
		fprintf(out, "%lld", (long long)json_integer_value(value));
	} else if (json_is_real(value)) {
		fprintf(out, "%.9g", json_real_value(value));
	} else if (json_is_string(value)) {
		fputc('"', out);
		for (const char *c = json_string_value(value); *c != 0; c++) fputs(*c == '"' ? "\"\"" : (char[]){*c, 0}, out);
		fputc('"', out);
	}
}

/* A line of the row's keys, or of its values. */
static void put_line(FILE *out, json_t *row, bool keys)
{
	const char *key;
	json_t *value;
	bool first = true;
	json_object_foreach (row, key, value) {
		if (!first) fputc(',', out);
		first = false;
		if (keys) {
			fputs(key, out);
		} else {
			put_cell(out, value);
		}
	}
	fputc('\n', out);
}

static void put_rows(FILE *out, json_t *rows)
{
	json_t *row;
	size_t i;
	put_line(out, json_array_get(rows, 0), true);
	json_array_foreach (rows, i, row) put_line(out, row, false);
}

static ts_status write_text(ts_file_text *text, const char *name)
{
	const char *path = ts_folder_file(name);
	if (path != NULL) return ts_file_text_write(text, path);
	ts_file_text_drop(text);
	return TS_ERROR;
}

static ts_status write_csv(const char *key, bool timed, json_t *rows)
{
	char name[64];
	snprintf(name, sizeof name, "%s%s.csv", timed ? "times-" : "", key);
	ts_file_text text;
	if (ts_file_text_begin(&text, name) != TS_OK) return TS_ERROR;
	put_rows(text.out, rows);
	return write_text(&text, name);
}

ts_status ts_bench_plot(const char *name, const ts_plot *plot)
{
	ts_file_text text;
	if (ts_file_text_begin(&text, name) != TS_OK) return TS_ERROR;
	ts_plot_svg(plot, text.out);
	return write_text(&text, name);
}

static ts_status write_files(ts_report *report)
{
	const char *key;
	json_t *value;
	ts_status status = ts_report_check(report);
	json_object_foreach (report->root, key, value) {
		bool table = json_is_array(value) && json_is_object(json_array_get(value, 0));
		if (table && status == TS_OK) status = write_csv(key, ts_report_is_timed(report, key), value);
	}
	if (status == TS_OK) status = ts_results_report(report);
	return status == TS_OK ? ts_folder_commit() : status;
}

ts_status ts_bench_with_report(const ts_job *job, ts_bench_work *work, const void *user)
{
	ts_report report;
	bool files = job->output.dir != NULL;
	ts_status status = files ? ts_results_begin(job->output.dir, job->output.force) : TS_OK;
	if (status != TS_OK) return status;
	ts_report_begin(&report, job->output.json);
	status = work(job, &report, user);
	if (status == TS_OK && files) status = write_files(&report);
	if (status == TS_OK && job->output.tree != NULL) {
		status = ts_report_check(&report);
		if (status == TS_OK) *job->output.tree = json_incref(report.root);
		ts_report_discard(&report);
		return status;
	}
	if (status == TS_OK) return ts_report_end(&report);
	if (files) ts_folder_discard();
	ts_report_discard(&report);
	return status;
}
