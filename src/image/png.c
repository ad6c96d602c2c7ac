/* Untrusted PNG files: every chunk that pixels depend on is checked and copied (PNG 1.2, sections 3 to 5). */
#include "image/png.h"
#include <stdlib.h>
#include <string.h>
#include <zlib.h>
#include "model/core.h"

enum { GREY = 0, RGB = 2, PALETTE = 3, GREY_ALPHA = 4, RGB_ALPHA = 6 };
enum { SIGNATURE = 8, FRAME = 12, HEADER = 13, LARGEST_SIDE = 65536, LARGEST_CHUNK = 0x7fffffff };

typedef struct {
	uint32_t width, height;
	uint8_t depth, colour, interlaced;
	uint8_t palette[768], alpha[256];
	uint32_t n_palette, n_alpha; /* bytes */
	uint8_t *data;               /* the IDAT chunks as one */
	size_t n_data, capacity;
	const char *what;
} png;

/* The rows of a stream of pixels. */
typedef struct {
	uint32_t pass;
	uint64_t rows, row_bytes; /* left in this pass; per row, with its filter byte */
	uint64_t left;            /* of this row */
} rows;

static uint32_t number(const uint8_t *p) { return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | p[2] << 8 | p[3]; }

static void put_number(uint8_t *p, uint32_t value)
{
	for (int i = 0; i < 4; i++) p[i] = (uint8_t)(value >> (24 - 8 * i));
}

static ts_status damaged(const png *image, const char *why)
{
	return ts_fail("%s: damaged: %s; a whole PNG is expected", image->what, why);
}

static uint32_t channels(uint8_t colour)
{
	return colour == RGB ? 3 : colour == GREY_ALPHA ? 2 : colour == RGB_ALPHA ? 4 : 1;
}

static ts_status take_header(png *image, const uint8_t *p, uint32_t n)
{
	static const uint8_t depths[7] = {1 | 2 | 4 | 8 | 16, 0, 8 | 16, 1 | 2 | 4 | 8, 8 | 16, 0, 8 | 16};
	if (n != HEADER || image->width != 0) return damaged(image, "its header is not one of 13 bytes");
	image->width = number(p);
	image->height = number(p + 4);
	image->depth = p[8];
	image->colour = p[9];
	image->interlaced = p[12];
	if (image->width - 1 >= LARGEST_SIDE || image->height - 1 >= LARGEST_SIDE)
		return ts_fail("%s: %u by %u pixels; sides of 1 to 65536 are read", image->what, image->width, image->height);
	bool single = image->depth != 0 && (image->depth & (image->depth - 1)) == 0;
	if (image->colour > RGB_ALPHA || !single || (depths[image->colour] & image->depth) == 0)
		return damaged(image, "no such colour type and bit depth");
	if (p[10] != 0 || p[11] != 0 || p[12] > 1) return damaged(image, "unknown compression, filter or interlace method");
	return TS_OK;
}

static ts_status take_palette(png *image, const uint8_t *p, uint32_t n)
{
	if (image->colour != PALETTE) return TS_OK;
	if (image->n_palette != 0 || image->n_data != 0 || n == 0 || n % 3 != 0 || n > 3u << image->depth)
		return damaged(image, "its palette has a wrong size or place");
	memcpy(image->palette, p, n);
	image->n_palette = n;
	return TS_OK;
}

static ts_status take_alpha(png *image, const uint8_t *p, uint32_t n)
{
	uint32_t most = image->colour == PALETTE ? image->n_palette / 3 : image->colour == RGB ? 6 : 2;
	if (image->colour > PALETTE) return TS_OK;
	if (image->n_alpha != 0 || image->n_data != 0 || n == 0 || n > most || (image->colour != PALETTE && n != most))
		return damaged(image, "its transparency has a wrong size or place");
	memcpy(image->alpha, p, n);
	image->n_alpha = n;
	return TS_OK;
}

static ts_status take_data(png *image, const uint8_t *p, uint32_t n)
{
	void *data = image->data;
	if (image->colour == PALETTE && image->n_palette == 0) return damaged(image, "it has no palette");
	if (n > LARGEST_CHUNK - image->n_data) return damaged(image, "more than 2 GiB");
	if (ts_grow(&data, &image->capacity, image->n_data + n, 1, image->what) != TS_OK) return TS_ERROR;
	image->data = data;
	if (n != 0) memcpy(image->data + image->n_data, p, n);
	image->n_data += n;
	return TS_OK;
}

static ts_status take_chunk(png *image, const uint8_t *type, const uint8_t *p, uint32_t n)
{
	bool header = memcmp(type, "IHDR", 4) == 0;
	if (header != (image->width == 0)) return damaged(image, "its header is not its first chunk");
	if (header) return take_header(image, p, n);
	if (memcmp(type, "PLTE", 4) == 0) return take_palette(image, p, n);
	if (memcmp(type, "tRNS", 4) == 0) return take_alpha(image, p, n);
	if (memcmp(type, "IDAT", 4) == 0) return take_data(image, p, n);
	bool optional = type[0] & 32;
	return optional ? TS_OK : damaged(image, "an unknown chunk that must be understood");
}

