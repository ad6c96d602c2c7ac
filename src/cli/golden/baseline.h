/* Lists of exceptions: --baseline, known differences that pass, and --skip, cases or buffers that are not judged. A
 * line has words, separated by blanks, and a reason at its end; lines that begin with # are comments. The files are
 * untrusted. Part of the core. */
#ifndef TS_CLI_GOLDEN_BASELINE_H
#define TS_CLI_GOLDEN_BASELINE_H
#include "methods/pipeline.h"

typedef struct {
	u32 line;
	const char *name;           /* a case; for --skip also a buffer */
	const char *stage, *buffer; /* of the difference; NULL for --skip */
	const char *reason;
} ts_entry;
/* All zero: an empty list. */
typedef struct {
	const char *path;
	char *text; /* into which the entries point */
	ts_entry *entry;
	size_t n, capacity;
} ts_baseline;

/* The method of a case; TS_ERROR: there is no such case. */
typedef ts_status ts_baseline_case(const void *user, const char *name, const char **effect, const char **method);
/* Reads lines of CASE STAGE BUFFER REASON, each checked. Released by ts_baseline_free, also on failure. */
ts_status ts_baseline_read(ts_baseline *baseline, const char *path, ts_baseline_case *find, const void *user);
/* Fails, with a message, if nothing has the name. */
typedef ts_status ts_baseline_named(const void *user, const char *name);
/* Reads lines of NAME REASON. */
ts_status ts_baseline_skips(ts_baseline *skips, const char *path, ts_baseline_named *check, const void *user);
void ts_baseline_free(ts_baseline *baseline);

/* The entry of that name and, unless `buffer` is NULL, of a difference in that buffer; NULL: there is none. */
const ts_entry *ts_baseline_find(const ts_baseline *baseline, const char *name, const char *buffer);

#endif
