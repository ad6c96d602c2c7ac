/* PNG files: each kind is decoded as the specification says, what is written is whole, and memory that ends says so. */
#define _GNU_SOURCE /* memmem */
#include <sys/resource.h>
#include <touchstone/image.h>
#include <zlib.h>
#include "image/png.h"
#include "kernels/base/num.h"
#include "tests/status.h"

enum { WIDTH = 13, HEIGHT = 6, PIXELS = WIDTH * HEIGHT, MOST = 16384 };

/* Samples of a picture, as they stand in the file. */
typedef struct {
	u32 colour, depth, channels; /* as in IHDR; samples a pixel */
	bool transparent;            /* has tRNS: half of the palette; else the colour of the first pixel */
	u32 sample[PIXELS][4];
} picture;

typedef struct {
	uint8_t bytes[MOST];
	size_t n;
} text;

static void put(text *t, const void *data, size_t n)
{
	assert_true(t->n + n <= MOST);
	memcpy(t->bytes + t->n, data, n);
	t->n += n;
}

static void put_number(text *t, u32 value, u32 bytes)
{
	for (u32 i = bytes; i-- > 0;) put(t, (const uint8_t[]){(uint8_t)(value >> 8 * i)}, 1);
}

static void put_chunk(text *t, const char *type, const text *data)
{
	put_number(t, (u32)data->n, 4);
	size_t begin = t->n;
	put(t, type, 4);
	put(t, data->bytes, data->n);
	put_number(t, (u32)crc32(0, t->bytes + begin, (uInt)(t->n - begin)), 4);
}

static u32 of_palette(u32 index, u32 channel) { return ts_random(index, channel, 3) % 256; }

/* Rows, or those of the seven passes. */
static text rows_of(const picture *p, bool interlaced)
{
	static const u32 from[7][2] = {{0, 0}, {4, 0}, {0, 4}, {2, 0}, {0, 2}, {1, 0}, {0, 1}};
	static const u32 step[7][2] = {{8, 8}, {8, 8}, {4, 8}, {4, 4}, {2, 4}, {2, 2}, {1, 2}};
	text t = {.n = 0};
	for (u32 pass = 0; pass < (interlaced ? 7 : 1); pass++) {
		const u32 x0 = interlaced ? from[pass][0] : 0, y0 = interlaced ? from[pass][1] : 0;
		const u32 dx = interlaced ? step[pass][0] : 1, dy = interlaced ? step[pass][1] : 1;
		for (u32 y = y0; y < HEIGHT; y += dy) {
			u32 bits = 0, held = 0;
			if (x0 >= WIDTH) continue;
			put_number(&t, 0, 1);
			for (u32 x = x0; x < WIDTH; x += dx) {
				for (u32 c = 0; c < p->channels; c++) {
					u32 sample = p->sample[y * WIDTH + x][c];
					if (p->depth >= 8) put_number(&t, sample, p->depth / 8);
					if (p->depth >= 8) continue;
					held = held << p->depth | sample;
					bits += p->depth;
					if (bits == 8) put_number(&t, held, 1);
					if (bits == 8) bits = 0;
				}
			}
			if (bits > 0) put_number(&t, held << (8 - bits), 1);
		}
	}
	return t;
}

static text file_of(const picture *p, bool interlaced)
{
	text t = {.n = 0}, header = {.n = 0}, palette = {.n = 0}, alpha = {.n = 0}, data = {.n = MOST};
	put(&t, "\x89PNG\r\n\x1a\n", 8);
	put_number(&header, WIDTH, 4);
	put_number(&header, HEIGHT, 4);
	put(&header, (const uint8_t[]){(uint8_t)p->depth, (uint8_t)p->colour, 0, 0, interlaced}, 5);
	put_chunk(&t, "IHDR", &header);
	for (u32 i = 0; i < 3u << p->depth && p->colour == 3; i++) put_number(&palette, of_palette(i / 3, i % 3), 1);
	if (p->colour == 3) put_chunk(&t, "PLTE", &palette);
	for (u32 i = 0; i < 1u << p->depth >> 1 && p->colour == 3; i++) put_number(&alpha, of_palette(i, 3), 1);
	for (u32 c = 0; c < p->channels && p->colour != 3; c++) put_number(&alpha, p->sample[0][c], 2);
	if (p->transparent) put_chunk(&t, "tRNS", &alpha);
	const text rows = rows_of(p, interlaced);
	uLongf n = MOST;
	assert_int_equal(compress(data.bytes, &n, rows.bytes, (uLong)rows.n), Z_OK);
	data.n = n;
	put_chunk(&t, "IDAT", &data);
	put_chunk(&t, "IEND", &(const text){.n = 0});
	return t;
}

/* Channel c of RGBA, in codes of 8 bits, or of 16 where the file has them. */
static u32 code_of(const picture *p, u32 pixel, u32 c)
{
	const u32 *s = p->sample[pixel], full = (1u << p->depth) - 1, one = p->depth == 16 ? 65535 : 255;
	if (p->colour == 3) return c < 3 || (p->transparent && s[0] < 1u << p->depth >> 1) ? of_palette(s[0], c) : 255;
	bool grey = p->channels < 3;
	if (c < 3) return s[grey ? 0 : c] * one / full;
	if (p->channels % 2 == 0) return s[p->channels - 1];
	return p->transparent && memcmp(s, p->sample[0], p->channels * sizeof *s) == 0 ? 0 : one;
}

