/* Compressed files of traces: one frame of zstd each, whose header says how many bytes the frame holds. Files are
 * untrusted: a frame may need a window of at most 8 MiB, must hold exactly those bytes, and nothing may follow. */
#ifndef TS_TRACE_PACKED_H
#define TS_TRACE_PACKED_H
#include "../output/file.h"
#include "../kernels/base/compat.h"

#define TS_PACKED_SUFFIX ".zst"

/* True of the name of a compressed file. */
bool ts_packed_is(const char *name);

/* Writing: what turns bytes into a frame. */
typedef struct ZSTD_CCtx_s ts_packer;

/* Begins a frame of this many bytes; `path` is for the message. NULL with the message set; else by ts_packer_free. */
ts_packer *ts_packer_begin(u64 bytes, const char *path);
/* Writes the next bytes of the frame to the file. `last`: they end the frame, of as many bytes as were announced. */
ts_status ts_packer_put(ts_packer *packer, ts_file *file, const void *data, size_t bytes, bool last);
void ts_packer_free(ts_packer *packer);

/* Reads the first of the bytes that the file's frame holds: as many as fit into head_bytes, which says how many there
 * are afterwards. *held: all that the frame says it holds, which is never more than so large a file can. The descriptor
 * stays open. */
ts_status ts_packed_head(char *head, size_t *head_bytes, u64 *held, int descriptor, const char *path);

/* Unpacks the whole file. The first `skip` bytes, at most 65536, are passed over, and the `bytes` that follow must be
 * all others. */
ts_status ts_packed_read(void *to, size_t skip, size_t bytes, const char *path);

#endif
