/* LDR-FLIP: how visible the differences of two images are to an observer who flips between them. Andersson, Nilsson,
 * Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator for Alternating Images" (HPG 2020, DOI
 * 10.1145/3406183). */
#ifndef TS_IMAGE_FLIP_H
#define TS_IMAGE_FLIP_H
#include <stdint.h>
#include <touchstone/status.h>

/* Pixels per degree of visual angle: those of the paper's observer, and the accepted range. */
#define TS_FLIP_PPD 67.0
#define TS_FLIP_LEAST_PPD 1.0
#define TS_FLIP_MOST_PPD 1000.0

/* Compares two images of width * height pixels, 8-bit sRGB. errors: width * height values from 0, equal, to 1; *mean:
 * their mean. The result does not depend on threads. Fails without memory. */
ts_status ts_flip(float *errors, double *mean, const uint8_t *reference, const uint8_t *image, uint32_t width,
                  uint32_t height, double ppd);
/* The memory that the comparison takes beside the errors; more where 64 rows do not fit. */
enum { TS_FLIP_BYTES = 1 << 26 };

#endif
