/* What hulls and the light that they approximate answer to the probe. */
#ifndef TS_HULLS_TOOLS_PROBE_H
#define TS_HULLS_TOOLS_PROBE_H
#include "../../../kernels/hulls/hull.h"
#include "../../../probe/parts.h"

/* A pixel's irradiance by hulls (probe_hull.c), of one channel from its lobe (probe_lobe.c); and by direct
 * (probe_direct.c). */
ts_status ts_probe_hull_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
json_t *ts_probe_lobe(ts_probe *probe, const ts_hull_args *args, const ts_sg *g, ts_v3 n, u32 channel);
ts_status ts_probe_direct_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);

#endif
