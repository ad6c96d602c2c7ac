/* Folders with all that is in them. Links are not followed. */
#ifndef TS_OUTPUT_TREE_H
#define TS_OUTPUT_TREE_H
#include "model/core.h"

/* Removes the folder with its contents; on failure the message names what could not be removed. */
ts_status ts_tree_remove(const char *path);
/* Syncs the folder and all folders in it, that is, the names of their files, to the disk. */
ts_status ts_tree_sync(const char *path);
/* Syncs this folder alone. */
ts_status ts_folder_sync(const char *path);
/* Syncs the folder that `path` lies in. */
ts_status ts_parent_sync(const char *path);

#endif
