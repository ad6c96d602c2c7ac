/* All kernels of deferred surface splatting: for backends. */
#ifndef TS_KERNELS_SURFELS_KERNELS_H
#define TS_KERNELS_SURFELS_KERNELS_H
#include "blend_order.h"
#include "deferred.h"
#include "deferred_margin.h"
#include "fragment_list.h"
#include "surfel_depth.h"
#include "surfel_margin.h"
#include "surfel_mean.h"

#endif
