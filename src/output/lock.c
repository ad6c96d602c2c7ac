/* Locks by flock. */
#include "output/lock.h"
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

enum { TURNS = 100 };

/* Whoever releases a lock may have removed or renamed the file since it was opened. */
static bool is_at(int descriptor, const char *path)
{
	struct stat own, there;
	return fstat(descriptor, &own) == 0 && lstat(path, &there) == 0 && own.st_dev == there.st_dev &&
	       own.st_ino == there.st_ino;
}

static ts_status open_it(ts_lock *lock, const char *path, const char *what)
{
	int flags = O_RDWR | O_NOFOLLOW | O_CLOEXEC;
	lock->descriptor = open(path, flags | O_CREAT | O_EXCL, 0666);
	lock->found = lock->descriptor < 0 && errno == EEXIST;
	if (lock->found) lock->descriptor = open(path, flags);
	if (lock->descriptor >= 0 || (lock->found && errno == ENOENT)) return TS_OK;
	return ts_fail_as(TS_KIND_FILE, "%s: cannot be written: %s", what, strerror(errno));
}

static ts_status lock_it(const ts_lock *lock, const char *path, const char *what)
{
	char holder[16] = "";
	int locked;
	while ((locked = flock(lock->descriptor, LOCK_EX | LOCK_NB)) != 0 && errno == EINTR) {
	}
	if (locked == 0) return TS_OK;
	if (errno != EWOULDBLOCK) {
		return lock->found ? ts_fail_as(TS_KIND_FILE,
		                                "%s: from another run, or one that was killed; remove it if none runs", path)
		                   : TS_OK;
	}
	ssize_t n = pread(lock->descriptor, holder, sizeof holder - 1, 0);
	holder[n > 0 ? strspn(holder, "0123456789") : 0] = 0;
	return ts_fail_as(TS_KIND_FILE, "%s: process %s writes it now; wait for its end, or name another", what,
	                  holder[0] != 0 ? holder : "of another run");
}

ts_status ts_lock_take(ts_lock *lock, const char *path, const char *what)
{
	for (int turn = 0; turn < TURNS; turn++) {
		if (open_it(lock, path, what) != TS_OK) return TS_ERROR;
		if (lock->descriptor < 0) continue;
		ts_status status = lock_it(lock, path, what);
		if (status == TS_OK && is_at(lock->descriptor, path)) return TS_OK;
		close(lock->descriptor);
		lock->descriptor = -1;
		if (status != TS_OK) return TS_ERROR;
	}
	return ts_fail_as(TS_KIND_FILE, "%s: other runs come and go there; name another", what);
}
