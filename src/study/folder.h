/* The output folder: written as DIR.partial and renamed as a whole, or removed, also by a signal. One at a time. */
#ifndef TS_CLI_FOLDER_H
#define TS_CLI_FOLDER_H
#include <jansson.h>
#include "../model/core.h"
#include "table.h"

/* Makes DIR.partial. DIR must be absent or empty, or, with `force`, hold nothing but the regular files that its
 * report.json or vectors.json, of an earlier run, lists. From here on a signal that ends the process removes
 * DIR.partial. */
ts_status ts_folder_begin(const char *dir, bool force);
/* The path at which to write file `name`, which may lie in one folder, "sub/name"; valid until commit or discard. NULL
 * with the message set on failure. */
const char *ts_folder_file(const char *name);
/* The names of all files so far; a new reference, or NULL with the message set. */
json_t *ts_folder_list(void);
/* Writes report.json, with the names of all files, which a later --force goes by. */
ts_status ts_folder_report(ts_report *report);
/* Gives the disk DIR.partial, then renames it to DIR. On failure DIR is as it was; then discard. */
ts_status ts_folder_commit(void);
/* Removes DIR.partial and all in it; without one does nothing. */
void ts_folder_discard(void);

#endif
