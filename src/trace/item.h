/* The file of one buffer of a trace: its name, its kind and its header. */
#ifndef TS_TRACE_ITEM_H
#define TS_TRACE_ITEM_H
#include "trace/read.h"

enum { TS_PATH = 4096 };

/* How far a file's path is trusted: a name in a folder that somebody else wrote, or a path that the user typed. */
typedef enum {
	TS_IN_FOLDER, /* no link is followed, so that no path leads out of the folder */
	TS_OF_RUN,    /* as TS_IN_FOLDER, or of the scene that the traces of a run share. May be compressed */
	TS_TYPED,     /* a typed path; the file may be compressed */
} ts_trust;

/* The path of file `name` of folder `dir`; refuses names that are hidden or lead elsewhere. */
ts_status ts_item_path(char path[TS_PATH], const char *dir, const char *name, ts_trust trust);
/* Opens a regular file and sets *bytes to its size; -1 with the message set. Pipes and devices are refused, because
 * they could block or never end. */
int ts_item_open(const char *path, ts_trust trust, u64 *bytes);

/* Opens the item's file again; -1 with the message set. */
int ts_item_reopen(const ts_trace_item *item);

/* Gives the trace the .npy file `name` of its folder as its buffer `id`, which it must not have yet. */
ts_status ts_item_add(ts_trace *trace, ts_buffer_id id, const char *name, ts_trust trust);
/* As ts_item_add, for a file of bare elements: the first dimension follows from the size, the others are those of
 * `like`. */
ts_status ts_item_add_raw(ts_trace *trace, ts_buffer_id id, const char *name, const ts_npy *like);

/* The elements of a compressed file, which the first call unpacks. The memory belongs to the trace. NULL with the
 * message set on failure. */
const void *ts_item_unpack(const ts_trace_item *item, ts_buffer_id id);

/* Replaces a buffer of the trace by an array in memory, which must outlive the trace. */
ts_status ts_item_put(ts_trace *trace, ts_buffer_id id, const ts_npy *shape, const void *data);

/* As ts_item_put, with a copy that the trace owns. data NULL: memory of undefined content. */
ts_status ts_item_keep(ts_trace *trace, ts_buffer_id id, const ts_npy *shape, const void *data);

/* Releases the content of the item, which is then as new. */
void ts_item_clear(ts_trace_item *item);

/* Refuses a candidate's buffer whose crop, or whose sizes that are fixed for the frame, differ from the reference's. */
ts_status ts_item_match(ts_buffer_id id, const ts_trace_item *reference, const ts_trace_item *candidate);

#endif
