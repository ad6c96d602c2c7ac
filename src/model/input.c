/* Files that are read as a whole. */
#include "model/input.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATH_BYTES = 4096 + 300, FLAGS = O_RDONLY | O_NONBLOCK | O_CLOEXEC };

/* The bytes of an open file; less than the file has if they cannot be read. */
static size_t read_some(int file, char *data, size_t bytes)
{
	size_t done = 0;
	while (done < bytes) {
		const ssize_t n = read(file, data + done, bytes - done);
		if (n == 0 || (n < 0 && errno != EINTR)) break;
		if (n > 0) done += (size_t)n;
	}
	return done;
}

/* The size of an open file, which must be a regular one. */
static ts_status measure(uint64_t *size, int file, const char *path)
{
	struct stat info;
	if (file < 0 || fstat(file, &info) != 0) {
		const char *why = errno == ELOOP ? "a link; the file itself would be right" : strerror(errno);
		return ts_fail_as(TS_KIND_FILE, "%s: %s", path, why);
	}
	*size = (uint64_t)info.st_size;
	return S_ISREG(info.st_mode) ? TS_OK : ts_fail_as(TS_KIND_FILE, "%s: not a regular file", path);
}

static ts_status check_size(uint64_t size, const char *path, uint64_t most)
{
	if (size > most) {
		return ts_fail_as(TS_KIND_FILE, "%s: %llu bytes; at most %llu are read", path, (unsigned long long)size,
		                  (unsigned long long)most);
	}
	if (size <= ts_memory_total() / 3) return TS_OK;
	return ts_fail_as(TS_KIND_MEMORY, "%s: %llu bytes are more than a third of this machine's memory", path,
	                  (unsigned long long)size);
}

static char *read_all(size_t *bytes, int file, const char *path, uint64_t most)
{
	uint64_t size;
	if (measure(&size, file, path) != TS_OK || check_size(size, path, most) != TS_OK) return NULL;
	char *data = ts_alloc((size_t)size + 1, 1, path);
	if (data == NULL) return NULL;
	errno = 0;
	*bytes = read_some(file, data, (size_t)size);
	data[*bytes] = 0;
	if (*bytes == size) return data;
	ts_fail_as(TS_KIND_FILE, "%s: cannot be read as a whole: %s", path,
	           errno != 0 ? strerror(errno) : "it became shorter");
	free(data);
	return NULL;
}

char *ts_input_take(size_t *bytes, int descriptor, const char *path, uint64_t most)
{
	char *data = read_all(bytes, descriptor, path, most);
	if (descriptor >= 0) close(descriptor);
	return data;
}

char *ts_input_read(size_t *bytes, const char *path, uint64_t most)
{
	return ts_input_take(bytes, open(path, FLAGS), path, most);
}

/* Opens NAME below an open folder, which is closed; -1 with errno set. */
static int open_below(int folder, const char *name, int flags)
{
	if (folder < 0) return -1;
	const int file = openat(folder, name, FLAGS | O_NOFOLLOW | flags), error = errno;
	close(folder);
	errno = error;
	return file;
}

char *ts_input_read_in(size_t *bytes, const char *dir, const char *name, uint64_t most)
{
	char path[PATH_BYTES], sub[PATH_BYTES];
	const char *slash = strchr(name, '/');
	if (snprintf(path, sizeof path, "%s/%s", dir, name) >= PATH_BYTES) {
		ts_fail("%.200s: a path in it of more than %d bytes", dir, PATH_BYTES - 1);
		return NULL;
	}
	snprintf(sub, sizeof sub, "%.*s", slash != NULL ? (int)(slash - name) : 0, name);
	int folder = open(dir, FLAGS | O_DIRECTORY);
	if (slash != NULL) folder = open_below(folder, sub, O_DIRECTORY);
	return ts_input_take(bytes, open_below(folder, slash != NULL ? slash + 1 : name, 0), path, most);
}

ts_status ts_input_head(size_t *n, void *head, size_t most, const char *path)
{
	const int file = open(path, FLAGS);
	uint64_t size;
	ts_status status = measure(&size, file, path);
	if (status == TS_OK) *n = read_some(file, head, most);
	if (file >= 0) close(file);
	return status;
}

size_t ts_text_mark(const char *text, size_t n)
{
	static const char mark[] = {'\xef', '\xbb', '\xbf'};
	return n >= sizeof mark && memcmp(text, mark, sizeof mark) == 0 ? sizeof mark : 0;
}

char *ts_text_read(size_t *bytes, const char *path, uint64_t most)
{
	char *text = ts_input_read(bytes, path, most);
	size_t mark = text != NULL ? ts_text_mark(text, *bytes) : 0;
	if (mark == 0) return text;
	*bytes -= mark;
	return memmove(text, text + mark, *bytes + 1);
}
