/* PNG files from strangers: every legal kind passes, and no damage does. */
#include <touchstone/image.h>
#include <zlib.h>
#include "image/png.h"
#include "kernels/base/num.h"
#include "tests/status.h"

enum { WIDTH = 11, HEIGHT = 9, MOST = 8192 };

typedef struct {
	uint8_t bytes[MOST];
	size_t n;
} file;

/* What is written into a PNG. */
typedef struct {
	uint8_t colour, depth, interlaced, filter;
	uint32_t filtered_row;       /* the row that `filter` is of; 0: all are */
	uint32_t n_palette, n_alpha; /* bytes; 0: no chunk */
	int more;                    /* bytes of pixels too many, or too few */
	uint32_t after;              /* bytes behind the compressed stream */
	bool comment;
	const char *extra; /* a chunk behind the header, of n_extra bytes; NULL: none */
	uint32_t n_extra;
} kind;

static void put(file *f, const void *data, size_t n)
{
	assert_true(f->n + n <= MOST);
	if (n != 0) memcpy(f->bytes + f->n, data, n);
	f->n += n;
}

static void put_number(file *f, uint32_t value)
{
	for (int i = 3; i >= 0; i--) put(f, (const uint8_t[]){(uint8_t)(value >> 8 * i)}, 1);
}

static void put_chunk(file *f, const char *type, const void *data, size_t n)
{
	put_number(f, (uint32_t)n);
	size_t start = f->n;
	put(f, type, 4);
	put(f, data, n);
	put_number(f, (uint32_t)crc32(0, f->bytes + start, (uInt)(f->n - start)));
}

/* Rows of random pixels, their filter bytes first; the passes by counting pixels one by one. */
static size_t pixels(uint8_t *raw, const kind *k)
{
	static const char adam7[8][9] = {"16462646", "77777777", "56565656", "77777777",
	                                 "36463646", "77777777", "56565656", "77777777"};
	const uint32_t channels[7] = {1, 0, 3, 1, 2, 0, 4};
	size_t n = 0;
	for (char pass = '1'; pass <= (k->interlaced ? '7' : '1'); pass++) {
		for (uint32_t y = 0; y < HEIGHT; y++) {
			uint32_t across = k->interlaced ? 0 : WIDTH;
			for (uint32_t x = 0; k->interlaced && x < WIDTH; x++) across += adam7[y % 8][x % 8] == pass;
			if (across == 0) continue;
			raw[n++] = k->filtered_row == 0 || k->filtered_row == y ? k->filter : 0;
			for (uint32_t i = 0; i < (across * channels[k->colour] * k->depth + 7) / 8; i++, n++)
				raw[n] = (uint8_t)ts_random((u32)n, 6, k->depth);
		}
	}
	return n;
}

static file make(kind k)
{
	static const uint8_t zeros[1024];
	uint8_t raw[2048], packed[4096];
	uLongf n_packed = sizeof packed - k.after;
	file f = {.n = 0};
	size_t n = pixels(raw, &k);
	assert_int_equal(compress(packed, &n_packed, raw, (uLong)((long)n + k.more)), Z_OK);
	put(&f, "\x89PNG\r\n\x1a\n", 8);
	const uint8_t header[13] = {0, 0, 0, WIDTH, 0, 0, 0, HEIGHT, k.depth, k.colour, 0, 0, k.interlaced};
	put_chunk(&f, "IHDR", header, 13);
	if (k.comment) put_chunk(&f, "iCCP", "not a profile", 13);
	if (k.extra != NULL) put_chunk(&f, k.extra, zeros, k.n_extra);
	if (k.n_palette != 0) put_chunk(&f, "PLTE", zeros, k.n_palette);
	if (k.n_alpha != 0) put_chunk(&f, "tRNS", zeros, k.n_alpha);
	memset(packed + n_packed, 0, k.after);
	put_chunk(&f, "IDAT", packed, 5);
	put_chunk(&f, "IDAT", packed + 5, n_packed - 5 + k.after);
	put_chunk(&f, "IEND", "", 0);
	return f;
}

static ts_status clean_of(const file *f, uint8_t **clean, size_t *n)
{
	return ts_png_clean(clean, n, f->bytes, f->n, "picture");
}

static void refuse(kind k, const char *words)
{
	uint8_t *clean;
	size_t n;
	file f = make(k);
	assert_int_equal(clean_of(&f, &clean, &n), TS_ERROR);
	assert_null(clean);
	says(words);
}

/* Cleaning twice is cleaning once, and the decoder agrees that the file is good. */
static void accept(kind k)
{
	uint8_t *once, *twice, *rgba;
	size_t n_once, n_twice;
	uint32_t width, height;
	file f = make(k);
	if (clean_of(&f, &once, &n_once) != TS_OK)
		fail_msg("colour %u depth %u: %s", k.colour, k.depth, ts_error_message());
	assert_int_equal(ts_png_clean(&twice, &n_twice, once, n_once, "picture"), TS_OK);
	assert_int_equal(n_once, n_twice);
	assert_memory_equal(once, twice, n_once);
	assert_int_equal(ts_image_decode(&rgba, &width, &height, f.bytes, f.n, WIDTH * HEIGHT, "picture"), TS_OK);
	assert_true(width == WIDTH && height == HEIGHT);
	free(once);
	free(twice);
	free(rgba);
}

