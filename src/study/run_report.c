/* What every report of measurements opens with: by which program, and how it was run. */
#include <string.h>
#include "table.h"

static json_t *params_json(const ts_params *params)
{
	json_t *object = json_object();
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	for (size_t row = 0; row < n; row++) {
		char text[64];
		ts_params_format(params, row, text, sizeof text);
		bool is_number = strcmp(table[row].kind, "enum") != 0;
		json_t *value = is_number ? json_loads(text, JSON_DECODE_ANY, NULL) : json_string(text);
		json_object_set_new(object, table[row].name, value != NULL ? value : json_string(text));
	}
	return object;
}

void ts_report_run(ts_report *report, const ts_job *job)
{
	ts_report_value(report, "program", json_string(job->program));
	ts_report_value(report, "version", json_string(TS_VERSION));
	ts_report_value(report, "backend", json_string(job->backend->name));
	ts_report_value(report, "threads", json_integer(job->how.threads));
	ts_report_value(report, "params", params_json(&job->params));
}
