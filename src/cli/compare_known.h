/* What is known of a comparison before: differences that pass, and buffers that are not judged. */
#ifndef TS_CLI_COMPARE_KNOWN_H
#define TS_CLI_COMPARE_KNOWN_H
#include "baseline.h"
#include "compare.h"

enum { TS_COMPARE_CASE = 64, TS_KNOWN_TEXT = 2048 };
struct ts_compare_lists {
	char name[TS_COMPARE_CASE]; /* of the case: EFFECT/METHOD */
	ts_baseline known, skips;
	const char *stages; /* others are another shard's; NULL: there are no shards */
	char *ignore;       /* --ignore, and what is skipped; NULL: nothing */
};
/* Reads the files of --baseline and --skip for a comparison of such traces. Released by ts_compare_lists_free, also on
 * failure. */
ts_status ts_compare_lists_read(ts_compare_lists *lists, const ts_cli *cli, const ts_trace_info *of);
void ts_compare_lists_free(ts_compare_lists *lists);

/* The entry of a buffer that differs; NULL: it is not known. */
const ts_entry *ts_compare_known(const ts_compare_lists *lists, const char *buffer);
/* Why the buffer is skipped; "" if it is not. */
const char *ts_compare_skipped(const ts_compare_lists *lists, const char *buffer);
/* Says what is to be changed in the list, if entry i is of this case and does not differ any more; false: it does, or
 * is of another. */
bool ts_compare_stale(char text[TS_KNOWN_TEXT], const ts_compare_lists *lists, const ts_compared *compared, size_t i);
/* A line for each of them. */
void ts_compare_report_known(ts_report *report, const ts_compare_lists *lists, const ts_compared *compared);

#endif
