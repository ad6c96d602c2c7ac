/* All kernels of deferred surface splatting: for backends. */
#ifndef TS_KERNELS_SURFELS_KERNELS_H
#define TS_KERNELS_SURFELS_KERNELS_H
#include "composites.h"
#include "deferred.h"
#include "deferred_margin.h"
#include "fragment_list.h"
#include "surfel_blend_mean.h"
#include "surfel_blend_order.h"
#include "surfel_depth.h"
#include "normal_field.h"
#include "surfel_margin.h"
#include "surfel_shade.h"
#include "surfel_shade_margin.h"

#endif
