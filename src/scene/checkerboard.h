/* The exact pattern of the built-in checkerboard, of which its surfels are samples. */
#ifndef TS_SCENE_CHECKERBOARD_H
#define TS_SCENE_CHECKERBOARD_H
#include <stdbool.h>
#include "kernels/base/compat.h"

/* The albedo of the board, in the plane y = 0 and seen from above, at (x, z); false outside the board. */
bool ts_checkerboard_at(f32 *albedo, f32 x, f32 z);

#endif
