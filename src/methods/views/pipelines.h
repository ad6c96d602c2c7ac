/* Declarations that pipelines of many views share. */
#ifndef TS_METHODS_VIEWS_PIPELINES_H
#define TS_METHODS_VIEWS_PIPELINES_H
#include "methods/raster/pipelines.h"

/* Runs of steps (shared.c): maps of many views by an octree of views, not yet fused; maps that are fused or looked up
 * as they are, by an octree, of each view by itself, or of every leaf; and the light gathered through the maps. */
extern const ts_step ts_shared_views_run[], ts_shared_maps_run[], ts_own_maps_run[], ts_all_maps_run[], ts_gather_run[];

/* Indirect light by many views. */
ts_planner ts_views_plan;

/* Virtual point lights or particles: their number; the greatest number of their places; the area of the surfaces on
 * which they are, INFINITY: anywhere; and whether each is a view by itself, without a hierarchy. */
typedef struct {
	u64 n, n_places;
	double area;
	bool alone;
	u32 px; /* side of the maps of each */
} ts_expected_lights;
/* Expects their octrees and maps, and after these the lists of gathering (view_sizes.c). */
void ts_expect_views(ts_expected *expected, const ts_scene *scene, const ts_params *params,
                     const ts_expected_lights *lights);
void ts_expect_gather(ts_expected *expected, const ts_scene *scene, const ts_params *params,
                      const ts_expected_lights *lights);

#endif
