/* The interface of the image module to image.c. OpenImageIO maps hundreds of shared libraries, which takes half a
 * second and 130 MiB; so a separate module, loaded with the first image that is no PNG, links to it. */
#ifndef TS_IMAGE_CODEC_H
#define TS_IMAGE_CODEC_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/image.h>
#include "image/frame.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
	/* Decodes `file`, which is of that format ("jpeg") and has width by height pixels by its header. */
	ts_status (*decode)(uint8_t *rgba, uint32_t width, uint32_t height, const char *format, const void *file,
	                    size_t file_bytes, const char *what);
	/* Encodes a file in memory (release by free(); NULL on failure) from pixels and texts as in <touchstone/image.h>.
	 * `path`: for messages. */
	ts_status (*encode_exr)(void **file, size_t *file_bytes, const char *path, const float *pixels, uint32_t width,
	                        uint32_t height, uint32_t channels, const ts_image_text *texts);
	/* Reads `file`, which is of that format ("jpeg", "openexr"); otherwise like ts_image_read_framed. */
	ts_status (*read)(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels, ts_image_frame *frame,
	                  const char *format, const void *file, size_t file_bytes, const char *what);
	/* The message and the kind of this thread's last failure in the module. */
	const char *(*message)(void);
	ts_kind (*kind)(void);
} ts_image_codec;

#define TS_IMAGE_MODULE "libtouchstone-image.so"
TS_API extern const ts_image_codec ts_image_codec_module;

/* Loads the module, so that its memory is taken. Fails as ts_image_write_exr to `what` would without it. */
ts_status ts_image_load(const char *what);

#ifdef __cplusplus
}
#endif
#endif
