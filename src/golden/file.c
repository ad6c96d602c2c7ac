/* Folders and files of goldens, read by openat and O_NOFOLLOW. */
#include "golden/file.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static ts_status fail(const ts_golden_dir *dir, const char *name, const char *what)
{
	return ts_fail_as(TS_KIND_FILE, "%s/%s: %s: %s", dir->path, name, what, strerror(errno));
}

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

static ts_status read_all(int fd, char *data, size_t bytes)
{
	for (size_t done = 0; done < bytes;) {
		ssize_t n = read(fd, data + done, bytes - done);
		if (n == 0) errno = EIO;
		if (n == 0 || (n < 0 && errno != EINTR)) return TS_ERROR;
		if (n > 0) done += (size_t)n;
	}
	return TS_OK;
}

ts_status ts_golden_read_file(char **data, size_t *bytes, const ts_golden_dir *dir, const char *name, size_t most)
{
	struct stat s;
	ts_status status = TS_ERROR;
	*data = NULL;
	*bytes = 0;
	int fd = openat(dir->fd, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
	if (fd < 0) return fail(dir, name, "cannot open");
	if (fstat(fd, &s) != 0 || !S_ISREG(s.st_mode)) {
		ts_fail_as(TS_KIND_FILE, "%s/%s: not a regular file", dir->path, name);
	} else if ((unsigned long long)s.st_size > most) {
		ts_fail("%s/%s: %llu bytes; at most %zu are right", dir->path, name, (unsigned long long)s.st_size, most);
	} else if ((*data = ts_alloc((size_t)s.st_size + 1, 1, "a golden")) != NULL) {
		*bytes = (size_t)s.st_size;
		(*data)[*bytes] = 0;
		status = read_all(fd, *data, *bytes);
		if (status != TS_OK) fail(dir, name, "cannot read");
	}
	close(fd);
	if (status == TS_OK) return TS_OK;
	free(*data);
	*data = NULL;
	return TS_ERROR;
}
