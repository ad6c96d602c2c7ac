/* All kernels of standard rasterization, which the other families share: for backends. */
#ifndef TS_KERNELS_RASTER_KERNELS_H
#define TS_KERNELS_RASTER_KERNELS_H
#include "kernels/raster/cube_face.h"
#include "kernels/raster/depth_map.h"
#include "kernels/raster/eye.h"
#include "kernels/raster/gbuffer.h"
#include "kernels/raster/illuminate.h"
#include "kernels/raster/image.h"
#include "kernels/raster/indirect.h"
#include "kernels/raster/margin.h"
#include "kernels/raster/rsm.h"
#include "kernels/raster/shadow_test.h"
#include "kernels/raster/shadow_test_margin.h"

#endif
