/* All kernels of MegaViews, ManyLoDs and what they are compared with: for backends. */
#ifndef TS_KERNELS_VIEWS_KERNELS_H
#define TS_KERNELS_VIEWS_KERNELS_H
#include "bilateral.h"
#include "composites.h"
#include "cube_view.h"
#include "octree.h"
#include "octree_reflector.h"
#include "octree_surface.h"
#include "particle.h"
#include "view_map_colour.h"
#include "view_map_fuse.h"
#include "view_octree.h"
#include "view_octree_alone.h"
#include "view_octree_cone.h"
#include "voxel.h"
#include "vpl.h"
#include "vpl_gather_margin.h"
#include "vpl_gather_pairs.h"

#endif
