/* Free places for the lamps of a file's scene, found by rays (METHODS 10, lamp). */
#ifndef TS_SCENE_LAMP_PLACE_H
#define TS_SCENE_LAMP_PLACE_H
#include "scene/lamp.h"
#include "scene/rays.h"

/* Finds places from which the lamps light what the eye of frame 0 sees: those that follow
 * from the hall, if they are free and light enough of it; else the best of a lattice of places.
 * Returns: false if the lamps stand at the places that follow from the hall.
 * Args:    given  NULL, or where both lamps must stand; then only the target is chosen. */
bool ts_lamp_place(ts_stand stands[TS_N_STANDS], const ts_info *info, const ts_rays *rays, const ts_params *params,
                   const f32 *given);

#endif
