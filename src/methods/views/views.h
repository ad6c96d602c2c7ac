/* Functions that the stages of many views share, or that others call. */
#ifndef TS_METHODS_VIEWS_VIEWS_H
#define TS_METHODS_VIEWS_VIEWS_H
#include "methods/stages.h"

typedef struct ts_particle_args ts_particle_args;
typedef struct ts_pyramid ts_pyramid;
typedef struct ts_view_map_fuse_args ts_view_map_fuse_args;
typedef struct ts_vpl_args ts_vpl_args;
typedef struct ts_vpl_gather_args ts_vpl_gather_args;

/* The side of a plan's maps must be a power of two; the levels of one of its maps (view_map.c). */
ts_status ts_view_map_check(const ts_run *run);
ts_pyramid ts_view_pyramid(const ts_params *params, const ts_plan *plan);
/* Arguments of fusion, without pointers. */
ts_view_map_fuse_args ts_view_map_fuse_values(const ts_run *run);
/* The level of the lists of vpl_gather.pairs (vpl_gather.c): vpl_gather.level, at most octree.levels; 0 if views have
 * no hierarchy, or nothing is culled. */
u32 ts_gather_level(const ts_run *run);
u32 ts_gather_level_of(const ts_params *params, u32 field, bool alone);
/* Whether gathering looks up fused maps (vpl_gather.c). */
bool ts_gather_asks_fused(const ts_params *params);
/* Whether paths begin at random on all surfaces (vpl.c). */
bool ts_vpl_at_random(const ts_params *params);
/* Arguments for callers that evaluate the making of virtual point lights and particles, and the gathering of pixels. */
/* Without offset and paths. */
ts_status ts_vpl_ask(const ts_run *run, ts_vpl_args *args);
ts_particle_args ts_particle_values(const ts_run *run);
ts_status ts_vpl_gather_ask(const ts_run *run, ts_vpl_gather_args *args);

#endif
