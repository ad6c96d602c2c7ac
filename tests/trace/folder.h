/* What the tests of traces share: files, .npy files written from the format's specification, and
 * small traces. */
#ifndef TS_TESTS_TRACE_FOLDER_H
#define TS_TESTS_TRACE_FOLDER_H
#include <jansson.h>
#include <sys/stat.h>
#include <unistd.h>
#include "tests/scratch.h"
#include "tests/status.h"
#include "trace/emitted/emit.h"

static inline void file_write(const char *path, const void *data, size_t bytes)
{
	FILE *file = fopen(path, "wb");
	if (file == NULL) fail_msg("%s", path);
	assert_int_equal(fwrite(data, 1, bytes, file), bytes);
	assert_int_equal(fclose(file), 0);
}

/* The whole of a file, by free(). */
static inline char *file_read(const char *path, size_t *bytes)
{
	FILE *file = fopen(path, "rb");
	if (file == NULL) fail_msg("%s", path);
	fseek(file, 0, SEEK_END);
	*bytes = (size_t)ftell(file);
	rewind(file);
	char *data = malloc(*bytes + 1);
	assert_non_null(data);
	assert_int_equal(fread(data, 1, *bytes, file), *bytes);
	fclose(file);
	data[*bytes] = 0;
	return data;
}

/* A .npy header of version 1, as the specification has it: prefix, text, blanks, a line feed. Returns its bytes. */
static inline size_t npy_head(char head[2048], const char *dict)
{
	size_t text = strlen(dict), bytes = (10 + text + 1 + 63) / 64 * 64;
	assert_true(bytes <= 2048);
	memset(head, ' ', bytes);
	memcpy(head, "\x93NUMPY\x01\x00", 8);
	head[8] = (char)((bytes - 10) & 0xff);
	head[9] = (char)((bytes - 10) >> 8);
	memcpy(head + 10, dict, text);
	head[bytes - 1] = '\n';
	return bytes;
}

/* A whole .npy file; `shape` as in the header: "(3,)". */
static inline void npy_write(const char *path, const char *descr, const char *shape, const void *data, size_t bytes)
{
	char dict[4096], head[2048];
	snprintf(dict, sizeof dict, "{'descr': %s, 'fortran_order': False, 'shape': %s, }", descr, shape);
	size_t n = npy_head(head, dict);
	char *whole = malloc(n + bytes + 1);
	assert_non_null(whole);
	memcpy(whole, head, n);
	if (bytes > 0) memcpy(whole + n, data, bytes);
	file_write(path, whole, n + bytes);
	free(whole);
}

#endif
