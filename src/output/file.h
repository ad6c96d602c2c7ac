/* Files that are written. Each holds all that was put into it and is on the disk, or the call that failed says why:
 * short writes go on, interrupted ones start again, and a file that failed once has failed. */
#ifndef TS_OUTPUT_FILE_H
#define TS_OUTPUT_FILE_H
#include <stdio.h>
#include "../model/core.h"

/* One that is open. `path` is the caller's, and stays until the end. */
typedef struct {
	const char *path;
	int descriptor; /* -1: none */
	int error;      /* errno of the first failure; 0: none */
	uint8_t *held;  /* bytes that are not written yet */
	size_t n_held;
} ts_file;

/* Makes the file, or empties it. After a failure there is nothing to end. */
ts_status ts_file_begin(ts_file *file, const char *path);
/* The same of a file that is open, which is closed in the end; -1: opening it has just set errno. */
ts_status ts_file_adopt(ts_file *file, int descriptor, const char *path);
ts_status ts_file_put(ts_file *file, const void *data, size_t bytes);
/* Writes the rest, gives the file to the disk and closes it. */
ts_status ts_file_end(ts_file *file);
/* Closes what is open, after a failure elsewhere. */
void ts_file_drop(ts_file *file);

/* Gives the disk what is open; 0, or errno. Pipes have nothing to give. */
int ts_sync(int descriptor);

/* A whole file at once. */
ts_status ts_file_write(const char *path, const void *data, size_t bytes);
/* The same as PATH.partial, then renamed: what was there stays until all is written. Two processes that do so at a time
 * do not mix. What is no regular file, as a pipe or a link, is written as it is. */
ts_status ts_file_replace(const char *path, const void *data, size_t bytes);

/* To standard output, behind what its stream holds. */
ts_status ts_file_print(const void *data, size_t bytes);

/* Text for a file: `out` is a stream in memory. May not be moved while that is open. */
typedef struct {
	FILE *out;
	char *text;
	size_t bytes, capacity;
} ts_file_text;
/* `what` is for messages. After a failure there is nothing to end. */
ts_status ts_file_text_begin(ts_file_text *text, const char *what);
/* Puts all that was written so far into *text and *bytes, which may be set to 0 then. */
ts_status ts_file_text_flush(ts_file_text *text, const char *what);
/* Closes the stream; *text and *bytes are whole then: nothing that a library wrote there is left out. Frees them on
 * failure. */
ts_status ts_file_text_close(ts_file_text *text, const char *what);
/* Closes it without a word, after a failure elsewhere. */
void ts_file_text_drop(ts_file_text *text);
/* Closes it, writes or replaces the file, or prints it, and frees the text. */
ts_status ts_file_text_write(ts_file_text *text, const char *path);
ts_status ts_file_text_replace(ts_file_text *text, const char *path);
ts_status ts_file_text_print(ts_file_text *text);

#endif
