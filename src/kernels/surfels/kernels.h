/* All kernels of deferred surface splatting: for backends. */
#ifndef TS_KERNELS_SURFELS_KERNELS_H
#define TS_KERNELS_SURFELS_KERNELS_H
#include "kernels/surfels/composites.h"
#include "kernels/surfels/deferred.h"
#include "kernels/surfels/deferred_margin.h"
#include "kernels/surfels/fragment_list.h"
#include "kernels/surfels/normal_field.h"
#include "kernels/surfels/surfel_blend_mean.h"
#include "kernels/surfels/surfel_blend_order.h"
#include "kernels/surfels/surfel_depth.h"
#include "kernels/surfels/surfel_margin.h"
#include "kernels/surfels/surfel_shade.h"
#include "kernels/surfels/surfel_shade_margin.h"

#endif
