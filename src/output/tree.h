/* Whole folders: with all that is in them, where links are not followed; and putting a new one in the place of an old
 * one. */
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

typedef struct {
	const char *dir, *partial, *old;
} ts_place;

/* What became of DIR. */
typedef enum {
	TS_PLACE_FREE,      /* there was none, or an empty one */
	TS_PLACE_EXCHANGED, /* the old folder is DIR.partial now */
	TS_PLACE_MOVED,     /* the old folder is DIR.old now */
} ts_placed;

/* Renames DIR.partial to DIR, which must be absent or an empty folder. TS_DIFFERENT: DIR is neither. */
ts_status ts_place_take(const ts_place *place);
/* Exchanges DIR and DIR.partial. TS_DIFFERENT: the file system cannot exchange folders. */
ts_status ts_place_exchange(const ts_place *place);
/* Renames DIR to DIR.old, then DIR.partial to DIR. */
ts_status ts_place_move(const ts_place *place);
/* Undoes what `placed` says was done. */
ts_status ts_place_undo(const ts_place *place, ts_placed placed);
/* True if there is anything at that path. */
bool ts_place_has(const char *path);

#endif
