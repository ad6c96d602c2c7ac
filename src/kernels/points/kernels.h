/* All kernels of the methods by points: EPR, iVIR, VIR, MVR and PCSS: for backends. */
#ifndef TS_KERNELS_POINTS_KERNELS_H
#define TS_KERNELS_POINTS_KERNELS_H
#include "align.h"
#include "copy.h"
#include "cull_margin.h"
#include "lookup.h"
#include "mirror.h"
#include "pcss.h"
#include "pixel.h"
#include "resize.h"
#include "scatter.h"
#include "shadow_resize.h"
#include "shadow_splat.h"
#include "splat_pieces.h"
#include "split.h"
#include "vectors.h"

#endif
