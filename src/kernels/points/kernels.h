/* All kernels of the methods by points: EPR, iVIR, VIR, MVR and PCSS: for backends. */
#ifndef TS_KERNELS_POINTS_KERNELS_H
#define TS_KERNELS_POINTS_KERNELS_H
#include "kernels/points/align.h"
#include "kernels/points/composites.h"
#include "kernels/points/cube_size.h"
#include "kernels/points/cull_margin.h"
#include "kernels/points/environment_map.h"
#include "kernels/points/forward.h"
#include "kernels/points/lookup.h"
#include "kernels/points/mirror.h"
#include "kernels/points/mirror_pixel.h"
#include "kernels/points/pcss.h"
#include "kernels/points/scatter.h"
#include "kernels/points/shadow_cube_size.h"
#include "kernels/points/shadow_splat.h"
#include "kernels/points/splat_pieces.h"
#include "kernels/points/split.h"
#include "kernels/points/vectors.h"

#endif