static void check(const picture *p, bool interlaced)
{
	const text file = file_of(p, interlaced);
	uint8_t *rgba;
	float *floats;
	u32 width, height, channels;
	const bool grey = p->channels < 3 && p->colour != 3, alpha = p->transparent || (p->channels % 2 == 0);
	require(ts_image_decode(&rgba, &width, &height, file.bytes, file.n, PIXELS, "made"));
	assert_true(width == WIDTH && height == HEIGHT);
	require(ts_image_read_bytes(&floats, &width, &height, &channels, file.bytes, file.n, "made"));
	assert_int_equal(channels, (grey ? 1 : 3) + alpha);
	for (u32 i = 0; i < 4 * PIXELS; i++) {
		const u32 code = code_of(p, i / 4, i % 4), c = i % 4;
		assert_int_equal(rgba[i], p->depth == 16 ? (code * 255 + 32767) / 65535 : code);
		if ((c > 0 && c < 3 && grey) || (c == 3 && !alpha)) continue;
		const float found = floats[i / 4 * channels + (c == 3 ? channels - 1 : c)];
		assert_true(found == (float)code / (p->depth == 16 ? 65535.0f : 255.0f));
	}
	free(rgba);
	free(floats);
}

static void each_kind_is_decoded(void **state)
{
	static const u32 kinds[][2] = {{0, 1}, {0, 2}, {0, 4}, {0, 8}, {0, 16}, {2, 8}, {2, 16}, {3, 1},
	                               {3, 2}, {3, 4}, {3, 8}, {4, 8}, {4, 16}, {6, 8}, {6, 16}};
	static const u32 channels[7] = {1, 0, 3, 1, 2, 0, 4};
	(void)state;
	for (u32 i = 0; i < 4 * sizeof kinds / sizeof *kinds; i++) {
		const u32 *kind = kinds[i / 4];
		picture p = {.colour = kind[0], .depth = kind[1], .channels = channels[kind[0]], .transparent = i % 2 == 1};
		if (p.transparent && p.colour > 3) continue;
		for (u32 k = 0; k < 4 * PIXELS; k++) p.sample[k / 4][k % 4] = ts_random(k, i, 5) & ((1u << p.depth) - 1);
		check(&p, i / 2 % 2 == 1);
	}
}

static void what_is_written_has_its_texts(void **state)
{
	(void)state;
	static const ts_image_text texts[] = {{"Software", "touchstone"}, {"touchstone:scene", "a b"}, {NULL, NULL}};
	uint8_t pixels[PIXELS * 4];
	for (u32 i = 0; i < sizeof pixels; i++) pixels[i] = (uint8_t)ts_random(i, 0, 9);
	for (u32 channels = 1; channels <= 4; channels++) {
		void *file;
		size_t n;
		uint8_t *rgba;
		u32 width, height;
		if (channels == 2) continue;
		require(ts_image_encode_png(&file, &n, pixels, WIDTH, HEIGHT, channels, texts, "made"));
		assert_non_null(memmem(file, n, "tEXtSoftware\0touchstone", 23));
		assert_non_null(memmem(file, n, "tEXttouchstone:scene\0a b", 24));
		require(ts_image_decode(&rgba, &width, &height, file, n, PIXELS, "made"));
		for (u32 i = 0; i < PIXELS; i++) assert_memory_equal(rgba + 4 * i, pixels + i * channels, channels);
		free(rgba);
		free(file);
	}
	void *file;
	size_t n;
	const ts_image_text unnamed[] = {{"", "text"}, {NULL, NULL}};
	assert_int_equal(ts_image_encode_png(&file, &n, pixels, WIDTH, HEIGHT, 3, unnamed, "made"), TS_ERROR);
	assert_null(file);
}

/* A picture of which the rows are larger than what is left. */
static void without_memory_a_line_says_so(void **state)
{
	(void)state;
	enum { SIDE = 8192 };
	struct rlimit usual, little;
	void *file = NULL;
	size_t n = 0;
	uint8_t *pixels = calloc(SIDE, SIDE), *rgba;
	u32 width, height;
	if (TS_TEST_SANITIZED) skip();
	require(ts_image_encode_png(&file, &n, pixels, SIDE, SIDE, 1, NULL, "made"));
	free(pixels);
	assert_int_equal(getrlimit(RLIMIT_AS, &usual), 0);
	little = (struct rlimit){1, usual.rlim_max};
	assert_int_equal(setrlimit(RLIMIT_AS, &little), 0);
	ts_png image;
	ts_status read = ts_png_read(&image, file, n, "made");
	ts_status decoded = ts_image_decode(&rgba, &width, &height, file, n, (u64)SIDE * SIDE, "made");
	assert_int_equal(setrlimit(RLIMIT_AS, &usual), 0);
	assert_true(read == TS_ERROR && decoded == TS_ERROR);
	assert_int_equal(ts_error_kind(), TS_KIND_MEMORY);
	assert_null(image.codes);
	assert_null(rgba);
	free(file);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_kind_is_decoded),
		cmocka_unit_test(what_is_written_has_its_texts),
		cmocka_unit_test(without_memory_a_line_says_so),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
