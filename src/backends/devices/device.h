/* Code that backends of devices share: launches, buffers of their pointers, parts, prefix sums. */
#ifndef TS_BACKENDS_DEVICES_DEVICE_H
#define TS_BACKENDS_DEVICES_DEVICE_H
#include "backends/devices/resident.h"

enum { TS_ARGUMENTS = 512 }; /* greatest size of a kernel's arguments, bytes */

/* The frame's buffer that a pointer among a launch's arguments points to, or into, and the offset; NULL: none. */
ts_buffer *ts_device_buffer(ts_frame *frame, const ts_launch *launch, const ts_pointer *pointer, const void *args,
                            u64 *offset);
/* How a launch accesses the buffer of a pointer. If it only reads, the host's copy stays valid. */
ts_access ts_device_access(const ts_launch *launch, const ts_pointer *pointer);

/* part_bytes for a launch, or for a buffer. From the first buffer on that a device cannot allocate at once, arrays that
 * may be parted are in parts of the largest power of two that it allocates. */
u64 ts_device_parts(const ts_store *store, u64 part_bytes, ts_frame *frame, const ts_launch *launch, const void *args);
u64 ts_device_parts_of(const ts_store *store, u64 part_bytes, const ts_buffer *buffer);

/* `launch` of a backend that enqueues at least one item by its own means. Points that are sorted by pieces are splatted
 * with one set-up per piece, since the kernels' language has no memory of groups. A device that ends loops gets points
 * one by one, and bands (kernels/base/band.h). */
typedef ts_status ts_enqueue(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n);
ts_status ts_device_launch(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n,
                           ts_enqueue *enqueue);

/* `scan` of a backend, by three kernels. */
ts_status ts_device_scan(ts_backend *backend, ts_frame *frame, ts_buffer_id id, u64 *total);

#endif
