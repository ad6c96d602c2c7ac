/* SPDX-License-Identifier: Apache-2.0 */
/* Image files and image metrics. The first image that is read or written, but for PNG, loads libtouchstone-image.so.
 * This file must stand beside the shared library; for a program that is linked with the static library, where the
 * program looks for libraries. */
#ifndef TOUCHSTONE_IMAGE_H
#define TOUCHSTONE_IMAGE_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Decodes a PNG or JPEG file held in memory to 8-bit RGBA (METHODS 4: unassociated alpha, 16-bit sources rounded to 8,
 * grey replicated, missing alpha 255). A header that claims more than max_texels texels is refused before anything is
 * allocated.
 * In: `what` names the image in the message.
 * Out: *rgba holds width * height * 4 bytes, rows from the top, to be released with free(); nothing on failure. */
TS_API ts_status ts_image_decode(uint8_t **rgba, uint32_t *width, uint32_t *height, const void *file, size_t file_bytes,
                                 uint64_t max_texels, const char *what);

/* A text in the file of a picture. `name` is 1 to 79 characters of printable ASCII. */
typedef struct {
	const char *name, *text;
} ts_image_text;

/* Writes an 8-bit PNG of `channels` (1, 3 or 4) interleaved channels, rows from the top. The file appears only when
 * complete: it is written as PATH.partial and renamed.
 * In: texts: the last has the name NULL; NULL: no texts. */
TS_API ts_status ts_image_write_png(const char *path, const uint8_t *pixels, uint32_t width, uint32_t height,
                                    uint32_t channels, const ts_image_text *texts);

/* Writes a 32-bit float EXR of `channels` channels (1: Y, 3: RGB, 4: RGBA), rows from the top. File and texts are as
 * above. */
TS_API ts_status ts_image_write_exr(const char *path, const float *pixels, uint32_t width, uint32_t height,
                                    uint32_t channels, const ts_image_text *texts);

/* Encode the files of ts_image_write_png and ts_image_write_exr in memory. what: the picture's name in messages.
 * Out: *file holds *file_bytes bytes, to be released with free(); NULL on failure. */
TS_API ts_status ts_image_encode_png(void **file, size_t *file_bytes, const uint8_t *pixels, uint32_t width,
                                     uint32_t height, uint32_t channels, const ts_image_text *texts, const char *what);
TS_API ts_status ts_image_encode_exr(void **file, size_t *file_bytes, const float *pixels, uint32_t width,
                                     uint32_t height, uint32_t channels, const ts_image_text *texts, const char *what);

/* Reads a PNG, JPEG or EXR as float (channels as in the file; 8-bit values divided by 255).
 * Out: *pixels is to be released with free(). */
TS_API ts_status ts_image_read(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels, const char *path);

/* The same of a file in memory. what: the picture's name in messages. */
TS_API ts_status ts_image_read_bytes(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels,
                                     const void *file, size_t file_bytes, const char *what);

/* How far apart two 8-bit RGB images are (METHODS 17). Values are in grey levels, 0 to 255. */
typedef struct {
	double rmse;       /* root of the mean over pixels and channels */
	double psnr;       /* dB; infinite if equal */
	double ssim;       /* Wang 2004: 11 by 11 Gaussian, sigma 1.5, luma; mean over the window centres judged */
	uint64_t pixels;   /* judged */
	double rmse_error; /* standard error of rmse, where that is an estimate; otherwise 0 */
} ts_metrics;

/* Compares two images. Without an image, NULL, nothing is judged. The result does not depend on threads.
 * In: mask: width * height bytes; pixels with 0 are not judged; NULL: all are. */
TS_API ts_metrics ts_metrics_compare(const uint8_t *reference, const uint8_t *image, const uint8_t *mask,
                                     uint32_t width, uint32_t height);

/* Two images, one or both standing for a better image, `all_`, which is known at chosen pixels drawn at random. */
typedef struct {
	const uint8_t *reference, *image;
	const uint8_t *all_reference, *all_image; /* right where `chosen` is not 0 */
	const uint8_t *chosen;                    /* width * height bytes */
} ts_metrics_part;

/* Estimates how far the better images are apart, from the differences everywhere and at the chosen pixels (METHODS 17).
 * ssim is NaN, and so is rmse_error with fewer than 3 chosen pixels. mask: as above. */
TS_API ts_metrics ts_metrics_estimate(const ts_metrics_part *part, const uint8_t *mask, uint32_t width,
                                      uint32_t height);

/* How much more an image changes from one frame to the next than its reference does, in grey levels (METHODS 17): the
 * root of the mean over pixels and channels of max(0, |image - image_before| - |reference - reference_before|)^2. With
 * one reference for both frames the result is how much the image changes. mask: as above. 0 if nothing is judged. */
TS_API double ts_metrics_flicker(const uint8_t *reference_before, const uint8_t *reference, const uint8_t *image_before,
                                 const uint8_t *image, const uint8_t *mask, uint32_t width, uint32_t height);

/* How far apart two images of light are, RGB in linear radiance (METHODS 17). The error of a pixel is the sum over
 * channels of |image - reference| divided by the sum of the reference: 0 if the two are equal, infinite where only the
 * image has light. */
typedef struct {
	double squares;  /* sum over pixels and channels of (image - reference)^2 */
	double relative; /* root of their mean, divided by the reference's mean; infinite if that is 0 */
	double median;   /* the least error, in single precision, that is enough for half of the pixels */
	double beyond;   /* share of the pixels whose error is above a tenth */
	double given;    /* mean of the image over the unlit pixels, divided by the reference's over all */
	uint64_t pixels; /* judged */
	uint64_t unlit;  /* of the judged pixels, those where only the image has light */
} ts_light_metrics;

/* Compares two images of light. mask: as above. All 0 if nothing is judged. */
TS_API ts_light_metrics ts_metrics_light(const float *reference, const float *image, const uint8_t *mask,
                                         uint32_t width, uint32_t height);

/* Counts crumbs: pixels whose light in some channel is more than 0.1 above the greatest or below the least light that
 * the reference has at the pixel and at its four neighbours. No shift by a pixel explains these.
 * Out: marks: width * height bytes, set to 1 at crumbs and to 0 elsewhere; or NULL. */
TS_API uint64_t ts_metrics_crumbs(uint8_t *marks, const float *reference, const float *image, uint32_t width,
                                  uint32_t height);

#ifdef __cplusplus
}
#endif
#endif
