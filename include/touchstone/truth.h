/* SPDX-License-Identifier: Apache-2.0 */
/* Ground truth by rays (Embree): what a method's picture should look like. It is judged by metrics, never by bits, and
 * is no reference of ts_compare. */
#ifndef TOUCHSTONE_TRUTH_H
#define TOUCHSTONE_TRUTH_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/context.h>
#include <touchstone/params.h>
#include <touchstone/scene.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

/* A truth, as `touchstone list truths` prints it. */
typedef struct {
	const char *name;
	const char *effects; /* that the truth judges, separated by blanks */
	const char *doc;
	const char *share;         /* whose error separates a picture from this truth: "method", "sampling", "both" or "" */
	const char *against;       /* another truth, to compare this one with; "": none */
	const char *against_share; /* whose error separates the two truths */
} ts_truth_info;

/* Truth i, from 0; NULL behind the last. */
TS_API const ts_truth_info *ts_truth_at(size_t i);

/* A picture made by rays. */
typedef struct {
	uint32_t width, height;
	const float *radiance; /* height rows of width pixels, linear RGB, from the top */
	const uint8_t *srgb;   /* the same pixels as displayed, RGB */
	int estimated;         /* not 0: the parameter truth.rays left out some of the rays */
} ts_truth_image;

/* Renders a truth of an effect. The result does not depend on threads.
 * Out: *image is to be released by ts_truth_image_free; NULL on failure.
 * Fails if the effect has no such truth, the scene lacks what the truth shows, or memory ends. */
TS_API ts_status ts_truth_render(ts_context *context, ts_truth_image **image, const ts_scene *scene,
                                 const ts_params *params, const char *effect, const char *truth);

/* Releases a picture; NULL is allowed. */
TS_API void ts_truth_image_free(ts_truth_image *image);

#ifdef __cplusplus
}
#endif
#endif
