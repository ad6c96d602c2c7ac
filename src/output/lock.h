/* Locks of what is being written: files under flock, which the kernel drops when their process dies. */
#ifndef TS_OUTPUT_LOCK_H
#define TS_OUTPUT_LOCK_H
#include "../model/core.h"

typedef struct {
	int descriptor; /* -1: none */
	bool found;     /* the file was there: a process that was killed has left it */
} ts_lock;

/* Makes and locks the file at `path`. Fails if another process has it; `what` is for the message. After a failure there
 * is nothing to release. Where the file system has no locks, a file that is there counts as another's. */
ts_status ts_lock_take(ts_lock *lock, const char *path, const char *what);

#endif
