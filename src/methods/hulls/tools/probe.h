/* Answers of the probe about hulls, and about the light that they approximate. */
#ifndef TS_METHODS_HULLS_TOOLS_PROBE_H
#define TS_METHODS_HULLS_TOOLS_PROBE_H
#include "kernels/hulls/direct.h"
#include "kernels/hulls/gloss.h"
#include "kernels/hulls/hull.h"
#include "probe/parts.h"

/* A pixel's irradiance by hulls (probe_hull.c), of one channel from its lobe (probe_lobe.c); and by direct
 * (probe_direct.c). */
ts_status ts_probe_hull_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
json_t *ts_probe_lobe(ts_probe *probe, const ts_hull_args *args, const ts_sg *g, ts_v3 n, u32 channel);
/* A pixel's specular reflection (probe_gloss.c): the first puts and sets its surface; the second puts the product of a
 * lobe of light with the surface's lobe, and returns the reflected light. */
ts_status ts_probe_put_gloss(ts_probe *probe, const ts_probe_seen *at, const ts_gpixel *pixel, json_t *object,
                             ts_glossy *glossy);
ts_v3 ts_probe_put_reflected(ts_probe *probe, json_t *object, const ts_glossy *glossy, const ts_sg *light);
/* The source of gathered light: triangles of reflective shadow maps, or lamps (probe_direct.c). Sets the members of
 * *source that describe it, checked, and the buffers that a pixel's answer needs. */
ts_status ts_probe_read_source(ts_probe *probe, ts_direct_args *source);
const ts_buffer_id *ts_probe_source_needed(const ts_probe *probe);
ts_status ts_probe_direct_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);

#endif
