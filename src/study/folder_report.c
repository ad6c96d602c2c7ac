/* report.json of the output folder. */
#include <stdlib.h>
#include "../output/file.h"
#include "folder.h"

ts_status ts_folder_report(ts_report *report)
{
	static const char name[] = "report.json";
	ts_file_text text;
	json_t *files = ts_folder_list();
	if (files == NULL) return TS_ERROR;
	ts_report_value(report, "files", files);
	if (ts_report_check(report) != TS_OK || ts_file_text_begin(&text, name) != TS_OK) return TS_ERROR;
	bool whole = ts_report_write(report, text.out);
	if (ts_file_text_close(&text, name) != TS_OK) return TS_ERROR;
	const char *path = whole ? ts_folder_file(name) : NULL;
	if (!whole) ts_fail("%s: out of memory", name);
	ts_status status = path != NULL ? ts_file_write(path, text.text, text.bytes) : TS_ERROR;
	free(text.text);
	return status;
}
