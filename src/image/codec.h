/* What the image module offers to image.c. OpenImageIO maps hundreds of shared libraries, which takes half a second and
 * 130 MiB; so a module of its own, loaded with the first image, links to it. */
#ifndef TS_IMAGE_CODEC_H
#define TS_IMAGE_CODEC_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/image.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
	/* `file` is of that format ("png", "jpeg"), and its header says width by height: so many texels are written. */
	ts_status (*decode)(uint8_t *rgba, uint32_t width, uint32_t height, const char *format, const void *file,
	                    size_t file_bytes, const char *what);
	/* Files in memory, for `path` (by free(); NULL on failure), of pixels and texts as <touchstone/image.h> takes
	 * them. */
	ts_status (*encode_png)(void **file, size_t *file_bytes, const char *path, const uint8_t *pixels, uint32_t width,
	                        uint32_t height, uint32_t channels, const ts_image_text *texts);
	ts_status (*encode_exr)(void **file, size_t *file_bytes, const char *path, const float *pixels, uint32_t width,
	                        uint32_t height, uint32_t channels, const ts_image_text *texts);
	/* `file` is of that format ("png", "jpeg", "openexr"). As ts_image_read otherwise. */
	ts_status (*read)(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels, const char *format,
	                  const void *file, size_t file_bytes, const char *what);
	/* Of this thread's last failure within the module. */
	const char *(*message)(void);
} ts_image_codec;

#define TS_IMAGE_MODULE "libtouchstone-image.so"
TS_API extern const ts_image_codec ts_image_codec_module;

#ifdef __cplusplus
}
#endif
#endif
