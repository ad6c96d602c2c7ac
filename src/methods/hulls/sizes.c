/* Computed sizes of hulls. */
#include "methods/registry.h"

u64 ts_size_grid_side(const ts_size_question *q) { return TS_PARAM(&q->run->params, depth_grid_px); }
