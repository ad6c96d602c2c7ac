/* A frame's buffers on a device, for backends with memory of their own: one part of all a buffer's bytes, or as many
 * parts of part_bytes as it needs; and where the newest contents are. */
#ifndef TS_BACKENDS_RESIDENT_H
#define TS_BACKENDS_RESIDENT_H
#include "backend.h"

enum { TS_PARTS = 8, TS_FAILURE = 512 };

/* What a backend does with one part. Calls take effect in the order in which they are made; those that fail set the
 * message. */
typedef struct ts_store ts_store;
struct ts_store {
	const ts_device *about;
	bool unified;             /* parts are the host's memory: they are mapped while the host looks */
	bool busy;                /* something was enqueued and not waited for */
	char failure[TS_FAILURE]; /* the first that a fetch or a release had to keep to itself */
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

/* The parts of the device's copy of a buffer, made and brought up to date if need be, for what reads it, may write
 * it too, or writes all of it. part_bytes 0: it is in one. Parts that the buffer does not have are NULL. */
ts_status ts_store_use(ts_store *store, void *parts[TS_PARTS], ts_buffer *buffer, u64 part_bytes, ts_access access);
/* Waits for all of it, and tells what was kept. */
ts_status ts_store_finish(ts_store *store);
extern const ts_residence ts_store_residence;

#endif
