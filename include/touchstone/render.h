/* SPDX-License-Identifier: Apache-2.0 */
/* A rendering: methods of an effect and its truths, of one frame of a scene; their pictures, and figures of what was
 * measured, by names: `epr.ms.splat`, `epr.count.points`, `epr.bytes.points.record`, `epr.rmse.mvr`, `epr.rmse.A`.
 * Buffers are released as soon as no later stage reads them; ts_trace_run with the same arguments keeps them. */
#ifndef TOUCHSTONE_RENDER_H
#define TOUCHSTONE_RENDER_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/context.h>
#include <touchstone/params.h>
#include <touchstone/scene.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct ts_rendering ts_rendering;

/* Options of a rendering. Only `bytes` must be set; 0 is the default of each other member. */
typedef struct {
	size_t bytes;        /* sizeof(ts_rendering_options) */
	const char *methods; /* names, separated by commas; NULL: all that run without being named */
	const char *truths;  /* names, separated by commas, or "all"; NULL: none */
	int stages;          /* not 0: also pictures of stages, in false colours */
	/* The rendering of a frame before, by the same scene, effect, methods and truths and the same parameters but for
	 * `frame`: cubes go on from their sizes there, and there are figures of what changes. NULL: none. It may be freed
	 * after the call. */
	const ts_rendering *before;
} ts_rendering_options;

/* Runs the methods and makes the truths. Nothing that is measured but times depends on threads.
 * In: options NULL: all defaults.
 * Out: *rendering is to be released by ts_rendering_free, before the scene; NULL on failure.
 * Fails if the effect lacks a name, a truth is not there for this scene, the run would need more than three quarters of
 * this machine's memory, or the host cancels. */
TS_API ts_status ts_rendering_make(ts_context *context, ts_rendering **rendering, const ts_scene *scene,
                                   const ts_params *params, const char *effect, const ts_rendering_options *options);
/* Releases a rendering, its pictures and the names of its figures; NULL is allowed. */
TS_API void ts_rendering_free(ts_rendering *rendering);

/* A picture. It lives as long as its rendering. */
typedef struct {
	const char *name; /* "epr", "truth-a", and of stages "epr-points" */
	uint32_t width, height;
	const uint8_t *srgb;   /* height rows of width pixels, RGB as displayed, from the top */
	const float *radiance; /* the same pixels, linear RGB; NULL: of false colours */
	int estimated;         /* not 0: of a truth from which the parameter truth.rays left out some rays */
} ts_rendering_picture;
/* Picture i, from 0: those of methods, of truths, of stages; NULL behind the last. */
TS_API const ts_rendering_picture *ts_rendering_picture_at(const ts_rendering *rendering, size_t i);
/* The picture of that name, or the difference of two: "difference-epr-truth-b" has, as displayed, their distance in
 * grey levels, times a factor of the effect, and, as radiance, the first less the second. A difference is made when it
 * is first asked for; two threads must not ask at once.
 * Out: *picture; NULL on failure. Fails if there is no such picture. */
TS_API ts_status ts_rendering_picture_named(ts_context *context, const ts_rendering_picture **picture,
                                            ts_rendering *rendering, const char *name);

/* A figure. Only `bytes` must be set before. The name lives as long as its rendering. */
typedef struct {
	size_t bytes; /* sizeof(ts_rendering_figure) */
	const char *name;
	const char *unit; /* "ms", "bytes", "dB", ...; "" if it has none */
	double value;     /* NaN: was not measured */
	double error;     /* standard error of an estimate, otherwise 0 */
	int timed;        /* not 0: two runs differ */
} ts_rendering_figure;
/* Figure i, from 0: those of the scene, then those of each method. TS_SKIPPED: there are no more. */
TS_API ts_status ts_rendering_figure_at(ts_rendering_figure *figure, const ts_rendering *rendering, size_t i);
/* The figure of that name. TS_ERROR: there is none, and *value is NaN. */
TS_API ts_status ts_rendering_figure_named(double *value, const ts_rendering *rendering, const char *name);

#ifdef __cplusplus
}
#endif
#endif
