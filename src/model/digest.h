/* SHA-256 (FIPS 180-4). */
#ifndef TS_MODEL_DIGEST_H
#define TS_MODEL_DIGEST_H
#include <openssl/sha.h>
#include "model/core.h"

typedef struct {
	SHA256_CTX context;
	bool begun;
} ts_digest;

enum { TS_DIGEST_BYTES = 65 }; /* 64 hexadecimal digits and the end */

void ts_digest_begin(ts_digest *digest);
void ts_digest_add(ts_digest *digest, const void *data, size_t data_bytes);
/* The same of much data; fails, with a part added, where the work is cancelled. */
ts_status ts_digest_all(ts_digest *digest, const void *data, size_t data_bytes);
/* Writes the digest as 64 hexadecimal digits. */
void ts_digest_end(ts_digest *digest, char hex[TS_DIGEST_BYTES]);

#endif
