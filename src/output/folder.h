/* The folder that is written: as DIR.partial, then put in place as a whole, or removed. One at a time.
 *
 * DIR.lock stands beside while it is written. A process that is killed leaves both; the next that writes DIR removes
 * them, and says so. A folder that is replaced changes places with the new one, by renameat2. Where the file system
 * cannot do that, the old one is first renamed to DIR.old: who looks at that moment, finds none, and if the process is
 * killed then, the next puts the old one back. */
#ifndef TS_OUTPUT_FOLDER_H
#define TS_OUTPUT_FOLDER_H
#include "../model/core.h"

enum { TS_FOLDER_PATH = 4096 };

/* Whether all that is in DIR, which is not empty, may be replaced; if not, the message says why. */
typedef ts_status ts_folder_judge(const char *dir);

/* Makes DIR.partial, and what folders are missing above. DIR must be absent, empty, or one that `judge` lets go, now
 * and when the new one takes its place. */
ts_status ts_folder_begin(const char *dir, ts_folder_judge *judge);
/* The path at which to write file `name`, which may lie in one folder, "sub/name"; valid until commit or discard. NULL
 * with the message set on failure. */
const char *ts_folder_file(const char *name);
/* The folder that they are in, DIR.partial; valid until then. */
const char *ts_folder_path(void);
/* The i-th of these names; NULL: there are no more. */
const char *ts_folder_name(size_t i);
/* Puts DIR.partial, whose files are written, in the place of DIR; both are on the disk. On failure DIR is as it was;
 * then discard. */
ts_status ts_folder_commit(void);
/* Removes DIR.partial and all in it; without one does nothing. */
void ts_folder_discard(void);

/* Removes DIR and all in it, in one step: whoever looks finds all of it or nothing. */
ts_status ts_folder_remove(const char *dir);
/* Removes what a process that was killed has left of DIR, unless another works on it, and the n_parents folders above
 * it, if they are empty. */
void ts_folder_clear(const char *dir, uint32_t n_parents);

#endif
