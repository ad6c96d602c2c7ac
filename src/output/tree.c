/* Whole folders: walked by nftw(3), and put in each other's place by renameat2(2), which only Linux has; elsewhere they
 * move. */
#define _GNU_SOURCE
#include "output/tree.h"
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "output/file.h"

enum { FOLDERS_OPEN = 8 };

static int remove_one(const char *path, const struct stat *info, int type, struct FTW *at)
{
	(void)info, (void)type, (void)at;
	return remove(path) == 0 ? 0 : (ts_fail_as(TS_KIND_FILE, "%s: cannot be removed: %s", path, strerror(errno)), 1);
}

static int sync_one(const char *path, const struct stat *info, int type, struct FTW *at)
{
	(void)info, (void)at;
	return type != FTW_D || ts_folder_sync(path) == TS_OK ? 0 : 1;
}

static ts_status walked(const char *path, int result)
{
	if (result < 0) ts_fail_as(TS_KIND_FILE, "%s: %s", path, strerror(errno));
	return result == 0 ? TS_OK : TS_ERROR;
}

ts_status ts_tree_remove(const char *path)
{
	return walked(path, nftw(path, remove_one, FOLDERS_OPEN, FTW_DEPTH | FTW_PHYS));
}

ts_status ts_tree_sync(const char *path) { return walked(path, nftw(path, sync_one, FOLDERS_OPEN, FTW_PHYS)); }

ts_status ts_folder_sync(const char *path)
{
	int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
	int error = folder >= 0 ? ts_sync(folder) : errno;
	if (folder >= 0) close(folder);
	if (error == 0) return TS_OK;
	return ts_fail_as(TS_KIND_FILE, "%s: cannot be given to the disk: %s", path, strerror(error));
}

ts_status ts_parent_sync(const char *path)
{
	const char *slash = strrchr(path, '/');
	if (slash == NULL) return ts_folder_sync(".");
	char *parent = strndup(path, slash > path ? (size_t)(slash - path) : 1);
	if (parent == NULL) return ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
	ts_status status = ts_folder_sync(parent);
	free(parent);
	return status;
}

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
	const bool unknown = errno == EINVAL || errno == ENOSYS || errno == ENOTSUP || errno == EXDEV;
	if (!unknown && errno != EPERM) { /* EPERM: of filters of system calls that know none of that number */
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
