/* SHA-256 (FIPS 180-4). */
#ifndef TS_CORE_DIGEST_H
#define TS_CORE_DIGEST_H
#include "core.h"

typedef struct {
	void *context; /* NULL: not begun */
} ts_digest;

enum { TS_DIGEST_BYTES = 65 }; /* 64 hexadecimal digits and the end */

/* Begins a digest; ts_digest_end must follow. Fails without memory; then there is nothing to end. */
ts_status ts_digest_begin(ts_digest *digest);
void ts_digest_add(ts_digest *digest, const void *data, size_t data_bytes);
/* Writes the digest as text and releases it. With hex NULL it is only released. */
void ts_digest_end(ts_digest *digest, char *hex);

#endif
