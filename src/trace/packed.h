/* Compressed files of traces: one frame of zstd each, whose header says how many bytes the frame holds. Files are
 * untrusted: a frame may need a window of at most 8 MiB, must hold exactly those bytes, and nothing may follow. */
#ifndef TS_TRACE_PACKED_H
#define TS_TRACE_PACKED_H
#include "kernels/base/compat.h"
#include "output/file.h"

#define TS_PACKED_SUFFIX ".zst"

/* True of the name of a compressed file. */
bool ts_packed_is(const char *name);

/* For writing: compresses bytes into a frame. */
typedef struct ZSTD_CCtx_s ts_packer;

/* Begins a frame of this many bytes; `path` is for the message. To be released by ts_packer_free. NULL with the message
 * set on failure. */
ts_packer *ts_packer_begin(u64 bytes, const char *path);
/* Compresses the next bytes and writes them to the file. `last`: they end the frame, which must have the announced
 * number of bytes. */
ts_status ts_packer_put(ts_packer *packer, ts_file *file, const void *data, size_t bytes, bool last);
void ts_packer_free(ts_packer *packer);

/* Unpacks the first bytes of the file's frame, at most *head_bytes, and sets *head_bytes to their number. Sets *held to
 * the size that the frame tells, checked to be no more than a file of this size can hold. The descriptor stays open. */
ts_status ts_packed_head(char *head, size_t *head_bytes, u64 *held, int descriptor, const char *path);

/* Unpacks the whole file, which must hold exactly skip + bytes bytes; the first `skip` of them, at most 65536, are
 * dropped. The descriptor stays open. */
ts_status ts_packed_read(void *to, size_t skip, size_t bytes, int descriptor, const char *path);

#endif
