/* Declarations that pipelines of the methods by points share. */
#ifndef TS_METHODS_POINTS_PIPELINES_H
#define TS_METHODS_POINTS_PIPELINES_H
#include "methods/raster/pipelines.h"

/* Soft and omnidirectional shadows, by any method (shadows.c). */
extern const ts_effect ts_effect_soft_shadows, ts_effect_omni_shadows;
ts_planner ts_soft_plan;
void ts_soft_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);
ts_planner ts_omni_plan;
void ts_omni_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);
/* The expected pieces and points of iVIR, if the densest view of a triangle has `texels` texels. */
void ts_expect_points(ts_expected *expected, const ts_scene *scene, u64 texels);

/* iVIR, whose steps are also those of VIR (ivir.c). */
extern const ts_step ts_ivir_reflections_steps[], ts_ivir_soft_steps[], ts_ivir_omni_steps[];
ts_planner ts_ivir_omni_plan;
/* The expected points for cubes of `face` texels per side. */
void ts_expect_cubes(ts_expected *expected, const ts_scene *scene, const ts_params *params, u64 face);

#endif
