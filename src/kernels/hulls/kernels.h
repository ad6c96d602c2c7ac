/* All kernels of screen-space approximate Gaussian hulls: for backends. */
#ifndef TS_KERNELS_HULLS_KERNELS_H
#define TS_KERNELS_HULLS_KERNELS_H
#include "composites.h"
#include "corner.h"
#include "direct.h"
#include "gloss.h"
#include "hull.h"
#include "hull_margin.h"
#include "polygon.h"
#include "segment_box.h"
#include "vectors.h"

#endif
