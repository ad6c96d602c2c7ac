/* SHA-256 through libcrypto. */
#include "digest.h"
#include <assert.h>
#include <openssl/evp.h>

ts_status ts_digest_begin(ts_digest *digest)
{
	EVP_MD_CTX *context = EVP_MD_CTX_new();
	if (!context || EVP_DigestInit_ex(context, EVP_sha256(), NULL) != 1) {
		EVP_MD_CTX_free(context);
		digest->context = NULL;
		return ts_fail("libcrypto cannot start a SHA-256");
	}
	digest->context = context;
	return TS_OK;
}

void ts_digest_add(ts_digest *digest, const void *data, size_t data_bytes)
{
	int good = EVP_DigestUpdate(digest->context, data, data_bytes);
	assert(good == 1);
}

void ts_digest_end(ts_digest *digest, char *hex)
{
	if (hex) {
		unsigned char raw[EVP_MAX_MD_SIZE];
		unsigned raw_bytes = 0;
		int good = EVP_DigestFinal_ex(digest->context, raw, &raw_bytes);
		assert(good == 1 && raw_bytes == 32);
		for (unsigned i = 0; i < raw_bytes; i++) snprintf(hex + 2 * i, 3, "%02x", raw[i]);
	}
	EVP_MD_CTX_free(digest->context);
	digest->context = NULL;
}

ts_status ts_frame_digest_add(ts_frame_digest *digests, const ts_frame *frame, const ts_buffer_id *ids, size_t n_ids)
{
	for (size_t i = 0; i < n_ids && ids[i] < TS_N_BUFFERS; i++) {
		const ts_buffer *buffer = &frame->buffer[ids[i]];
		ts_digest *digest = &digests->digest[ids[i]];
		if (!buffer->made) continue;
		if (!digest->context) {
			ts_status status = ts_digest_begin(digest);
			if (status) return status;
			digests->order[digests->n++] = ids[i];
		}
		ts_digest_add(digest, buffer->data, (size_t)buffer->n * ts_buffer_table[ids[i]].element_bytes);
	}
	return TS_OK;
}

void ts_frame_digest_print(ts_frame_digest *digests, FILE *out)
{
	for (u32 i = 0; i < digests->n; i++) {
		char hex[TS_DIGEST_BYTES];
		ts_digest_end(&digests->digest[digests->order[i]], hex);
		fprintf(out, "%s  %s\n", hex, ts_buffer_table[digests->order[i]].name);
	}
	digests->n = 0;
}

void ts_frame_digest_clear(ts_frame_digest *digests)
{
	for (u32 i = 0; i < digests->n; i++) ts_digest_end(&digests->digest[digests->order[i]], NULL);
	digests->n = 0;
}
