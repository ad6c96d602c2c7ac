/* Opens a golden's folder as a trace, to compare it with others and to show it. */
#ifndef TS_API_GOLDEN_TRACE_H
#define TS_API_GOLDEN_TRACE_H
#include "trace/read.h"

/* Whether a folder is a golden's and not a trace's. */
bool ts_golden_is(const char *folder);
/* As ts_trace_open_folder, with the files of small/, and preview.png as image.srgb. */
ts_status ts_golden_open(ts_trace **trace, const char *folder);

#endif
