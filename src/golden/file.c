/* Folders and files of goldens, by openat and O_NOFOLLOW. */
#include "file.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "../output/file.h"

static ts_status fail(const ts_golden_dir *dir, const char *name, const char *what)
{
	return ts_fail("%s/%s: %s: %s", dir->path, name, what, strerror(errno));
}

ts_status ts_golden_dir_open(ts_golden_dir *dir, const ts_golden_dir *parent, const char *name)
{
	int n = parent != NULL ? snprintf(dir->path, sizeof dir->path, "%s/%s", parent->path, name)
	                       : snprintf(dir->path, sizeof dir->path, "%s", name);
	dir->fd = -1;
	if (n < 0 || n >= TS_GOLDEN_PATH) return ts_fail("%.80s...: a path beyond %d bytes", name, TS_GOLDEN_PATH - 1);
	int flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC | (parent != NULL ? O_NOFOLLOW : 0);
	dir->fd = openat(parent != NULL ? parent->fd : AT_FDCWD, name, flags);
	return dir->fd >= 0 ? TS_OK : ts_fail("%s: cannot open the folder: %s", dir->path, strerror(errno));
}

ts_status ts_golden_dir_make(ts_golden_dir *dir, const ts_golden_dir *parent, const char *name)
{
	dir->fd = -1;
	if (mkdirat(parent->fd, name, 0777) != 0 && errno != EEXIST) return fail(parent, name, "cannot make the folder");
	return ts_golden_dir_open(dir, parent, name);
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
		return ts_fail("%s: cannot list the folder: %s", dir->path, strerror(errno));
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
		ts_fail("%s/%s: not a regular file", dir->path, name);
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

/* Data, and a text behind it. */
static ts_status write_all(const ts_golden_dir *dir, int fd, const char *name, const void *data, size_t bytes,
                           const char *end)
{
	ts_file file;
	char path[TS_GOLDEN_PATH + 128];
	snprintf(path, sizeof path, "%s/%s", dir->path, name);
	if (ts_file_adopt(&file, fd, path) != TS_OK) return TS_ERROR;
	if (ts_file_put(&file, data, bytes) == TS_OK && ts_file_put(&file, end, strlen(end)) == TS_OK) {
		return ts_file_end(&file);
	}
	ts_file_drop(&file);
	return TS_ERROR;
}

ts_status ts_golden_write_file(const ts_golden_dir *dir, const char *name, const void *data, size_t bytes)
{
	char partial[128];
	snprintf(partial, sizeof partial, "%.100s.partial", name);
	unlinkat(dir->fd, partial, 0);
	int fd = openat(dir->fd, partial, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
	if (fd < 0) return fail(dir, name, "cannot write");
	ts_status status = write_all(dir, fd, name, data, bytes, "");
	if (status == TS_OK && renameat(dir->fd, partial, dir->fd, name) == 0) return TS_OK;
	if (status == TS_OK) fail(dir, name, "cannot write");
	unlinkat(dir->fd, partial, 0);
	return TS_ERROR;
}

ts_status ts_golden_add_line(const ts_golden_dir *dir, const char *name, const char *line)
{
	int fd = openat(dir->fd, name, O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666);
	if (fd < 0) return fail(dir, name, "cannot add to it");
	return write_all(dir, fd, name, line, strlen(line), "\n");
}

ts_status ts_golden_rename(const ts_golden_dir *dir, const char *from, const char *to)
{
	return renameat(dir->fd, from, dir->fd, to) == 0 ? TS_OK : fail(dir, from, "cannot rename");
}

static ts_status remove_entry(void *user, const char *name)
{
	const ts_golden_dir *dir = user;
	return unlinkat(dir->fd, name, 0) == 0 ? TS_OK : fail(dir, name, "cannot remove");
}

ts_status ts_golden_remove_dir(const ts_golden_dir *dir, const char *name)
{
	ts_golden_dir inner;
	if (!ts_golden_has(dir, name)) return TS_OK;
	if (ts_golden_dir_open(&inner, dir, name) != TS_OK) return TS_ERROR;
	ts_status status = ts_golden_names(&inner, remove_entry, &inner);
	ts_golden_dir_close(&inner);
	if (status == TS_OK && unlinkat(dir->fd, name, AT_REMOVEDIR) != 0) status = fail(dir, name, "cannot remove");
	return status;
}
