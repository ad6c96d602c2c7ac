/* Pixels of a PNG, by zlib alone: its filters are undone row by row (PNG 1.2, section 6). */
#include "png.h"
#include "../model/core.h"
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { HEADER = 16, DATA = 33, PIXEL = 3 }; /* where a file's header, and the chunk behind, begin; bytes of a pixel */

static uint32_t number(const uint8_t *p) { return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | p[2] << 8 | p[3]; }

static int paeth(int left, int up, int corner)
{
	int to_left = abs(up - corner), to_up = abs(left - corner), to_corner = abs(left + up - 2 * corner);
	if (to_left <= to_up && to_left <= to_corner) return left;
	return to_up <= to_corner ? up : corner;
}

/* `row` is the row's bytes behind its filter; `above` that of the row above, of zeros above the first. */
static void unfilter(uint8_t *row, const uint8_t *above, size_t bytes, uint8_t filter)
{
	for (size_t i = 0; i < bytes; i++) {
		int left = i >= PIXEL ? row[i - PIXEL] : 0, up = above[i], corner = i >= PIXEL ? above[i - PIXEL] : 0;
		const int guess[] = {0, left, up, (left + up) / 2, paeth(left, up, corner)};
		row[i] = (uint8_t)(row[i] + guess[filter]);
	}
}

/* `rgb` becomes the pixels of the clean file's compressed rows. */
static ts_status inflate_rows(uint8_t *rgb, uint32_t width, uint32_t height, const uint8_t *clean, const char *what)
{
	size_t row_bytes = (size_t)PIXEL * width, step = row_bytes + 1;
	uLongf bytes = (uLongf)(step * (height + 1));
	uint8_t *rows = ts_alloc(step * (height + 1), 1, what);
	if (rows == NULL) return TS_ERROR;
	memset(rows, 0, step);
	bytes -= (uLongf)step;
	bool whole = uncompress(rows + step, &bytes, clean + DATA + 8, number(clean + DATA)) == Z_OK;
	for (size_t y = 0; whole && y < height; y++) {
		uint8_t *row = rows + step * (y + 1);
		unfilter(row + 1, row + 1 - step, row_bytes, row[0]);
		memcpy(rgb + row_bytes * y, row + 1, row_bytes);
	}
	free(rows);
	return whole ? TS_OK : ts_fail("%s: no memory to inflate it", what);
}

/* Refuses what is not 8-bit RGB from top to bottom, or larger. */
static ts_status judge_header(const uint8_t *file, size_t file_bytes, uint64_t most_pixels, const char *what)
{
	static const uint8_t begin[] = {137, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R'};
	static const uint8_t kind[] = {8, 2, 0, 0, 0};
	if (file_bytes < DATA || memcmp(file, begin, sizeof begin) != 0) return ts_fail("%s: not a PNG", what);
	uint64_t width = number(file + HEADER), height = number(file + HEADER + 4);
	if (width * height > most_pixels) {
		return ts_fail("%s: %u by %u pixels; at most %llu are right", what, (unsigned)width, (unsigned)height,
		               (unsigned long long)most_pixels);
	}
	if (memcmp(file + HEADER + 8, kind, sizeof kind) == 0) return TS_OK;
	return ts_fail("%s: not a PNG of 8-bit RGB without interlacing", what);
}

ts_status ts_png_rgb(uint8_t **rgb, uint32_t *width, uint32_t *height, const void *file, size_t file_bytes,
                     uint64_t most_pixels, const char *what)
{
	uint8_t *clean;
	size_t clean_bytes;
	*rgb = NULL;
	if (judge_header(file, file_bytes, most_pixels, what) != TS_OK) return TS_ERROR;
	if (ts_png_clean(&clean, &clean_bytes, file, file_bytes, what) != TS_OK) return TS_ERROR;
	*width = number(clean + HEADER);
	*height = number(clean + HEADER + 4);
	bool plain = memcmp(clean + DATA + 4, "IDAT", 4) == 0;
	ts_status status = plain ? TS_OK : ts_fail("%s: it has a transparent colour", what);
	if (plain) *rgb = ts_alloc((size_t)*width * *height, PIXEL, what);
	if (*rgb != NULL) status = inflate_rows(*rgb, *width, *height, clean, what);
	if (*rgb == NULL || status != TS_OK) {
		free(*rgb);
		*rgb = NULL;
		status = TS_ERROR;
	}
	free(clean);
	return status;
}
