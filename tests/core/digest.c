/* SHA-256 against the published examples (FIPS 180-4, NIST), and digests of buffers made in batches. */
#include "test.h"
#include "../../src/core/digest.h"

static void digest_is(const char *text, size_t times, const char *expected)
{
	ts_digest digest;
	char hex[TS_DIGEST_BYTES];
	assert_int_equal(ts_digest_begin(&digest), TS_OK);
	for (size_t i = 0; i < times; i++) ts_digest_add(&digest, text, strlen(text));
	ts_digest_end(&digest, hex);
	assert_string_equal(hex, expected);
	assert_null(digest.context);
}

static void published_examples(void **state)
{
	(void)state;
	digest_is("", 1, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
	digest_is("abc", 1, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
	digest_is("a", 1000000, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

static void fill(ts_frame *frame, u64 from, u64 to)
{
	u64 *keys = ts_frame_make1(frame, TS_B_points_key, to - from);
	assert_non_null(keys);
	for (u64 i = from; i < to; i++) keys[i - from] = i * i;
}

static void digest_of_keys(char *line, size_t line_bytes, const u64 *cuts, size_t n_cuts)
{
	const ts_buffer_id ids[6] = {TS_B_points_key, TS_B_points_record, TS_N_BUFFERS};
	ts_frame frame = {0};
	ts_frame_digest digests = {0};
	for (size_t i = 0; i + 1 < n_cuts; i++) {
		fill(&frame, cuts[i], cuts[i + 1]);
		assert_int_equal(ts_frame_digest_add(&digests, &frame, ids, 6), TS_OK);
	}
	FILE *out = tmpfile();
	assert_non_null(out);
	ts_frame_digest_print(&digests, out);
	rewind(out);
	assert_non_null(fgets(line, (int)line_bytes, out));
	assert_int_equal(fgetc(out), EOF);
	fclose(out);
	ts_frame_digest_clear(&digests);
	ts_frame_clear(&frame);
}

static void batches_concatenate(void **state)
{
	(void)state;
	char whole[200], parts[200], other[200];
	digest_of_keys(whole, sizeof whole, (u64[]){0, 1000}, 2);
	digest_of_keys(parts, sizeof parts, (u64[]){0, 1, 1, 500, 1000}, 5);
	digest_of_keys(other, sizeof other, (u64[]){0, 999}, 2);
	assert_string_equal(whole, parts);
	assert_string_not_equal(whole, other);
	assert_string_equal(whole + 64, "  points.key\n");
}

static void unprinted_digests_are_released(void **state)
{
	(void)state;
	ts_frame frame = {0};
	ts_frame_digest digests = {0};
	const ts_buffer_id id = TS_B_points_key;
	fill(&frame, 0, 10);
	assert_int_equal(ts_frame_digest_add(&digests, &frame, &id, 1), TS_OK);
	ts_frame_digest_clear(&digests);
	assert_int_equal(digests.n, 0);
	assert_null(digests.digest[id].context);
	ts_frame_clear(&frame);
}

int main(void)
{
	const struct CMUnitTest digest[] = {
		cmocka_unit_test(published_examples),
		cmocka_unit_test(batches_concatenate),
		cmocka_unit_test(unprinted_digests_are_released),
	};
	return cmocka_run_group_tests(digest, NULL, NULL);
}
