/* All kernels of the methods by points: EPR, iVIR, VIR, MVR and PCSS: for backends. */
#ifndef TS_KERNELS_POINTS_KERNELS_H
#define TS_KERNELS_POINTS_KERNELS_H
#include "align.h"
#include "composites.h"
#include "cube_size.h"
#include "cull_margin.h"
#include "environment_map.h"
#include "forward.h"
#include "lookup.h"
#include "mirror.h"
#include "mirror_pixel.h"
#include "pcss.h"
#include "scatter.h"
#include "shadow_cube_size.h"
#include "shadow_splat.h"
#include "splat_pieces.h"
#include "split.h"
#include "vectors.h"

#endif
