/* Which files of a folder an earlier render wrote: those that its report.json or vectors.json lists. */
#ifndef TS_CLI_FOLDER_OURS_H
#define TS_CLI_FOLDER_OURS_H
#include <jansson.h>
#include <stdbool.h>

/* Reads DIR/report.json, or else DIR/vectors.json: the array of the names it lists, of files "name" or "sub/name", a
 * new reference; NULL, without a message, unless it is a regular file that this program wrote. */
json_t *ts_ours_read(const char *dir);
/* Whether `name` is a regular file of DIR that `ours` lists, or its report.json. A NULL `ours` lists nothing. */
bool ts_ours_has(const json_t *ours, const char *dir, const char *name);
/* Whether `name` is a folder of DIR that holds such files and nothing else. */
bool ts_ours_is_folder(const json_t *ours, const char *dir, const char *name);

#endif
