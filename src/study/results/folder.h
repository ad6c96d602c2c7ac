/* The folder of results, with report.json or another file that lists its files. */
#ifndef TS_STUDY_RESULTS_FOLDER_H
#define TS_STUDY_RESULTS_FOLDER_H
#include <stdbool.h>
#include <touchstone/status.h>
#include "output/folder.h"
#include "study/results/table.h"

/* Fails, and says why, if DIR has neither report.json nor vectors.json, or holds anything that they do not list. */
ts_status ts_ours_judge(const char *dir);

/* Whether a name is "name" or "sub/name" without hidden parts, and so does not lead out of the folder. */
bool ts_ours_is_name(const char *name);

/* ts_folder_begin: DIR must be absent or empty, or, with `force`, hold nothing but the regular files that its
 * report.json or vectors.json, of an earlier run, lists. */
ts_status ts_results_begin(const char *dir, bool force);
/* The names of all files so far; a new reference, or NULL with the message set. */
json_t *ts_results_list(void);
/* Writes times.json, with the figures of the report that differ from run to run, if there are any; and report.json,
 * with the other figures and the names of all files. A later --force replaces only files named there. */
ts_status ts_results_report(ts_report *report);

#endif
