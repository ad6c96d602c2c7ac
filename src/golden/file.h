/* Folders and files of goldens: opened by name below an open folder, never through links, and bounded in size. A name
 * that is opened here is one that this program made up or has checked. */
#ifndef TS_TRACE_GOLDEN_FILE_H
#define TS_TRACE_GOLDEN_FILE_H
#include "../model/core.h"

enum { TS_GOLDEN_PATH = 1024 };

/* An open folder. */
typedef struct {
	int fd;                    /* -1: none */
	char path[TS_GOLDEN_PATH]; /* for messages, and for writers that want paths */
} ts_golden_dir;

/* Opens folder `name` in `parent`, or, with parent NULL, the folder at the path `name`, which may be a link. On failure
 * nothing is open. */
ts_status ts_golden_dir_open(ts_golden_dir *dir, const ts_golden_dir *parent, const char *name);
/* The same, making it if there is none. */
ts_status ts_golden_dir_make(ts_golden_dir *dir, const ts_golden_dir *parent, const char *name);
/* Closes it; a folder that is not open, too. */
void ts_golden_dir_close(ts_golden_dir *dir);

/* True if there is anything of that name. */
bool ts_golden_has(const ts_golden_dir *dir, const char *name);
/* Calls `each` with every name in the folder, in no order, until it fails. */
ts_status ts_golden_names(const ts_golden_dir *dir, ts_status (*each)(void *user, const char *name), void *user);

/* Reads a regular file of at most `most` bytes. On success *data holds *bytes and a 0 behind them, by free(); on
 * failure nothing is allocated. */
ts_status ts_golden_read_file(char **data, size_t *bytes, const ts_golden_dir *dir, const char *name, size_t most);
/* Writes a file anew: as NAME.partial, then renamed. */
ts_status ts_golden_write_file(const ts_golden_dir *dir, const char *name, const void *data, size_t bytes);
/* Adds a line to the end of a file, which is made if there is none. */
ts_status ts_golden_add_line(const ts_golden_dir *dir, const char *name, const char *line);
/* Renames a file or folder over a file, or where there is nothing. */
ts_status ts_golden_rename(const ts_golden_dir *dir, const char *from, const char *to);
/* Removes folder `name` and the files in it; without it does nothing. */
ts_status ts_golden_remove_dir(const ts_golden_dir *dir, const char *name);

#endif
