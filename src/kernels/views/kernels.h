/* All kernels of MegaViews, ManyLoDs and what they are compared with: for backends. */
#ifndef TS_KERNELS_VIEWS_KERNELS_H
#define TS_KERNELS_VIEWS_KERNELS_H
#include "kernels/views/bilateral.h"
#include "kernels/views/composites.h"
#include "kernels/views/cube_view.h"
#include "kernels/views/octree.h"
#include "kernels/views/octree_reflector.h"
#include "kernels/views/octree_surface.h"
#include "kernels/views/particle.h"
#include "kernels/views/view_map_colour.h"
#include "kernels/views/view_map_fuse.h"
#include "kernels/views/view_octree.h"
#include "kernels/views/view_octree_alone.h"
#include "kernels/views/view_octree_cone.h"
#include "kernels/views/voxel.h"
#include "kernels/views/vpl.h"
#include "kernels/views/vpl_gather_margin.h"
#include "kernels/views/vpl_gather_pairs.h"

#endif
