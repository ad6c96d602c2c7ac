/* SPDX-License-Identifier: Apache-2.0 */
/* Why a pixel, a texel, a triangle or a point of a trace is what it is: what competed, what won by how much, and at
 * which stage the others were lost (reference/TRACES.md). The answers are trees; `touchstone help probe` says what each
 * of them has. */
#ifndef TOUCHSTONE_PROBE_H
#define TOUCHSTONE_PROBE_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/context.h>
#include <touchstone/status.h>
#include <touchstone/trace.h>
#include <touchstone/tree.h>
#ifdef __cplusplus
extern "C" {
#endif

/* Explains pixel (x, y) of the eye, from the top left; or, with a view such as "3.+X", a texel.
 * Out: *answer is to be released by ts_tree_free; NULL on failure.
 * Fails if there is no such pixel, the trace lacks buffers (all of which are named), or its method has no probe. */
TS_API ts_status ts_probe_pixel(ts_context *context, ts_tree **answer, const ts_trace *trace, uint32_t x, uint32_t y,
                                const char *view);

/* Explains a triangle, by its index into scene.triangle. */
TS_API ts_status ts_probe_triangle(ts_context *context, ts_tree **answer, const ts_trace *trace, uint64_t triangle);

/* Explains a point, by its index into points.record. */
TS_API ts_status ts_probe_point(ts_context *context, ts_tree **answer, const ts_trace *trace, uint64_t point);

/* A point, by its key: piece, x and y. */
TS_API ts_status ts_probe_point_key(ts_context *context, ts_tree **answer, const ts_trace *trace, const int64_t key[3]);

/* What a probe answers on a kind of thing in the traces of some methods. */
typedef struct {
	const char
		*option; /* how the command asks: "--pixel X,Y", "--pixel X,Y --view VIEW", "--triangle T", "--point P" */
	const char *methods; /* "reflections by epr, mvr; ..." */
	const char *view;    /* texels: how their views are named; otherwise "" */
	const char *answer;  /* what the answer says */
} ts_probe_info;

/* Row i of all, from 0; NULL behind the last. */
TS_API const ts_probe_info *ts_probe_at(size_t i);

#ifdef __cplusplus
}
#endif
#endif
