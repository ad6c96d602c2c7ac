/* The switch of specular reflection, and values that its stages share with those of diffuse light. */
#ifndef TS_METHODS_HULLS_GLOSS_H
#define TS_METHODS_HULLS_GLOSS_H
#include "kernels/hulls/direct.h"
#include "kernels/hulls/hull.h"
#include "methods/stages.h"

bool ts_gloss_is_asked(const ts_params *params);

/* Arguments of the kernels hull and direct, without pointers. */
ts_hull_args ts_hull_values(const ts_run *run);
ts_direct_args ts_direct_values(const ts_run *run);

#endif
