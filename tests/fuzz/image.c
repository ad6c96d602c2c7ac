/* libFuzzer on image files: `make fuzz`. Each input is decoded in memory, as a texture of a scene is, and read as a
 * file, as an image to compare is; a PNG as it is or, after an even last byte, with right checksums, without which
 * nothing behind them would be reached. All pixels of what is taken are there. */
#include <touchstone/image.h>
#include <zlib.h>
#include "tests/fuzz/folder.h"

enum { MOST_TEXELS = 1 << 20, SIGNATURE = 8, FRAME = 12 };
static const char *path;
static volatile uint32_t sum;

static uint32_t number(const uint8_t *p) { return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | p[2] << 8 | p[3]; }

static void put_checksums(uint8_t *png, size_t n)
{
	for (size_t at = SIGNATURE; n >= FRAME && at <= n - FRAME && number(png + at) <= n - at - FRAME;) {
		uint32_t bytes = number(png + at), sum_of = (uint32_t)crc32(0, png + at + 4, bytes + 4);
		for (int i = 0; i < 4; i++) png[at + 8 + bytes + (size_t)i] = (uint8_t)(sum_of >> (24 - 8 * i));
		at += FRAME + (size_t)bytes;
	}
}

static void touch(const void *pixels, size_t bytes)
{
	for (size_t i = 0; i < bytes; i++) sum += ((const uint8_t *)pixels)[i];
}

static void decode(const uint8_t *data, size_t n)
{
	uint8_t *rgba;
	uint32_t width, height;
	if (ts_image_decode(&rgba, &width, &height, data, n, MOST_TEXELS, "input") == TS_OK) {
		assert(width > 0 && height > 0 && (uint64_t)width * height <= MOST_TEXELS);
		touch(rgba, (size_t)width * height * 4);
	} else {
		assert(rgba == NULL);
		fuzz_refused();
	}
	free(rgba);
}

static void read_file(void)
{
	float *pixels;
	uint32_t width, height, channels;
	if (ts_image_read(&pixels, &width, &height, &channels, path) == TS_OK) {
		assert(width > 0 && height > 0 && channels >= 1 && channels <= 4);
		touch(pixels, (size_t)width * height * channels * sizeof *pixels);
	} else {
		assert(pixels == NULL);
		fuzz_refused();
	}
	free(pixels);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	if (path == NULL) {
		fuzz_begin();
		path = fuzz_name("image");
	}
	uint8_t *copy = malloc(n);
	if (copy == NULL) abort();
	if (n > 0) memcpy(copy, data, n);
	if (n > 0 && copy[0] == 0x89 && copy[n - 1] % 2 == 0) put_checksums(copy, n);
	decode(copy, n);
	fuzz_write(path, copy, n);
	free(copy);
	read_file();
	return 0;
}
