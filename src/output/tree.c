/* Folders, walked by nftw(3). */
#define _XOPEN_SOURCE 700
#include "output/tree.h"
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
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
