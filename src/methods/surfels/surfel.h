/* Functions that the stages of surfels share, or that others call. */
#ifndef TS_METHODS_SURFELS_SURFEL_H
#define TS_METHODS_SURFELS_SURFEL_H
#include "kernels/surfels/deferred.h"
#include "kernels/surfels/surfel_shade.h"
#include "methods/stages.h"

/* The filter of surfels, for arguments of kernels (surfel_setup.c). */
ts_filter ts_surfel_filter(const ts_run *run);
/* Whether `surfel_blend.accumulation` asks for sums in the order of the surfels (fragment_list.c). */
bool ts_accumulates_in_order(const ts_params *params);
/* Whether `deferred.shader` asks for shadows (deferred.c). */
bool ts_shader_has_shadows(const ts_params *params);
/* Whether it asks for tones and outlines. */
bool ts_shader_is_npr(const ts_params *params);
/* Arguments for callers that evaluate the shading of stage `deferred` (deferred.c). */
ts_status ts_deferred_ask(const ts_run *run, ts_deferred_args *args);
/* The shading of surfels that are shaded before they are blended, for arguments of kernels (surfel_shade.c). */
ts_surfel_shade_args ts_surfel_shading(const ts_run *run);

#endif
