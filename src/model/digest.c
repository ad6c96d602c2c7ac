/* SHA-256 through libcrypto, by the calls that do not allocate: those that OpenSSL 3 prefers crash without memory. */
#define OPENSSL_SUPPRESS_DEPRECATED
#include "model/digest.h"
#include <stdio.h>

void ts_digest_begin(ts_digest *digest)
{
	SHA256_Init(&digest->context);
	digest->begun = true;
}

void ts_digest_add(ts_digest *digest, const void *data, size_t data_bytes)
{
	SHA256_Update(&digest->context, data, data_bytes);
}

ts_status ts_digest_all(ts_digest *digest, const void *data, size_t data_bytes)
{
	enum { PART = 1 << 20 };
	ts_stop *stop = ts_stop_here();
	for (size_t at = 0; at < data_bytes && !ts_stopped(stop); at += PART)
		ts_digest_add(digest, (const char *)data + at, data_bytes - at < PART ? data_bytes - at : PART);
	return ts_go_on();
}

void ts_digest_end(ts_digest *digest, char hex[TS_DIGEST_BYTES])
{
	unsigned char raw[SHA256_DIGEST_LENGTH];
	SHA256_Final(raw, &digest->context);
	for (int i = 0; i < SHA256_DIGEST_LENGTH; i++) snprintf(hex + 2 * i, 3, "%02x", raw[i]);
	digest->begun = false;
}
