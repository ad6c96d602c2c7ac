/* Exceptions of a comparison: known differences, which pass, and buffers that are not judged. */
#ifndef TS_CLI_COMPARE_KNOWN_H
#define TS_CLI_COMPARE_KNOWN_H
#include "cli/compare.h"
#include "cli/golden/baseline.h"

enum { TS_COMPARE_CASE = 64, TS_KNOWN_TEXT = 2048 };
struct ts_compare_lists {
	char name[TS_COMPARE_CASE]; /* of the case: EFFECT/METHOD */
	ts_baseline known, skips;
	const char *stages; /* of this shard; NULL: there are no shards */
	char *ignore;       /* --ignore and the skipped buffers; NULL: none */
};
/* Reads the files of --baseline and --skip for a comparison of such traces. Released by ts_compare_lists_free, also on
 * failure. */
ts_status ts_compare_lists_read(ts_compare_lists *lists, const ts_cli *cli, const ts_trace_info *of);
void ts_compare_lists_free(ts_compare_lists *lists);

/* The entry of a buffer that differs; NULL: it is not known. */
const ts_entry *ts_compare_known(const ts_compare_lists *lists, const char *buffer);
/* The reason for which the buffer is skipped; "" if it is not. */
const char *ts_compare_skipped(const ts_compare_lists *lists, const char *buffer);
/* If the buffer of entry i, an entry of this case, does not differ any more, `text` says what to change in the list.
 * False: it still differs, or the entry is of another case. */
bool ts_compare_stale(char text[TS_KNOWN_TEXT], const ts_compare_lists *lists, const ts_compared *compared, size_t i);
/* Reports a line for each entry. */
void ts_compare_report_known(ts_report *report, const ts_compare_lists *lists, const ts_compared *compared);

#endif
