/* Folders change places by renameat2(2), which only Linux has; elsewhere they move. */
#define _GNU_SOURCE
#include "output/place.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static ts_status move(const char *from, const char *to)
{
	return rename(from, to) == 0
	           ? TS_OK
	           : ts_fail_as(TS_KIND_FILE, "%s: cannot be renamed to %s: %s", from, to, strerror(errno));
}

bool ts_place_has(const char *path)
{
	struct stat info;
	return lstat(path, &info) == 0;
}

ts_status ts_place_take(const ts_place *place)
{
	if (rename(place->partial, place->dir) == 0) return TS_OK;
	if (errno == EEXIST || errno == ENOTEMPTY) return TS_DIFFERENT;
	return ts_fail_as(TS_KIND_FILE, "%s: cannot be renamed to %s: %s", place->partial, place->dir, strerror(errno));
}

ts_status ts_place_exchange(const ts_place *place)
{
#ifdef RENAME_EXCHANGE
	if (renameat2(AT_FDCWD, place->partial, AT_FDCWD, place->dir, RENAME_EXCHANGE) == 0) return TS_OK;
	if (errno != EINVAL && errno != ENOSYS && errno != ENOTSUP && errno != EXDEV) {
		return ts_fail_as(TS_KIND_FILE, "%s: cannot change places with %s: %s", place->partial, place->dir,
		                  strerror(errno));
	}
#endif
	return TS_DIFFERENT;
}

ts_status ts_place_move(const ts_place *place)
{
	ts_status status = move(place->dir, place->old);
	if (status == TS_OK && (status = move(place->partial, place->dir)) != TS_OK) rename(place->old, place->dir);
	return status;
}

ts_status ts_place_undo(const ts_place *place, ts_placed placed)
{
	if (placed == TS_PLACE_EXCHANGED) return ts_place_exchange(place);
	ts_status status = move(place->dir, place->partial);
	return status == TS_OK && placed == TS_PLACE_MOVED ? move(place->old, place->dir) : status;
}
