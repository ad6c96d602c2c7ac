/* The head of every report of measurements: the program, and how it was run. */
#include <string.h>
#include "model/json/read.h"
#include "study/results/table.h"

/* A number as such, a word as a string; NULL without memory. */
static json_t *value_json(const char *text, bool is_number)
{
	json_t *value = is_number ? ts_json_read(text, strlen(text), false, "a number") : NULL;
	bool starved = is_number && value == NULL && ts_error_kind() == TS_KIND_MEMORY;
	return value != NULL || starved ? value : json_string(text);
}

/* NULL without memory. */
static json_t *params_json(const ts_params *params)
{
	json_t *object = json_object();
	size_t n;
	int failed = 0;
	const ts_param_info *table = ts_param_table(&n);
	for (size_t row = 0; row < n; row++) {
		char text[64];
		ts_params_format(params, row, text, sizeof text);
		bool is_number = strcmp(table[row].kind, "enum") != 0;
		failed |= json_object_set_new(object, table[row].name, value_json(text, is_number));
	}
	if (failed == 0) return object;
	json_decref(object);
	return NULL;
}

void ts_report_run(ts_report *report, const ts_job *job)
{
	ts_report_value(report, "program", json_string(job->program));
	ts_report_value(report, "version", json_string(TS_VERSION));
	ts_report_value(report, "backend", json_string(job->backend->name));
	ts_report_value(report, "threads", json_integer(job->how.threads));
	ts_report_value(report, "params", params_json(&job->params));
}
