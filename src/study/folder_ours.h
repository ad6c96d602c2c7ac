/* Which files of a folder an earlier run wrote: those that its report.json or vectors.json lists. */
#ifndef TS_STUDY_FOLDER_OURS_H
#define TS_STUDY_FOLDER_OURS_H
#include <stdbool.h>
#include <touchstone/status.h>

/* Fails, and says why, if DIR holds anything that no report.json or vectors.json in it lists, or no such file. */
ts_status ts_ours_judge(const char *dir);

/* "name" or "sub/name", none of them hidden: no name that leads out of the folder. */
bool ts_ours_is_name(const char *name);

#endif
