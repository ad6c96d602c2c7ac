/* Which files of a folder an earlier run wrote: those that its report.json or vectors.json lists. */
#ifndef TS_STUDY_FOLDER_OURS_H
#define TS_STUDY_FOLDER_OURS_H
#include <stdbool.h>
#include <touchstone/status.h>

/* Fails, and says why, if DIR has neither report.json nor vectors.json, or holds anything that they do not list. */
ts_status ts_ours_judge(const char *dir);

/* Whether a name is "name" or "sub/name" without hidden parts, and so does not lead out of the folder. */
bool ts_ours_is_name(const char *name);

#endif
