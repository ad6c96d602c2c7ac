/* What a table of `bench` leaves: its report on standard output and, with -o, in a folder, each table as CSV too. */
#include "bench.h"
#include "folder.h"

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

/* NULL with the message set on failure. */
static FILE *open_file(const char *name)
{
	const char *path = ts_folder_file(name);
	FILE *file = path != NULL ? fopen(path, "w") : NULL;
	if (file == NULL && path != NULL) ts_fail("%s: cannot be made; the disk may be full", name);
	return file;
}

static ts_status end_file(FILE *file, const char *name)
{
	bool failed = ferror(file) != 0;
	failed |= fclose(file) != 0;
	return failed ? ts_fail("%s: cannot be written; the disk may be full", name) : TS_OK;
}

static ts_status write_csv(const char *key, json_t *rows)
{
	char name[64];
	snprintf(name, sizeof name, "%s.csv", key);
	FILE *file = open_file(name);
	if (file == NULL) return TS_ERROR;
	put_rows(file, rows);
	return end_file(file, name);
}

ts_status ts_bench_plot(const char *name, const ts_plot *plot)
{
	FILE *file = open_file(name);
	if (file == NULL) return TS_ERROR;
	ts_plot_svg(plot, file);
	return end_file(file, name);
}

/* "program" and "files" are what a later --force goes by. */
static ts_status write_report(ts_report *report)
{
	json_t *files = ts_folder_list();
	FILE *file = files != NULL ? open_file("report.json") : NULL;
	if (file == NULL) {
		json_decref(files);
		return TS_ERROR;
	}
	ts_report_value(report, "files", files);
	ts_report_write(report, file);
	return end_file(file, "report.json");
}

static ts_status write_files(ts_report *report)
{
	const char *key;
	json_t *value;
	ts_status status = ts_report_check(report);
	json_object_foreach (report->root, key, value) {
		bool table = json_is_array(value) && json_is_object(json_array_get(value, 0));
		if (table && status == TS_OK) status = write_csv(key, value);
	}
	if (status == TS_OK) status = write_report(report);
	return status == TS_OK ? ts_folder_commit() : status;
}

ts_status ts_bench_with_report(const ts_job *job, ts_bench_work *work, const void *user)
{
	ts_report report;
	bool files = job->output.dir != NULL;
	ts_status status = files ? ts_folder_begin(job->output.dir, job->output.force) : TS_OK;
	if (status != TS_OK) return status;
	ts_report_begin(&report, job->output.json);
	status = work(job, &report, user);
	if (status == TS_OK && files) status = write_files(&report);
	if (status == TS_OK) return ts_report_end(&report);
	if (files) ts_folder_discard();
	ts_report_discard(&report);
	return status;
}