static ts_status take_chunks(png *image, const uint8_t *file, size_t file_bytes)
{
	for (size_t at = SIGNATURE; file_bytes - at >= FRAME;) {
		const uint8_t *p = file + at;
		uint32_t n = number(p);
		if (n > file_bytes - at - FRAME) break;
		if (crc32(0, p + 4, n + 4) != number(p + 8 + n)) return damaged(image, "a checksum is wrong");
		bool end = memcmp(p + 4, "IEND", 4) == 0;
		if (end && image->width != 0) return image->n_data != 0 ? TS_OK : damaged(image, "it has no pixels");
		if (take_chunk(image, p + 4, p + 8, n) != TS_OK) return TS_ERROR;
		at += FRAME + (size_t)n;
	}
	return damaged(image, "it is cut short");
}

/* Opens the next pass that has pixels; false after the last. */
static bool next_pass(rows *r, const png *image)
{
	static const uint8_t x0[7] = {0, 4, 0, 2, 0, 1, 0}, y0[7] = {0, 0, 4, 0, 2, 0, 1};
	static const uint8_t dx[7] = {8, 8, 4, 4, 2, 2, 1}, dy[7] = {8, 8, 8, 4, 4, 2, 2};
	uint32_t bits = image->depth * channels(image->colour);
	while (r->pass < (image->interlaced ? 7u : 1u)) {
		uint32_t k = r->pass++;
		uint64_t across = image->interlaced ? (image->width + dx[k] - 1u - x0[k]) / dx[k] : image->width;
		r->rows = image->interlaced ? (image->height + dy[k] - 1u - y0[k]) / dy[k] : image->height;
		r->row_bytes = 1 + (across * bits + 7) / 8;
		if (across != 0 && r->rows != 0) return true;
	}
	return false;
}

/* Takes n bytes of pixels. */
static ts_status follow(rows *r, const png *image, const uint8_t *p, size_t n)
{
	while (n > 0) {
		if (r->left == 0) {
			if (r->rows == 0 && !next_pass(r, image)) return damaged(image, "it holds more than its pixels");
			if (*p > 4) return damaged(image, "an unknown filter");
			r->rows--;
			r->left = r->row_bytes;
		}
		size_t part = n < r->left ? n : (size_t)r->left;
		r->left -= part;
		p += part;
		n -= part;
	}
	return TS_OK;
}

/* Inflates all of the data to check that it is complete; n_data becomes the stream's true size. */
static ts_status check_data(png *image)
{
	uint8_t pixels[16384];
	rows r = {0};
	z_stream z = {.next_in = image->data, .avail_in = (uInt)image->n_data};
	if (inflateInit(&z) != Z_OK) return ts_fail_as(TS_KIND_MEMORY, "%s: no memory to inflate it", image->what);
	int state = Z_OK;
	ts_status status = TS_OK;
	while (state == Z_OK && status == TS_OK) {
		z.next_out = pixels;
		z.avail_out = sizeof pixels;
		state = inflate(&z, Z_NO_FLUSH);
		status = follow(&r, image, pixels, sizeof pixels - z.avail_out);
	}
	image->n_data -= z.avail_in;
	inflateEnd(&z);
	if (status != TS_OK) return status;
	if (state != Z_STREAM_END) return damaged(image, "its pixels do not inflate");
	bool whole = r.left == 0 && r.rows == 0 && r.pass != 0 && !next_pass(&r, image);
	return whole ? TS_OK : damaged(image, "pixels are missing");
}

static uint8_t *put_chunk(uint8_t *to, const char *type, const void *data, size_t n)
{
	put_number(to, (uint32_t)n);
	memcpy(to + 4, type, 4);
	if (n != 0) memcpy(to + 8, data, n);
	put_number(to + 8 + n, (uint32_t)crc32(0, to + 4, (uInt)n + 4));
	return to + FRAME + n;
}

static ts_status write_clean(uint8_t **clean, size_t *clean_bytes, const png *image, const uint8_t *signature)
{
	uint8_t header[HEADER] = {[8] = image->depth, [9] = image->colour, [12] = image->interlaced};
	size_t n_palette = image->colour == PALETTE ? (size_t)3 << image->depth : 0;
	size_t most = SIGNATURE + 5 * FRAME + HEADER + n_palette + image->n_alpha + image->n_data;
	uint8_t *to = *clean = ts_alloc(most, 1, image->what);
	if (!to) return TS_ERROR;
	put_number(header, image->width);
	put_number(header + 4, image->height);
	memcpy(to, signature, SIGNATURE);
	to = put_chunk(to + SIGNATURE, "IHDR", header, sizeof header);
	if (n_palette != 0) to = put_chunk(to, "PLTE", image->palette, n_palette);
	if (image->n_alpha != 0) to = put_chunk(to, "tRNS", image->alpha, image->n_alpha);
	to = put_chunk(to, "IDAT", image->data, image->n_data);
	to = put_chunk(to, "IEND", NULL, 0);
	*clean_bytes = (size_t)(to - *clean);
	return TS_OK;
}

ts_status ts_png_clean(uint8_t **clean, size_t *clean_bytes, const uint8_t *file, size_t file_bytes, const char *what)
{
	png image = {.what = what};
	*clean = NULL;
	ts_status status = take_chunks(&image, file, file_bytes);
	if (status == TS_OK) status = check_data(&image);
	if (status == TS_OK) status = write_clean(clean, clean_bytes, &image, file);
	free(image.data);
	return status;
}
