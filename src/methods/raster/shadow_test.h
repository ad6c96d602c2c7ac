/* Arguments that comparisons with depth maps share. */
#ifndef TS_METHODS_RASTER_SHADOW_TEST_H
#define TS_METHODS_RASTER_SHADOW_TEST_H
#include "kernels/raster/shadow_map.h"
#include "methods/stages.h"

/* The values of a comparison with the maps of the batch. */
ts_shadow_test_args ts_resolve_values(const ts_run *run);

#endif
