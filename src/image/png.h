/* PNG files from strangers (PNG 1.2, sections 3 to 5). */
#ifndef TS_IMAGE_PNG_H
#define TS_IMAGE_PNG_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Copies of a PNG what its pixels depend on: IHDR, PLTE (filled up with black), tRNS and one IDAT. All of it is checked
 * first, checksums and the whole compressed stream too, because libpng prints its opinion of damage on stderr.
 * On success *clean holds *clean_bytes bytes, to be released with free(). On failure nothing is allocated, and the
 * message begins with `what`. `file` must begin with the PNG signature. */
ts_status ts_png_clean(uint8_t **clean, size_t *clean_bytes, const uint8_t *file, size_t file_bytes, const char *what);

#ifdef __cplusplus
}
#endif
#endif
