/* What pipelines of many views share. */
#ifndef TS_METHODS_VIEWS_PIPELINES_H
#define TS_METHODS_VIEWS_PIPELINES_H
#include "../raster/pipelines.h"

/* Runs of steps (shared.c): maps of many views by an octree of views, which are not whole yet; maps that are, or are
 * asked as they are, by an octree, each by itself, of every leaf; and the light gathered through them. */
extern const ts_step ts_shared_views_run[], ts_shared_maps_run[], ts_own_maps_run[], ts_all_maps_run[], ts_gather_run[];

/* Indirect light by many views. */
ts_planner ts_views_plan;

/* Virtual point lights or particles: how many; in how many places at most; the area of the surfaces that they are on,
 * INFINITY: everywhere; and whether each is a view by itself, without a hierarchy. */
typedef struct {
	u64 n, n_places;
	double area;
	bool alone;
	u32 px; /* side of the maps of each */
} ts_expected_lights;
/* What their octrees and maps take, and after that the lists of gathering (view_sizes.c). */
void ts_expect_views(ts_expected *expected, const ts_scene *scene, const ts_params *params,
                     const ts_expected_lights *lights);
void ts_expect_gather(ts_expected *expected, const ts_scene *scene, const ts_params *params,
                      const ts_expected_lights *lights);

#endif
