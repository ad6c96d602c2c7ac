/* The output folder: written as DIR.partial, then put in place as a whole, or removed. A thread writes one at a time.
 *
 * DIR.lock stands beside it meanwhile. A process that is killed leaves DIR.partial and DIR.lock; the next process that
 * writes DIR removes them and says so. A folder that is replaced is exchanged with the new one by renameat2. Where the
 * file system cannot exchange, the old folder is first renamed to DIR.old. At that moment there is no DIR; if the
 * process is killed then, the next one renames DIR.old back. */
#ifndef TS_OUTPUT_FOLDER_H
#define TS_OUTPUT_FOLDER_H
#include "model/core.h"

enum { TS_FOLDER_PATH = 4096 };

/* Decides whether DIR, which is not empty, may be replaced with all its contents; if not, fails and says why. */
typedef ts_status ts_folder_judge(const char *dir);

/* Makes DIR.partial, and missing folders above it. DIR must be absent, empty, or accepted by `judge`, both now and at
 * ts_folder_commit. */
ts_status ts_folder_begin(const char *dir, ts_folder_judge *judge);
/* The path at which to write file `name`, or "sub/name" of a folder in it; valid until commit or discard. NULL with the
 * message set on failure. */
const char *ts_folder_file(const char *name);
/* The path of DIR.partial; valid until commit or discard. */
const char *ts_folder_path(void);
/* The i-th name that ts_folder_file was called with, from 0; NULL: there are no more. */
const char *ts_folder_name(size_t i);
/* Puts DIR.partial, whose files are written, in the place of DIR, and syncs the files and folders. On failure DIR is
 * unchanged, and ts_folder_discard must be called. */
ts_status ts_folder_commit(void);
/* Removes DIR.partial with its contents; without an open folder does nothing. */
void ts_folder_discard(void);

/* Removes DIR with its contents in one step: other processes see all of it or nothing. */
ts_status ts_folder_remove(const char *dir);
/* Removes what a killed process has left of DIR, unless another process works on DIR, and the n_parents folders above
 * DIR that are empty. */
void ts_folder_clear(const char *dir, uint32_t n_parents);

#endif
