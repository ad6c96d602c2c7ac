/* Reads folders and files of goldens: they are opened by name below an open folder, never through links, and bounded in
 * size. Names that are opened here were made or checked by this program. */
#ifndef TS_GOLDEN_FILE_H
#define TS_GOLDEN_FILE_H
#include "model/core.h"

enum { TS_GOLDEN_PATH = 1024 };

/* An open folder. */
typedef struct {
	int fd;                    /* -1: none */
	char path[TS_GOLDEN_PATH]; /* for messages */
} ts_golden_dir;

/* Opens folder `name` in `parent`, or, with parent NULL, the folder at the path `name`, which may be a link. On failure
 * nothing is open. */
ts_status ts_golden_dir_open(ts_golden_dir *dir, const ts_golden_dir *parent, const char *name);
/* Closes a folder; nothing happens if it is not open. */
void ts_golden_dir_close(ts_golden_dir *dir);

/* Whether the folder has anything of that name. */
bool ts_golden_has(const ts_golden_dir *dir, const char *name);
/* Calls `each` with every name in the folder, in no order, until it fails. */
ts_status ts_golden_names(const ts_golden_dir *dir, ts_status (*each)(void *user, const char *name), void *user);

/* Reads a regular file of at most `most` bytes. On success *data holds *bytes and a 0 after them; release it by free().
 * On failure nothing is allocated. */
ts_status ts_golden_read_file(char **data, size_t *bytes, const ts_golden_dir *dir, const char *name, size_t most);

#endif
