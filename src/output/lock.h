/* Locks of files and folders that are being written: files under flock, which the kernel releases when the process
 * dies. */
#ifndef TS_OUTPUT_LOCK_H
#define TS_OUTPUT_LOCK_H
#include "model/core.h"

typedef struct {
	int descriptor; /* -1: none */
	bool found;     /* the file existed: a killed process has left it */
} ts_lock;

/* Makes and locks the file at `path`. Fails if another process holds the lock; `what` is for the message. After a
 * failure there is nothing to release. Where the file system has no locks, an existing file counts as locked. */
ts_status ts_lock_take(ts_lock *lock, const char *path, const char *what);

#endif
