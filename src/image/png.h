/* PNG files from strangers (PNG 1.2, sections 3 to 5). */
#ifndef TS_IMAGE_PNG_H
#define TS_IMAGE_PNG_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Copies the chunks of a PNG that its pixels depend on: IHDR, PLTE (padded with black), tRNS and one IDAT. Everything
 * is checked first, including checksums and the whole compressed stream, because libpng prints messages about damage to
 * stderr. On success *clean holds *clean_bytes bytes, to be released with free(). On failure nothing is allocated, and
 * the message begins with `what`. `file` must begin with the PNG signature. */
ts_status ts_png_clean(uint8_t **clean, size_t *clean_bytes, const uint8_t *file, size_t file_bytes, const char *what);

#ifdef __cplusplus
}
#endif
#endif
