/* The module of images: what can be known before it is used, and images that the work can do without. */
#ifndef TS_IMAGE_OPTIONAL_H
#define TS_IMAGE_OPTIONAL_H
#include <touchstone/image.h>

/* Loads the module, so that its memory is taken. Fails as ts_image_write_exr to `what` would without it. */
ts_status ts_image_load(const char *what);

/* Decodes as ts_image_decode does. TS_SKIPPED, with the message set, if the module of images does not load. */
ts_status ts_image_decode_optional(uint8_t **rgba, uint32_t *width, uint32_t *height, const void *file,
                                   size_t file_bytes, uint64_t max_texels, const char *what);

#endif
