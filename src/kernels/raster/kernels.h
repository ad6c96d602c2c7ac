/* All kernels of standard rasterization, which the other families share: for backends. */
#ifndef TS_KERNELS_RASTER_KERNELS_H
#define TS_KERNELS_RASTER_KERNELS_H
#include "cube_face.h"
#include "depth_map.h"
#include "eye.h"
#include "gbuffer.h"
#include "illuminate.h"
#include "image.h"
#include "indirect.h"
#include "margin.h"
#include "rsm.h"
#include "shadow_test.h"
#include "shadow_test_margin.h"

#endif
