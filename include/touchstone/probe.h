/* Why a pixel, a texel, a triangle or a point of a trace is what it is: who competed, who won by how much, and which
 * stage lost the others (reference/TRACES.md). The answers are trees; `touchstone help probe` says what each tells. */
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

/* Pixel (x, y) of the eye, from the top left; or, with a view such as "3.+X", a texel. Release *answer by ts_tree_free;
 * NULL on failure: there is no such pixel, the trace lacks buffers (all of which are named), or nothing is told of its
 * method. */
TS_API ts_status ts_probe_pixel(ts_context *context, ts_tree **answer, const ts_trace *trace, uint32_t x, uint32_t y,
                                const char *view);

/* A triangle, by its index into scene.triangle. */
TS_API ts_status ts_probe_triangle(ts_context *context, ts_tree **answer, const ts_trace *trace, uint64_t triangle);

/* A point, by its index into points.record. */
TS_API ts_status ts_probe_point(ts_context *context, ts_tree **answer, const ts_trace *trace, uint64_t point);

#ifdef __cplusplus
}
#endif
#endif
