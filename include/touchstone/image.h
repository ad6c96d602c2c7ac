/* Image files and image metrics. The first image that is read or written loads libtouchstone-image.so, which must stand
 * beside the shared library, or where a program that is linked with the static one looks for libraries. */
#ifndef TOUCHSTONE_IMAGE_H
#define TOUCHSTONE_IMAGE_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Decodes a PNG or JPEG file held in memory to 8-bit RGBA (METHODS 4: unassociated alpha, 16-bit sources rounded to 8,
 * grey replicated, missing alpha 255). On success *rgba holds width * height * 4 bytes, rows from the top, to be
 * released with free(). On failure nothing is allocated. `what` names the image in the message. A header that claims
 * more than max_texels texels is refused before anything is allocated. */
TS_API ts_status ts_image_decode(uint8_t **rgba, uint32_t *width, uint32_t *height, const void *file, size_t file_bytes,
                                 uint64_t max_texels, const char *what);

/* What a file says about its picture. `name` is 1 to 79 characters of printable ASCII. */
typedef struct {
	const char *name, *text;
} ts_image_text;

/* Writes an 8-bit PNG of `channels` (1, 3 or 4) interleaved channels, rows from the top. The file appears whole or not
 * at all: it is written as PATH.partial and renamed. texts: ended by one whose name is NULL; NULL: none. */
TS_API ts_status ts_image_write_png(const char *path, const uint8_t *pixels, uint32_t width, uint32_t height,
                                    uint32_t channels, const ts_image_text *texts);

/* Writes a 32-bit float EXR of `channels` channels (1: Y, 3: RGB, 4: RGBA), rows from the top, whole or not at all.
 * texts: as above. */
TS_API ts_status ts_image_write_exr(const char *path, const float *pixels, uint32_t width, uint32_t height,
                                    uint32_t channels, const ts_image_text *texts);

/* Reads a PNG, JPEG or EXR as float (channels as in the file; 8-bit values divided by 255). *pixels by free(). */
TS_API ts_status ts_image_read(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels, const char *path);

/* How far apart two 8-bit RGB images are (METHODS 17). Values are in grey levels, 0 to 255. */
typedef struct {
	double rmse;       /* root of the mean over pixels and channels */
	double psnr;       /* dB; infinite if equal */
	double ssim;       /* Wang 2004: 11 by 11 Gaussian, sigma 1.5, luma; mean over the window centres judged */
	uint64_t pixels;   /* judged */
	double rmse_error; /* standard error of rmse, where it is an estimate; else 0 */
} ts_metrics;

/* mask: width * height bytes, pixels with 0 are not judged; NULL: all are. Without an image, NULL, nothing is judged.
 * The result does not depend on threads. */
TS_API ts_metrics ts_metrics_compare(const uint8_t *reference, const uint8_t *image, const uint8_t *mask,
                                     uint32_t width, uint32_t height);

/* Two images of which one or both stand for a better one, `all_`, that is known at chosen pixels, drawn at random. */
typedef struct {
	const uint8_t *reference, *image;
	const uint8_t *all_reference, *all_image; /* right where `chosen` is not 0 */
	const uint8_t *chosen;                    /* width * height bytes */
} ts_metrics_part;

/* Estimates how far the better ones are apart, from the differences everywhere and at the chosen pixels (METHODS 17).
 * ssim is NaN, and so is rmse_error of fewer than 3 chosen pixels. mask: as above. */
TS_API ts_metrics ts_metrics_estimate(const ts_metrics_part *part, const uint8_t *mask, uint32_t width,
                                      uint32_t height);

/* How much more an image changes from one frame to the next than its reference does, in grey levels (METHODS 17): the
 * root of the mean over pixels and channels of max(0, |image - image_before| - |reference - reference_before|)^2. With
 * one reference for both frames it is how much the image changes. mask: as above. 0 if nothing is judged. */
TS_API double ts_metrics_flicker(const uint8_t *reference_before, const uint8_t *reference, const uint8_t *image_before,
                                 const uint8_t *image, const uint8_t *mask, uint32_t width, uint32_t height);

/* How far apart two images of light are, RGB in linear radiance (METHODS 17). The error of a pixel is the sum over
 * channels of |image - reference| by the sum of the reference: 0 if they are equal, infinite where only the image has
 * light. */
typedef struct {
	double squares;  /* sum over pixels and channels of (image - reference)^2 */
	double relative; /* root of their mean, by the mean of the reference; infinite beside no light */
	double median;   /* the least error, in single precision, that is enough for half of the pixels */
	double beyond;   /* share of the pixels whose error is above a tenth */
	double given;    /* mean of the image over the unlit pixels, by the mean of the reference over all */
	uint64_t pixels; /* judged */
	uint64_t unlit;  /* of them only the image has light */
} ts_light_metrics;

/* mask: as above. All 0 if nothing is judged. */
TS_API ts_light_metrics ts_metrics_light(const float *reference, const float *image, const uint8_t *mask,
                                         uint32_t width, uint32_t height);

/* Counts the pixels whose light lies in some channel by more than 0.1 above the greatest or below the least that the
 * reference has at the pixel and at its four neighbours: crumbs along edges, which no shift by a pixel explains.
 * marks: width * height bytes, set to 1 at crumbs and to 0 elsewhere; or NULL. */
TS_API uint64_t ts_metrics_crumbs(uint8_t *marks, const float *reference, const float *image, uint32_t width,
                                  uint32_t height);

#ifdef __cplusplus
}
#endif
#endif
