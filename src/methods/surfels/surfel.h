/* What the stages of surfels share, and what others ask of them. */
#ifndef TS_STAGES_SURFELS_H
#define TS_STAGES_SURFELS_H
#include "../../kernels/surfels/deferred.h"
#include "../../kernels/surfels/surfel_shade.h"
#include "../stages.h"

/* How surfels are filtered, as arguments of kernels have it (surfel_setup.c). */
ts_filter ts_surfel_filter(const ts_run *run);
/* The parameter `surfel_blend.accumulation` asks for sums in the order of the surfels (fragment_list.c). */
bool ts_accumulates_in_order(const ts_params *params);
/* The parameter `deferred.shader` asks for shadows (deferred.c). */
bool ts_shader_has_shadows(const ts_params *params);
/* TS_SHADER_IS_*, as the parameter `deferred.shader` says (deferred.c). */
u32 ts_shader_of(const ts_params *params);
/* Arguments for who asks how stage `deferred` shades (deferred.c). */
ts_status ts_deferred_ask(const ts_run *run, ts_deferred_args *args);
/* How surfels are shaded that are shaded before they are blended, as arguments of kernels have it (surfel_shade.c). */
ts_surfel_shade_args ts_surfel_shading(const ts_run *run);

#endif
