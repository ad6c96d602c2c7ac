/* Declarations that pipelines of several families share. */
#ifndef TS_METHODS_RASTER_PIPELINES_H
#define TS_METHODS_RASTER_PIPELINES_H
#include "methods/pipeline.h"

/* Runs of steps (shared.c): eye and scene of the frame; the lights of shadows, their views, and the eye's picture;
 * pictures from depth maps; reflective shadow maps; the eye's picture with its G-buffer. */
extern const ts_step ts_frame_run[], ts_soft_run[], ts_omni_run[], ts_resolve_run[], ts_rsm_run[], ts_gbuffer_run[];

/* Indirect light, by any method: the reflective shadow maps of its lights (indirect.c). */
extern const ts_effect ts_effect_indirect;
ts_planner ts_indirect_plan;
void ts_indirect_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params);

/* Reflections (reflections.c): cubes, their views and the reflective pixels, and their expected number; texels per side
 * of a cube that adapts to the eye: twice the size asked for, since mirrors come nearer than their average. */
extern const ts_effect ts_effect_reflections;
u64 ts_expect_mirrors(ts_expected *expected, const ts_scene *scene, const ts_params *params);
u64 ts_expected_face(const ts_params *params);
/* Plans all cubes, seen or not, in the largest size. */
void ts_plan_largest(ts_plan *plan, const ts_params *params);

#endif
