/* PNG files: those from strangers are checked first (PNG 1.2, sections 3 to 5). */
#ifndef TS_IMAGE_PNG_H
#define TS_IMAGE_PNG_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/image.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Copies the chunks of a PNG that its pixels depend on: IHDR, PLTE (padded with black), tRNS and one IDAT. Everything
 * is checked first, including checksums and the whole compressed stream; libpng sees nothing else. On success *clean
 * holds *clean_bytes bytes, to be released with free(). On failure nothing is allocated, and the message begins with
 * `what`. `file` must begin with the PNG signature. */
ts_status ts_png_clean(uint8_t **clean, size_t *clean_bytes, const uint8_t *file, size_t file_bytes, const char *what);

/* Pixels of 1 to 4 channels (grey or RGB, then alpha), rows from the top: codes of 8 bits, or of 16 in the machine's
 * order. */
typedef struct {
	uint32_t width, height, channels, bits;
	void *codes; /* to be released by free() */
} ts_png;

/* Decodes what ts_png_clean made: palettes become RGB, codes below 8 bits are scaled, transparency becomes alpha. codes
 * is NULL on failure. */
ts_status ts_png_read(ts_png *image, const void *file, size_t file_bytes, const char *what);
/* As ts_image_encode_png, of a picture that was checked. */
ts_status ts_png_write(void **file, size_t *file_bytes, const uint8_t *pixels, uint32_t width, uint32_t height,
                       uint32_t channels, const ts_image_text *texts, const char *what);

#ifdef __cplusplus
}
#endif
#endif
