/* The kind of an image file, by the first bytes that its standard gives. */
#include "image/format.h"
#include <string.h>

typedef struct {
	ts_image_format format;
	const char *name;
	size_t at, n;
	const char *bytes;
} signature;

static const signature signatures[] = {
	{TS_IMAGE_PNG, "PNG", 0, 8, "\x89PNG\r\n\x1a\n"},
	{TS_IMAGE_JPEG, "JPEG", 0, 3, "\xff\xd8\xff"},
	{TS_IMAGE_EXR, "EXR", 0, 4, "\x76\x2f\x31\x01"},
	{TS_IMAGE_OTHER, "KTX2", 0, 12, "\xabKTX 20\xbb\r\n\x1a\n"},
	{TS_IMAGE_OTHER, "KTX", 0, 12, "\xabKTX 11\xbb\r\n\x1a\n"},
	{TS_IMAGE_OTHER, "WebP", 8, 4, "WEBP"},
	{TS_IMAGE_OTHER, "AVIF", 4, 8, "ftypavif"},
	{TS_IMAGE_OTHER, "DDS", 0, 4, "DDS "},
	{TS_IMAGE_OTHER, "GIF", 0, 4, "GIF8"},
};

ts_image_format ts_image_format_find(const void *head, size_t n, const char **name)
{
	const char *bytes = head;
	for (size_t i = 0; i < sizeof signatures / sizeof signatures[0]; i++) {
		const signature *s = &signatures[i];
		if (n < s->at + s->n || memcmp(bytes + s->at, s->bytes, s->n) != 0) continue;
		if (name != NULL) *name = s->name;
		return s->format;
	}
	return TS_IMAGE_UNKNOWN;
}
