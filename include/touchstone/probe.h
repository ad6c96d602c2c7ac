/* Why a pixel, a texel, a triangle or a point of a trace is what it is: what competed, what won by how much, and at
 * which stage the others were lost (reference/TRACES.md). The answers are trees; `touchstone help probe` says what each
 * of them has. */
#ifndef TOUCHSTONE_PROBE_H
#define TOUCHSTONE_PROBE_H
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

#ifdef __cplusplus
}
#endif
#endif
