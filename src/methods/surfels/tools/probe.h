/* Answers of the probe about surfels. */
#ifndef TS_METHODS_SURFELS_TOOLS_PROBE_H
#define TS_METHODS_SURFELS_TOOLS_PROBE_H
#include "methods/raster/tools/probe.h"

/* A pixel of surfels: the nearest surfel, the blended surfels and the result (probe_surfel.c). */
ts_status ts_probe_surfel_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
/* A pixel of methods that shade before they blend. */
ts_status ts_probe_shaded_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
/* Puts the light of a pixel, and whether it is outlined; lamps: NULL without shadows (probe_deferred.c). */
ts_status ts_probe_put_deferred(ts_probe *probe, const ts_probe_lamps *lamps, u32 x, u32 y, json_t *object,
                                ts_v3 *total);

#endif
