/* Light on surfaces of one material in vector lanes, with the bits of ts_k_shade_lit. */
#ifndef TS_BACKENDS_C_RASTER_LIGHT_BATCH_H
#define TS_BACKENDS_C_RASTER_LIGHT_BATCH_H
#include "backends/c/raster/surface_batch.h"
#include "kernels/base/shade.h"

/* Outgoing radiance of the surfaces `s` of the batch `of`, towards the viewers. lamps may be NULL if of->lit is. */
void ts_light_batch(ts_lanes3 *radiance, const ts_arrays *scene, const ts_lamp *lamps, const ts_surface_batch *of,
                    const ts_surfaces *s);

#endif
