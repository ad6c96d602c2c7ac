/* What comparisons with depth maps share. */
#ifndef TS_METHODS_RESOLVE_H
#define TS_METHODS_RESOLVE_H
#include "../../kernels/raster/resolve.h"
#include "../stages.h"

/* The values of a comparison with the maps of the batch. */
ts_resolve_args ts_resolve_values(const ts_run *run);

#endif
