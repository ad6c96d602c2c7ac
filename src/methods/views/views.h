/* What the stages of many views share, and what others ask of them. */
#ifndef TS_STAGES_VIEWS_H
#define TS_STAGES_VIEWS_H
#include "../../kernels/views/particle.h"
#include "../../kernels/views/vpl_gather.h"
#include "../../kernels/views/vpl.h"
#include "../stages.h"

/* The side of a plan's maps must be a power of two; the levels of one of its maps (view_map.c). */
ts_status ts_view_px_check(const ts_run *run);
ts_pyramid ts_view_pyramid(const ts_params *params, const ts_plan *plan);
/* How maps are fused, without pointers. */
ts_view_map_fuse_args ts_view_map_fuse_values(const ts_run *run);
/* The level of the lists of vpl_pairs (vpl_gather.c): vpl_gather.level, at most levels; 0 where views have no
 * hierarchy, alone, or nothing is culled. */
u32 ts_gather_level(const ts_run *run);
u32 ts_gather_level_of(const ts_params *params, u32 field, bool alone);
/* Maps are fused, and gathering asks whole ones (vpl_gather.c). */
bool ts_gather_asks_fused(const ts_params *params);
/* Paths begin at random on all surfaces (vpl.c). */
bool ts_vpl_at_random(const ts_params *params);
/* Arguments for who asks how virtual point lights and particles are made, and how pixels gather from them. */
/* Without offset and paths. */
ts_status ts_vpl_ask(const ts_run *run, ts_vpl_args *args);
ts_particle_args ts_particle_values(const ts_run *run);
ts_status ts_vpl_gather_ask(const ts_run *run, ts_vpl_gather_args *args);

#endif
