/* Writing files. A file is complete and on the disk, or a call fails and says why. Short and interrupted writes are
 * continued; after its first failure every call with the file fails. */
#ifndef TS_OUTPUT_FILE_H
#define TS_OUTPUT_FILE_H
#include <stdio.h>
#include "model/core.h"

/* An open file. `path` belongs to the caller and must outlive the ts_file. */
typedef struct {
	const char *path;
	int descriptor; /* -1: none */
	int error;      /* errno of the first failure; 0: none */
	uint8_t *held;  /* bytes that are not written yet */
	size_t n_held;
} ts_file;

/* Makes the file, or empties an existing one. After a failure the file needs no ts_file_end. */
ts_status ts_file_begin(ts_file *file, const char *path);
/* As ts_file_begin, for an open descriptor, which ts_file_end closes; -1: opening failed and has just set errno. */
ts_status ts_file_adopt(ts_file *file, int descriptor, const char *path);
ts_status ts_file_put(ts_file *file, const void *data, size_t bytes);
/* Writes the rest, syncs the file to the disk and closes it. */
ts_status ts_file_end(ts_file *file);
/* Closes the file without writing the rest, after a failure elsewhere. */
void ts_file_drop(ts_file *file);

/* Syncs an open file to the disk; returns 0 or errno. For a pipe nothing is done. */
int ts_sync(int descriptor);

/* Writes a whole file. */
ts_status ts_file_write(const char *path, const void *data, size_t bytes);
/* As ts_file_write, but to PATH.partial, which is then renamed: the old file stays until all is written. The output of
 * two processes that write PATH at the same time does not mix. A path that is no regular file, such as a pipe or a
 * link, is written directly. */
ts_status ts_file_replace(const char *path, const void *data, size_t bytes);

/* Writes to standard output, behind the bytes that stdout still buffers. */
ts_status ts_file_print(const void *data, size_t bytes);

/* Text for a file: `out` is a stream in memory. The struct must not be moved while the stream is open. */
typedef struct {
	FILE *out;
	char *text;
	size_t bytes, capacity;
} ts_file_text;
/* Opens the stream; `what` names the text in messages. After a failure there is nothing to release. */
ts_status ts_file_text_begin(ts_file_text *text, const char *what);
/* Flushes the stream: `text` and `bytes` then hold all that was written. With `bytes` set to 0 the text begins anew. */
ts_status ts_file_text_flush(ts_file_text *text, const char *what);
/* Closes the stream and checks that all output, that of libraries too, was stored. Frees the text on failure. */
ts_status ts_file_text_close(ts_file_text *text, const char *what);
/* Closes the stream and frees the text, after a failure elsewhere. */
void ts_file_text_drop(ts_file_text *text);
/* Closes the stream, writes the text to a file, replaces a file by it, or prints it, and frees it. */
ts_status ts_file_text_write(ts_file_text *text, const char *path);
ts_status ts_file_text_replace(ts_file_text *text, const char *path);
ts_status ts_file_text_print(ts_file_text *text);

#endif
