/* SHA-256 (FIPS 180-4), of bytes and of the buffers of a run. */
#ifndef TS_CORE_DIGEST_H
#define TS_CORE_DIGEST_H
#include <stdio.h>
#include "frame.h"

typedef struct {
	void *context; /* NULL: not begun */
} ts_digest;

enum { TS_DIGEST_BYTES = 65 }; /* 64 hexadecimal digits and the end */

/* Begins a digest; ts_digest_end must follow. Fails without memory; then there is nothing to end. */
ts_status ts_digest_begin(ts_digest *digest);
void ts_digest_add(ts_digest *digest, const void *data, size_t data_bytes);
/* Writes the digest as text and releases it. With hex NULL it is only released. */
void ts_digest_end(ts_digest *digest, char *hex);

/* One digest a buffer, in the order in which the buffers first appeared. Zero-initialise. */
typedef struct {
	ts_digest digest[TS_N_BUFFERS];
	ts_buffer_id order[TS_N_BUFFERS];
	u32 n;
} ts_frame_digest;

/* Adds what a stage has just written: `ids` is ended by TS_N_BUFFERS or after n_ids. A buffer that is made in batches
 * counts as their concatenation; ids without a buffer in the frame are passed over. */
ts_status ts_frame_digest_add(ts_frame_digest *digests, const ts_frame *frame, const ts_buffer_id *ids, size_t n_ids);
/* Prints "<sha256>  <stage>.<buffer>" lines. */
void ts_frame_digest_print(ts_frame_digest *digests, FILE *out);
/* Releases what ts_frame_digest_print has not. */
void ts_frame_digest_clear(ts_frame_digest *digests);

#endif
