/* Files that are read as a whole. They are untrusted: only regular files are read, pipes and devices could block or
 * never end, and only up to a number of bytes, before which nothing is allocated. */
#ifndef TS_MODEL_INPUT_H
#define TS_MODEL_INPUT_H
#include "model/core.h"
#ifdef __cplusplus
extern "C" {
#endif

/* No limit but a third of the machine's memory, which holds for every file. */
#define TS_INPUT_ANY UINT64_MAX

/* Returns all bytes of a file, of `most` at most, and a 0 behind them; to be released by free(). NULL with the message
 * set if there are more, or if the file cannot be read. */
char *ts_input_read(size_t *bytes, const char *path, uint64_t most);
/* As ts_input_read, of DIR/NAME, with NAME "file" or "sub/file": neither is a link, which could lead out of DIR. DIR
 * itself may be one. */
char *ts_input_read_in(size_t *bytes, const char *dir, const char *name, uint64_t most);
/* As ts_input_read, of a file that is open and is closed here; -1: opening failed and has just set errno. */
char *ts_input_take(size_t *bytes, int descriptor, const char *path, uint64_t most);
/* Reads the first bytes of a file, *n of them and `most` at most. */
ts_status ts_input_head(size_t *n, void *head, size_t most, const char *path);

/* As ts_input_read, of a text, without the byte order mark that may begin it. */
char *ts_text_read(size_t *bytes, const char *path, uint64_t most);
/* Bytes of the mark, in UTF-8, with which a text begins: 3 or 0. */
size_t ts_text_mark(const char *text, size_t n);

#ifdef __cplusplus
}
#endif
#endif
