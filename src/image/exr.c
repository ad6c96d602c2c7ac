/* Attributes of the headers of EXR, each a name, a type, a number of bytes and these; a header ends with a byte 0, as
 * does the list of headers where a file has several parts. */
#include "image/exr.h"
#include <stdbool.h>
#include <string.h>

enum { BEFORE_HEADERS = 8, BOX_BYTES = 16, COUNT_BYTES = 4, BYTES_A_CHUNK = 8 };
#define PARTS 0x1000u /* of the word behind the file's first */

typedef struct {
	const char *name;
	const uint8_t *value;
	size_t bytes;
} attribute;

static uint32_t little_endian(const uint8_t *p)
{
	return p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

/* What is behind a text that ends with a byte 0; NULL: the end comes first. */
static const uint8_t *behind_text(const uint8_t *at, const uint8_t *end)
{
	const uint8_t *zero = at != NULL && at < end ? memchr(at, 0, (size_t)(end - at)) : NULL;
	return zero != NULL ? zero + 1 : NULL;
}

/* Returns what is behind the attribute; NULL: there is none, as at the end of a header. */
static const uint8_t *take(attribute *a, const uint8_t *at, const uint8_t *end)
{
	const uint8_t *bytes = at < end && *at != 0 ? behind_text(behind_text(at, end), end) : NULL;
	if (bytes == NULL || end - bytes < COUNT_BYTES) return NULL;
	*a = (attribute){(const char *)at, bytes + COUNT_BYTES, little_endian(bytes)};
	return a->bytes <= (size_t)(end - a->value) ? a->value + a->bytes : NULL;
}

static uint64_t side(const uint8_t *low, const uint8_t *high)
{
	const int64_t n = (int64_t)(int32_t)little_endian(high) - (int32_t)little_endian(low) + 1;
	return n > 0 ? (uint64_t)n : 0;
}

static uint64_t pixels_by(const attribute *a, size_t n)
{
	const uint8_t *v = a->value;
	if (strcmp(a->name, "dataWindow") == 0 && a->bytes == BOX_BYTES) {
		const uint64_t width = side(v, v + 8), height = side(v + 4, v + 12);
		return height == 0 || width <= (UINT64_MAX >> 1) / height ? width * height : UINT64_MAX;
	}
	const bool counts = strcmp(a->name, "chunkCount") == 0 && a->bytes == COUNT_BYTES;
	return counts && little_endian(v) > n / BYTES_A_CHUNK ? UINT64_MAX : 0;
}

uint64_t ts_exr_pixels(const uint8_t *file, size_t n)
{
	const uint8_t *at = file + BEFORE_HEADERS, *end = file + n, *next;
	uint64_t all = 0;
	attribute a;
	if (n <= BEFORE_HEADERS) return 0;
	const bool parts = (little_endian(file + COUNT_BYTES) & PARTS) != 0;
	do {
		for (; (next = take(&a, at, end)) != NULL; at = next) {
			const uint64_t more = pixels_by(&a, n);
			all = more <= UINT64_MAX - all ? all + more : UINT64_MAX;
		}
	} while (parts && at < end && *at++ == 0 && at < end && *at != 0);
	return all;
}
