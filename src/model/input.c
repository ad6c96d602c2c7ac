/* Files that are read as a whole. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "model/core.h"

/* Reads an open regular file. */
static char *read_all(size_t *bytes, FILE *file, const char *path)
{
	struct stat info;
	char *data = NULL;
	if (fstat(fileno(file), &info) != 0)
		ts_fail_as(TS_KIND_FILE, "%s: %s", path, strerror(errno));
	else if (!S_ISREG(info.st_mode))
		ts_fail_as(TS_KIND_FILE, "%s: not a regular file", path);
	else if ((uint64_t)info.st_size > ts_memory_total() / 3)
		ts_fail_as(TS_KIND_MEMORY, "%s: %lld bytes are more than a third of this machine's memory", path,
		           (long long)info.st_size);
	else
		data = ts_alloc((size_t)info.st_size + 1, 1, path);
	if (data == NULL) return NULL;
	errno = 0;
	*bytes = fread(data, 1, (size_t)info.st_size, file);
	data[*bytes] = 0;
	if (*bytes == (size_t)info.st_size) return data;
	ts_fail_as(TS_KIND_FILE, "%s: cannot be read as a whole: %s", path,
	           errno != 0 ? strerror(errno) : "it became shorter");
	free(data);
	return NULL;
}

char *ts_input_read(size_t *bytes, const char *path)
{
	int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
	FILE *file = descriptor >= 0 ? fdopen(descriptor, "rb") : NULL;
	if (file == NULL) {
		ts_fail_as(TS_KIND_FILE, "%s: %s", path, strerror(errno));
		if (descriptor >= 0) close(descriptor);
		return NULL;
	}
	char *data = read_all(bytes, file, path);
	fclose(file);
	return data;
}

size_t ts_text_mark(const char *text, size_t n)
{
	static const char mark[] = {'\xef', '\xbb', '\xbf'};
	return n >= sizeof mark && memcmp(text, mark, sizeof mark) == 0 ? sizeof mark : 0;
}

char *ts_text_read(size_t *bytes, const char *path)
{
	char *text = ts_input_read(bytes, path);
	size_t mark = text != NULL ? ts_text_mark(text, *bytes) : 0;
	if (mark == 0) return text;
	*bytes -= mark;
	return memmove(text, text + mark, *bytes + 1);
}
