/* Folders that take the place of others. */
#ifndef TS_OUTPUT_PLACE_H
#define TS_OUTPUT_PLACE_H
#include "../model/core.h"

typedef struct {
	const char *dir, *partial, *old;
} ts_place;

/* What became of DIR. */
typedef enum {
	TS_PLACE_FREE,      /* nothing was there, or an empty folder */
	TS_PLACE_EXCHANGED, /* it is DIR.partial now */
	TS_PLACE_MOVED,     /* it is DIR.old now */
} ts_placed;

/* Renames DIR.partial to DIR, where nothing is, or an empty folder. TS_DIFFERENT: something is there. */
ts_status ts_place_take(const ts_place *place);
/* DIR and DIR.partial change places. TS_DIFFERENT: the file system cannot do that. */
ts_status ts_place_exchange(const ts_place *place);
/* Renames DIR to DIR.old, then DIR.partial to DIR. */
ts_status ts_place_move(const ts_place *place);
/* Takes it back. */
ts_status ts_place_undo(const ts_place *place, ts_placed placed);
/* True if there is anything at that path. */
bool ts_place_has(const char *path);

#endif
