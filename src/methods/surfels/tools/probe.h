/* What surfels answer to the probe. */
#ifndef TS_SURFELS_TOOLS_PROBE_H
#define TS_SURFELS_TOOLS_PROBE_H
#include "../../raster/tools/probe.h"

/* A pixel of surfels: what is nearest, what is blended and what that makes (probe_surfel.c). */
ts_status ts_probe_surfel_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
/* The same of methods that shade before they blend. */
ts_status ts_probe_shaded_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
/* Puts its light, and whether it is outlined; `lamps`: NULL without shadows (probe_deferred.c). */
ts_status ts_probe_put_deferred(ts_probe *probe, const ts_probe_lamps *lamps, u32 x, u32 y, json_t *object,
                                ts_v3 *total);

#endif
