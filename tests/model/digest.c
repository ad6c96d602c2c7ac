/* SHA-256 against the published examples (FIPS 180-4, NIST). */
#include "model/digest.h"
#include "tests/model/test.h"

static void digest_is(const char *text, size_t times, const char *expected)
{
	ts_digest digest;
	char hex[TS_DIGEST_BYTES];
	ts_digest_begin(&digest);
	for (size_t i = 0; i < times; i++) ts_digest_add(&digest, text, strlen(text));
	ts_digest_end(&digest, hex);
	assert_string_equal(hex, expected);
	assert_false(digest.begun);
}

static void digests_match_the_published_examples(void **state)
{
	(void)state;
	digest_is("", 1, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
	digest_is("abc", 1, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
	digest_is("a", 1000000, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

int main(void)
{
	const struct CMUnitTest digest[] = {
		cmocka_unit_test(digests_match_the_published_examples),
	};
	return cmocka_run_group_tests(digest, NULL, NULL);
}
