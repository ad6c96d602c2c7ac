/* Folders with all that is in them. Links are not followed. */
#ifndef TS_OUTPUT_TREE_H
#define TS_OUTPUT_TREE_H
#include "../model/core.h"

/* Removes the folder; the message says what could not be. */
ts_status ts_tree_remove(const char *path);
/* Gives the disk the folder and those in it, that is, the names of their files. */
ts_status ts_tree_sync(const char *path);
/* Gives the disk this folder alone. */
ts_status ts_folder_sync(const char *path);
/* The same of the folder that `path` lies in. */
ts_status ts_parent_sync(const char *path);

#endif
