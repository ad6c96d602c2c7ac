/* Folders and files of goldens, read by openat and O_NOFOLLOW. */
#include "golden/file.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "model/input.h"

ts_status ts_golden_dir_open(ts_golden_dir *dir, const ts_golden_dir *parent, const char *name)
{
	int n = parent != NULL ? snprintf(dir->path, sizeof dir->path, "%s/%s", parent->path, name)
	                       : snprintf(dir->path, sizeof dir->path, "%s", name);
	dir->fd = -1;
	if (n < 0 || n >= TS_GOLDEN_PATH) return ts_fail("%.80s...: a path beyond %d bytes", name, TS_GOLDEN_PATH - 1);
	int flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC | (parent != NULL ? O_NOFOLLOW : 0);
	dir->fd = openat(parent != NULL ? parent->fd : AT_FDCWD, name, flags);
	return dir->fd >= 0 ? TS_OK
	                    : ts_fail_as(TS_KIND_FILE, "%s: cannot open the folder: %s", dir->path, strerror(errno));
}

void ts_golden_dir_close(ts_golden_dir *dir)
{
	if (dir->fd >= 0) close(dir->fd);
	dir->fd = -1;
}

bool ts_golden_has(const ts_golden_dir *dir, const char *name)
{
	struct stat s;
	return fstatat(dir->fd, name, &s, AT_SYMLINK_NOFOLLOW) == 0;
}

ts_status ts_golden_names(const ts_golden_dir *dir, ts_status (*each)(void *user, const char *name), void *user)
{
	int fd = openat(dir->fd, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
	DIR *list = fd >= 0 ? fdopendir(fd) : NULL;
	if (list == NULL) {
		if (fd >= 0) close(fd);
		return ts_fail_as(TS_KIND_FILE, "%s: cannot list the folder: %s", dir->path, strerror(errno));
	}
	ts_status status = TS_OK;
	for (struct dirent *entry; status == TS_OK && (entry = readdir(list)) != NULL;) {
		const char *name = entry->d_name;
		if (strcmp(name, ".") != 0 && strcmp(name, "..") != 0) status = each(user, name);
	}
	closedir(list);
	return status;
}

ts_status ts_golden_read_file(char **data, size_t *bytes, const ts_golden_dir *dir, const char *name, size_t most)
{
	char path[TS_GOLDEN_PATH + NAME_MAX];
	snprintf(path, sizeof path, "%s/%s", dir->path, name);
	*data = ts_input_take(bytes, openat(dir->fd, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC), path, most);
	return *data != NULL ? TS_OK : TS_ERROR;
}
