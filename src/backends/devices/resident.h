/* A frame's buffers on a device, for backends with memory of their own. A buffer has one part, or as many parts of
 * part_bytes as it needs; and a mark of where its newest contents are. */
#ifndef TS_BACKENDS_DEVICES_RESIDENT_H
#define TS_BACKENDS_DEVICES_RESIDENT_H
#include "backends/backend.h"

enum { TS_PARTS = 8, TS_FAILURE = 512 };

/* The operations of a backend on one part. Calls take effect in the order in which they are made; a call that fails
 * sets the message. */
typedef struct ts_store ts_store;
struct ts_store {
	const ts_device *about;
	bool unified;             /* parts are in the host's memory: they are mapped while the host reads */
	bool busy;                /* work was enqueued and not waited for */
	char failure[TS_FAILURE]; /* the first failure that a fetch or a release could not report */
	/* NULL: it failed. `data` is the host's memory, of which a unified store makes the part. */
	void *(*make)(ts_store *store, void *data, u64 bytes);
	void (*free)(ts_store *store, void *part);
	ts_status (*upload)(ts_store *store, void *part, const void *data, u64 bytes);
	/* Waits. A unified store maps the part. */
	ts_status (*download)(ts_store *store, void *part, void *data, u64 bytes);
	ts_status (*unmap)(ts_store *store, void *part, void *data); /* NULL if no store is unified */
	ts_status (*wait)(ts_store *store);
};

typedef enum { TS_READS, TS_WRITES, TS_OVERWRITES } ts_access;

/* The parts of the device's copy of a buffer, made and updated if needed, for a launch that reads it, may also write
 * it, or writes all of it. part_bytes 0: one part. Parts that the buffer does not have are NULL. */
ts_status ts_store_use(ts_store *store, void *parts[TS_PARTS], ts_buffer *buffer, u64 part_bytes, ts_access access);
/* Waits for all work, and reports a failure that was kept. */
ts_status ts_store_finish(ts_store *store);
extern const ts_residence ts_store_residence;

#endif
