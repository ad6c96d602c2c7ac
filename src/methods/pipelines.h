/* The pipelines, a file each. */
#ifndef TS_PIPELINES_PIPELINES_H
#define TS_PIPELINES_PIPELINES_H
#include "pipeline.h"

/* Runs of steps (shared.c): eye and scene of the frame; the lights of shadows, their views, and what the eye sees; pictures
 * from depth maps; reflective shadow maps; what the eye sees, with its G-buffer. */
extern const ts_step ts_frame_run[], ts_soft_run[], ts_omni_run[], ts_resolve_run[], ts_rsm_run[], ts_gbuffer_run[];
/* Maps of many views: by an octree of views, each by itself, of every leaf; and the light gathered through them. */
extern const ts_step ts_shared_maps_run[], ts_own_maps_run[], ts_all_maps_run[], ts_gather_run[];

/* Cubes, their views and the reflective pixels, and how many of those; texels a side of a cube that adapts to the eye: twice
 * the size asked for, as mirrors come nearer than their average (reflections.c). */
u64 ts_expect_mirrors(ts_expected *expected, const ts_scene *scene, const ts_params *params);
u64 ts_expected_face(const ts_params *params);

extern const ts_step ts_epr_steps[], ts_epr_omni_steps[];
void ts_epr_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_mvr_steps[];
ts_planner ts_mvr_plan;
void ts_mvr_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_mvr_soft_steps[], ts_mvr_omni_steps[];

extern const ts_step ts_ivir_reflections_steps[], ts_ivir_soft_steps[], ts_ivir_omni_steps[];
ts_planner ts_ivir_plan;
ts_planner ts_ivir_soft_plan;
ts_planner ts_ivir_omni_plan;
void ts_ivir_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);
/* What points for cubes of so many texels a side take. */
void ts_expect_cubes(ts_expected *expected, const ts_scene *scene, const ts_params *params, u64 face);

extern const ts_step ts_pcss_steps[];
ts_planner ts_pcss_plan;
void ts_pcss_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);

ts_planner ts_vir_plan;
void ts_vir_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);
ts_planner ts_vir_soft_plan;
ts_planner ts_vir_omni_plan;
void ts_vir_omni_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);

/* Indirect light, by any method: the reflective shadow maps of its lights (indirect.c). */
ts_planner ts_indirect_plan;
void ts_indirect_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_hulls_steps[], ts_direct_steps[];
void ts_hulls_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_megaviews_steps[], ts_manylods_steps[], ts_bruteforce_steps[];
void ts_megaviews_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);
void ts_manylods_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_megaviews_particles_steps[], ts_manylods_particles_steps[], ts_bruteforce_particles_steps[];
ts_planner ts_particles_plan;
void ts_megaviews_particles_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);
void ts_manylods_particles_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);
extern const ts_step ts_surfels_steps[];
ts_planner ts_deferred_plan;
ts_planner ts_ewa_plan;
void ts_surfels_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);

/* Virtual point lights or particles: how many; in how many places at most; the area of the surfaces that they are on,
 * INFINITY: everywhere; and whether each is a view by itself, without a hierarchy. */
typedef struct { u64 n, n_places; double area; bool alone; } ts_expected_lights;
/* What octrees, maps and lists of them take (view_sizes.c). */
void ts_expect_views(ts_expected *expected, const ts_scene *scene, const ts_params *params,
                     const ts_expected_lights *lights);

/* All cubes, seen or not, of the largest size. */
void ts_plan_largest(ts_plan *plan, const ts_params *params);

/* Soft and omnidirectional shadows, by any method. */
ts_planner ts_soft_plan;
void ts_soft_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);
ts_planner ts_omni_plan;
void ts_omni_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);
/* Pieces and points of iVIR, where the densest view of a triangle has so many texels. */
void ts_expect_points(ts_expected *expected, const ts_scene *scene, u64 texels);

#endif
