/* What an image file says beside its pixels. */
#ifndef TS_IMAGE_FRAME_H
#define TS_IMAGE_FRAME_H
#include <touchstone/image.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
	int32_t window[2];  /* x and y of the first pixel */
	int32_t display[4]; /* x, y, width and height of the picture that it is a part of */
	uint32_t parts;     /* pictures in the file, of which the first is read */
	uint32_t whole;     /* a bit a channel: it holds whole numbers, of which `pixels` has the bits */
} ts_image_frame;

/* As ts_image_read; whole numbers of 32 bits are not converted. */
ts_status ts_image_read_framed(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels,
                               ts_image_frame *frame, const char *path);

#ifdef __cplusplus
}
#endif
#endif
