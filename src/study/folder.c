/* The folder of results: what it may replace, and what report.json records about it. */
#include "study/folder.h"
#include <stdlib.h>
#include "output/file.h"
#include "study/folder_ours.h"

static ts_status keep(const char *dir)
{
	return ts_fail("%s: not empty; name another folder with -o, or replace it with --force", dir);
}

ts_status ts_results_begin(const char *dir, bool force) { return ts_folder_begin(dir, force ? ts_ours_judge : keep); }

json_t *ts_results_list(void)
{
	json_t *list = json_array();
	int failed = list == NULL;
	const char *name;
	for (size_t i = 0; (name = ts_folder_name(i)) != NULL && !failed; i++) {
		failed = json_array_append_new(list, json_string(name));
	}
	if (!failed) return list;
	json_decref(list);
	ts_fail("the list of files: out of memory");
	return NULL;
}

static ts_status write_json(const char *name, const json_t *root)
{
	ts_file_text text;
	const char *path = ts_folder_file(name);
	if (path == NULL || ts_file_text_begin(&text, name) != TS_OK) return TS_ERROR;
	ts_report_write(root, text.out);
	return ts_file_text_write(&text, path);
}

/* The values of the report that are timed, or that are not; NULL: out of memory. */
static json_t *part(const ts_report *report, bool timed)
{
	const char *key;
	json_t *value, *part = json_object();
	int failed = part == NULL;
	json_object_foreach (report->root, key, value) {
		if (!failed && ts_report_is_timed(report, key) == timed) failed = json_object_set(part, key, value);
	}
	if (!failed) return part;
	json_decref(part);
	ts_fail("the report: out of memory");
	return NULL;
}

ts_status ts_results_report(ts_report *report)
{
	ts_status status = ts_report_check(report);
	json_t *times = status == TS_OK ? part(report, true) : NULL;
	status = times != NULL ? TS_OK : TS_ERROR;
	if (json_object_size(times) > 0) status = write_json("times.json", times);
	json_decref(times);
	json_t *files = status == TS_OK ? ts_results_list() : NULL;
	if (files == NULL) return TS_ERROR;
	ts_report_value(report, "files", files);
	json_t *rest = ts_report_check(report) == TS_OK ? part(report, false) : NULL;
	status = rest != NULL ? write_json("report.json", rest) : TS_ERROR;
	json_decref(rest);
	return status;
}
