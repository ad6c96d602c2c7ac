/* Sizes in headers of EXR, of files made here and of one that is written; cut at each byte, and with lies in them. */
#include <stdlib.h>
#include <string.h>
#include <touchstone/image.h>
#include "image/exr.h"
#include "tests/status.h"

static uint8_t file[1024];
static size_t n;

static void put(const void *bytes, size_t more)
{
	assert_true(n + more <= sizeof file);
	memcpy(file + n, bytes, more);
	n += more;
}

static void put_word(uint32_t word)
{
	const uint8_t bytes[4] = {(uint8_t)word, (uint8_t)(word >> 8), (uint8_t)(word >> 16), (uint8_t)(word >> 24)};
	put(bytes, sizeof bytes);
}

static void begin(uint32_t flags)
{
	n = 0;
	put_word(20000630);
	put_word(2 | flags);
}

static void put_head(const char *name, const char *type, uint32_t bytes)
{
	put(name, strlen(name) + 1);
	put(type, strlen(type) + 1);
	put_word(bytes);
}

/* A header of a part with that window. */
static void put_part(int32_t left, int32_t top, int32_t right, int32_t bottom)
{
	put_head("owner", "string", 3);
	put("abc", 3);
	put_head("dataWindow", "box2i", 16);
	put_word((uint32_t)left);
	put_word((uint32_t)top);
	put_word((uint32_t)right);
	put_word((uint32_t)bottom);
	put("", 1);
}

static void windows_have_both_ends(void **state)
{
	(void)state;
	begin(0);
	put_part(-3, 2, 4, 6);
	assert_int_equal(ts_exr_pixels(file, n), 8 * 5);
	put_part(0, 0, 9, 9); /* what is behind the only part is no header */
	assert_int_equal(ts_exr_pixels(file, n), 8 * 5);
	begin(0);
	put_part(INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX);
	assert_true(ts_exr_pixels(file, n) == UINT64_MAX);
	begin(0);
	put_part(5, 5, 4, 9);
	assert_int_equal(ts_exr_pixels(file, n), 0);
}

static void parts_are_added(void **state)
{
	(void)state;
	begin(0x1000);
	put_part(0, 0, 7, 4);
	put_part(0, 0, 99, 99);
	put("", 1);
	assert_int_equal(ts_exr_pixels(file, n), 40 + 10000);
	for (size_t cut = 0; cut < n; cut++) {
		uint8_t *exact = malloc(cut + 1);
		assert_non_null(exact);
		memcpy(exact, file, cut);
		const uint64_t pixels = ts_exr_pixels(exact, cut);
		assert_true(pixels == 0 || pixels == 40 || pixels == 10040);
		free(exact);
	}
}

static void chunks_are_listed_in_the_file(void **state)
{
	(void)state;
	begin(0);
	put_head("chunkCount", "int", 4);
	put_word(1 << 28);
	put_part(0, 0, 0, 0);
	assert_true(ts_exr_pixels(file, n) == UINT64_MAX);
}

static void what_is_written_says_its_size(void **state)
{
	(void)state;
	float pixels[7 * 5 * 3] = {0};
	void *written;
	size_t bytes;
	assert_int_equal(ts_image_encode_exr(&written, &bytes, pixels, 7, 5, 3, NULL, "a.exr"), TS_OK);
	assert_int_equal(ts_exr_pixels(written, bytes), 35);
	free(written);
}

/* Without room for what the header says: 400 bytes, 2^28 rows. */
static void more_than_the_bytes_justify_is_refused(void **state)
{
	(void)state;
	float *pixels;
	uint32_t width, height, channels;
	begin(0);
	put_part(0, 0, 0, (1 << 28) - 1);
	assert_int_equal(ts_image_read_bytes(&pixels, &width, &height, &channels, file, n, "a.exr"), TS_ERROR);
	says("a.exr: its header says 268435456 pixels; 1 to ");
	assert_null(pixels);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(windows_have_both_ends),
		cmocka_unit_test(parts_are_added),
		cmocka_unit_test(chunks_are_listed_in_the_file),
		cmocka_unit_test(what_is_written_says_its_size),
		cmocka_unit_test(more_than_the_bytes_justify_is_refused),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
