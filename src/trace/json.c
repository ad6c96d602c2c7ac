/* trace.json as a file. */
#include "output/file.h"
#include "trace/describe.h"

ts_status ts_trace_write_json(const char *path, json_t *root)
{
	ts_file_text text;
	ts_status status = ts_file_text_begin(&text, path);
	if (status == TS_OK) {
		bool whole = json_dumpf(root, text.out, JSON_INDENT(1) | JSON_REAL_PRECISION(9)) == 0;
		whole &= fputc('\n', text.out) != EOF;
		status = ts_file_text_write(&text, path);
		if (!whole) status = ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
	}
	json_decref(root);
	return status;
}
