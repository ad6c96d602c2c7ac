/* SHA-256 through libcrypto. */
#include "digest.h"
#include <assert.h>
#include <openssl/evp.h>
#include <stdio.h>

ts_status ts_digest_begin(ts_digest *digest)
{
	EVP_MD_CTX *context = EVP_MD_CTX_new();
	if (!context || EVP_DigestInit_ex(context, EVP_sha256(), NULL) != 1) {
		EVP_MD_CTX_free(context);
		digest->context = NULL;
		return ts_fail("libcrypto cannot start a SHA-256; is it out of memory?");
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
