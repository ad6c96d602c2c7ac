/* The file of one buffer of a trace: its name, what kind of file it is, its header. */
#ifndef TS_TRACE_ITEM_H
#define TS_TRACE_ITEM_H
#include "read.h"

enum { TS_PATH = 4096 };

/* Where the file stands: in a folder that somebody else wrote, or where the user said. */
typedef enum {
	TS_IN_FOLDER, /* no link is followed: no way leads out of the folder */
	TS_OF_RUN,    /* the same; or a file of the scene that the traces of one run share. It may be compressed */
	TS_TYPED,     /* it may be compressed */
} ts_trust;

/* The path of file `name` of folder `dir`; refuses names that are hidden or lead elsewhere. */
ts_status ts_item_path(char path[TS_PATH], const char *dir, const char *name, ts_trust trust);
/* Opens a regular file, whose size is *bytes; -1 with the message set. A pipe or a device would block or never end. */
int ts_item_open(const char *path, ts_trust trust, u64 *bytes);

/* Gives the trace the .npy file `name` of its folder as its buffer `id`, which it must not have yet. */
ts_status ts_item_add(ts_trace *trace, ts_buffer_id id, const char *name, ts_trust trust);
/* Gives it a file of bare elements, whose first dimension follows from the size and whose others are those of `like`.
 */
ts_status ts_item_add_raw(ts_trace *trace, ts_buffer_id id, const char *name, const ts_npy *like);

/* The elements of a compressed file, which the first call unpacks. They belong to the trace. NULL with the message set
 * on failure. */
const void *ts_item_unpack(const ts_trace_item *item, ts_buffer_id id);

/* Gives it an array in memory, which must stay, in place of what it has. */
ts_status ts_item_put(ts_trace *trace, ts_buffer_id id, const ts_npy *shape, const void *data);

/* The same of a copy, which is the trace's. data NULL: of memory that is not set yet. */
ts_status ts_item_keep(ts_trace *trace, ts_buffer_id id, const ts_npy *shape, const void *data);

/* Releases what the item holds, which is as new then. */
void ts_item_clear(ts_trace_item *item);

/* Refuses a candidate's buffer of another crop than the reference's, or of other sizes that the frame fixes. */
ts_status ts_item_match(ts_buffer_id id, const ts_trace_item *reference, const ts_trace_item *candidate);

#endif
