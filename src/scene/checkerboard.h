/* The built-in checkerboard as what its surfels are samples of. */
#ifndef TS_SCENE_CHECKERBOARD_H
#define TS_SCENE_CHECKERBOARD_H
#include <stdbool.h>
#include "../kernels/base/compat.h"

/* The albedo of the plane y = 0 at (x, z), which is seen from above; false beside the board. */
bool ts_checkerboard_at(f32 *albedo, f32 x, f32 z);

#endif
