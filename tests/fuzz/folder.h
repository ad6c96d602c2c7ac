/* What the fuzz targets share: a folder, which is gone when the process ends, and what holds of every refusal. */
#ifndef TS_TESTS_FUZZ_FOLDER_H
#define TS_TESTS_FUZZ_FOLDER_H
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "trace/emitted/emit.h"

static char fuzz_root[] = "/tmp/touchstone-fuzz-XXXXXX";
static char fuzz_path[32][64];
static int n_fuzz_paths;

static inline void fuzz_end(void)
{
	for (int i = 0; i < n_fuzz_paths; i++) unlink(fuzz_path[i]);
	for (int i = n_fuzz_paths; i-- > 0;) rmdir(fuzz_path[i]);
	rmdir(fuzz_root);
}

static inline void fuzz_begin(void)
{
	if (mkdtemp(fuzz_root) == NULL) abort();
	atexit(fuzz_end);
}

/* A path in the folder, which is removed at the end. */
static inline const char *fuzz_name(const char *name)
{
	char *path = fuzz_path[n_fuzz_paths++];
	snprintf(path, sizeof fuzz_path[0], "%s/%s", fuzz_root, name);
	return path;
}

static inline void fuzz_write(const char *path, const void *data, size_t n)
{
	FILE *file = fopen(path, "wb");
	if (file == NULL || fwrite(data, 1, n, file) != n || fclose(file) != 0) abort();
}

/* What is refused is told in one line. */
static inline void fuzz_refused(void)
{
	const char *message = ts_error_message();
	assert(message[0] != 0 && strchr(message, '\n') == NULL);
}

/* A buffer of n rows of `second`, or of one dimension. */
static inline void fuzz_npy(const char *path, ts_buffer_id id, u64 n, u64 second, const void *data)
{
	char descr[TS_NPY_DESCR], head[TS_NPY_HEADER];
	size_t bytes = (size_t)(n * (second != 0 ? second : 1)) * ts_buffer_table[id].element_bytes;
	ts_npy_descr(descr, id);
	size_t header = ts_npy_header(head, descr, second != 0 ? 2 : 1, (u64[]){n, second});
	FILE *file = fopen(path, "wb");
	if (file == NULL || fwrite(head, 1, header, file) != header || fwrite(data, 1, bytes, file) != bytes) abort();
	if (fclose(file) != 0) abort();
}

#endif
