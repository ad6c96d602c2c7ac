/* The pipelines, a file each. */
#ifndef TS_PIPELINES_PIPELINES_H
#define TS_PIPELINES_PIPELINES_H
#include "pipeline.h"

extern const ts_step ts_epr_steps[], ts_epr_omni_steps[];
void ts_epr_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_mvr_steps[];
void ts_mvr_prepare(ts_run *run);
void ts_mvr_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_mvr_soft_steps[], ts_mvr_omni_steps[];

extern const ts_step ts_ivir_reflections_steps[], ts_ivir_soft_steps[], ts_ivir_omni_steps[];
void ts_ivir_prepare(ts_run *run);
void ts_ivir_soft_prepare(ts_run *run);
void ts_ivir_omni_prepare(ts_run *run);
void ts_ivir_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);
/* What points for cubes of so many texels a side take. */
void ts_expect_cubes(ts_sizes *sizes, const ts_scene *scene, u64 face);

extern const ts_step ts_pcss_steps[];
void ts_pcss_prepare(ts_run *run);
void ts_pcss_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);

void ts_vir_prepare(ts_run *run);
void ts_vir_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);
void ts_vir_soft_prepare(ts_run *run);
void ts_vir_omni_prepare(ts_run *run);
void ts_vir_omni_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_hulls_steps[], ts_direct_steps[];
void ts_indirect_prepare(ts_run *run);
void ts_hulls_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_megaviews_steps[], ts_manylods_steps[], ts_bruteforce_steps[];
void ts_megaviews_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);
void ts_manylods_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);

extern const ts_step ts_megaviews_particles_steps[], ts_manylods_particles_steps[], ts_bruteforce_particles_steps[];
void ts_particles_prepare(ts_run *run);
void ts_megaviews_particles_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);
void ts_manylods_particles_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);
extern const ts_step ts_surfels_steps[];
void ts_deferred_prepare(ts_run *run);
void ts_ewa_prepare(ts_run *run);
void ts_surfels_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);

/* What octrees, maps and lists of so many lights take, which are in at most so many places; alone: without a hierarchy of
 * views. */
void ts_expect_views(ts_sizes *sizes, const ts_scene *scene, const ts_params *params, u64 n_lights, u64 n_places,
                     bool alone);

/* Soft and omnidirectional shadows, by any method. */
void ts_soft_prepare(ts_run *run);
void ts_soft_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);
void ts_omni_prepare(ts_run *run);
void ts_omni_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params);
/* Pieces and points of iVIR, where the densest view of a triangle has so many texels. */
void ts_expect_points(ts_sizes *sizes, const ts_scene *scene, u64 texels);

#endif
