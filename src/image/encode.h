/* Image files in memory. */
#ifndef TS_IMAGE_ENCODE_H
#define TS_IMAGE_ENCODE_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/image.h>

/* Encodes a PNG from pixels and texts as in ts_image_write_png. Release *file by free(); NULL on failure. what: its
 * name in messages. */
ts_status ts_image_encode_png(void **file, size_t *file_bytes, const char *what, const uint8_t *pixels, uint32_t width,
                              uint32_t height, uint32_t channels, const ts_image_text *texts);

#endif