static void every_legal_kind_is_accepted(void **state)
{
	(void)state;
	static const uint8_t depths[7] = {1 | 2 | 4 | 8 | 16, 0, 8 | 16, 1 | 2 | 4 | 8, 8 | 16, 0, 8 | 16};
	for (uint8_t colour = 0; colour <= 6; colour++) {
		for (uint8_t depth = 1; depth <= 16; depth = (uint8_t)(depth * 2)) {
			for (uint8_t interlaced = 0; interlaced < 2; interlaced++) {
				kind k = {.colour = colour, .depth = depth, .interlaced = interlaced, .filter = 4};
				if (colour == 1 || colour == 5) continue;
				if (colour == 3) k.n_palette = 6;
				if ((depths[colour] & depth) != 0)
					accept(k);
				else
					refuse(k, "colour type");
			}
		}
	}
}

static void wrong_chunks_are_refused(void **state)
{
	(void)state;
	accept((kind){.colour = 2, .depth = 8, .n_alpha = 6, .n_palette = 9, .comment = true, .after = 100});
	accept((kind){.colour = 3, .depth = 2, .n_palette = 12, .n_alpha = 4});
	refuse((kind){.colour = 3, .depth = 2, .n_palette = 15}, "palette");
	refuse((kind){.colour = 3, .depth = 2, .n_palette = 11}, "palette");
	refuse((kind){.colour = 3, .depth = 2}, "palette");
	refuse((kind){.colour = 3, .depth = 2, .n_palette = 6, .n_alpha = 3}, "transparency");
	refuse((kind){.colour = 2, .depth = 8, .n_alpha = 5}, "transparency");
	refuse((kind){.colour = 3, .depth = 2, .n_palette = 12, .extra = "PLTE"}, "palette has a wrong size");
	refuse((kind){.colour = 2, .depth = 8, .extra = "ABCd", .n_extra = 4}, "an unknown chunk that must be understood");
	accept((kind){.colour = 2, .depth = 8, .extra = "aBCd", .n_extra = 4});
}

/* The cleaned file has these chunks alone, in this order, with what was in them. */
static void cleaned_to(kind k, const char *const *types)
{
	static const uint8_t zeros[1024];
	uint8_t *clean;
	size_t n, at = 8;
	file f = make(k);
	assert_int_equal(clean_of(&f, &clean, &n), TS_OK);
	for (; *types != NULL; types++) {
		size_t bytes =
			(size_t)clean[at] << 24 | (size_t)clean[at + 1] << 16 | (size_t)clean[at + 2] << 8 | clean[at + 3];
		assert_memory_equal(clean + at + 4, *types, 4);
		if (strcmp(*types, "PLTE") == 0) assert_int_equal(bytes, k.n_palette);
		if (strcmp(*types, "tRNS") == 0) assert_int_equal(bytes, k.n_alpha);
		if (strcmp(*types, "PLTE") == 0 || strcmp(*types, "tRNS") == 0)
			assert_memory_equal(clean + at + 8, zeros, bytes);
		at += bytes + 12;
	}
	assert_int_equal(at, n);
	free(clean);
}

static void cleaning_keeps_the_needed_chunks(void **state)
{
	(void)state;
	cleaned_to((kind){.colour = 3, .depth = 2, .n_palette = 12, .n_alpha = 4, .comment = true},
	           (const char *const[]){"IHDR", "PLTE", "tRNS", "IDAT", "IEND", NULL});
	cleaned_to((kind){.colour = 2, .depth = 8, .n_palette = 9, .n_alpha = 6, .after = 50},
	           (const char *const[]){"IHDR", "tRNS", "IDAT", "IEND", NULL});
	cleaned_to((kind){.colour = 0, .depth = 8, .n_alpha = 2},
	           (const char *const[]){"IHDR", "tRNS", "IDAT", "IEND", NULL});
	cleaned_to((kind){.colour = 6, .depth = 8}, (const char *const[]){"IHDR", "IDAT", "IEND", NULL});
}

static void wrong_rows_of_pixels_are_refused(void **state)
{
	(void)state;
	for (uint8_t interlaced = 0; interlaced < 2; interlaced++) {
		refuse((kind){.colour = 6, .depth = 8, .interlaced = interlaced, .more = 1}, "more than");
		refuse((kind){.colour = 6, .depth = 8, .interlaced = interlaced, .more = -1}, "missing");
		refuse((kind){.colour = 6, .depth = 8, .interlaced = interlaced, .filter = 5}, "filter");
		refuse((kind){.colour = 6, .depth = 8, .interlaced = interlaced, .filter = 5, .filtered_row = HEIGHT - 1},
		       "filter");
	}
}

/* Any byte changed, anywhere behind the signature, and any cut. */
static void any_damage_is_refused(void **state)
{
	(void)state;
	uint8_t *clean;
	size_t n;
	file whole = make((kind){.colour = 3, .depth = 4, .interlaced = 1, .n_palette = 48, .n_alpha = 5, .comment = true});
	for (size_t i = 8; i < whole.n; i++) {
		file f = whole;
		f.bytes[i] ^= (uint8_t)(1u << (i % 8));
		assert_int_equal(clean_of(&f, &clean, &n), TS_ERROR);
		assert_null(clean);
		f = whole;
		f.n = i;
		assert_int_equal(clean_of(&f, &clean, &n), TS_ERROR);
		assert_null(clean);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_legal_kind_is_accepted),
		cmocka_unit_test(wrong_chunks_are_refused),
		cmocka_unit_test(cleaning_keeps_the_needed_chunks),
		cmocka_unit_test(wrong_rows_of_pixels_are_refused),
		cmocka_unit_test(any_damage_is_refused),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
