/* All kernels of screen-space approximate Gaussian hulls: for backends. */
#ifndef TS_KERNELS_HULLS_KERNELS_H
#define TS_KERNELS_HULLS_KERNELS_H
#include "kernels/hulls/composites.h"
#include "kernels/hulls/corner.h"
#include "kernels/hulls/direct.h"
#include "kernels/hulls/gloss.h"
#include "kernels/hulls/hull.h"
#include "kernels/hulls/hull_margin.h"
#include "kernels/hulls/polygon.h"
#include "kernels/hulls/segment_box.h"
#include "kernels/hulls/vectors.h"

#endif
