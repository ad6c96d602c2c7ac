/* All kernels of standard rasterization, which the other families share: for backends. */
#ifndef TS_KERNELS_RASTER_KERNELS_H
#define TS_KERNELS_RASTER_KERNELS_H
#include "draw.h"
#include "image.h"
#include "indirect.h"
#include "margin.h"
#include "resolve.h"
#include "resolve_margin.h"

#endif
