/* Mip chains of the batch's cubes, from level 0. */
#ifndef TS_METHODS_RASTER_ILLUMINATE_H
#define TS_METHODS_RASTER_ILLUMINATE_H
#include "kernels/raster/texel_place.h"
#include "methods/stages.h"

extern const ts_launch ts_mip_averaged;
/* Makes levels 1 and up; `args` are those that made level 0. */
ts_status ts_mip_make(ts_run *run, ts_illuminate_args args);

#endif
