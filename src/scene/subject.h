/* Finds by rays what pictures of a file should show (METHODS 4): a room from inside, or a thing from outside. */
#ifndef TS_SCENE_SUBJECT_H
#define TS_SCENE_SUBJECT_H
#include "model/param.h"
#include "scene/rays.h"

/* Crops the box to what stands on a wide and flat ground that is more than four times as large as the rest; otherwise
 * the box stays.
 * Args: info->box_* is the scene's.
 * Out:  info->box_* */
void ts_subject_crop(ts_info *info, const ts_scene *scene);

/* Chooses room or thing.
 * Args: info has box and hall (build_walls.c), and the chosen camera if there is one (info->circles is TS_CIRCLES_NOT).
 * Out:  info->box_*, info->hall_*: kept if the hall is enclosed, in sight and the eye in it is free; otherwise those of
 *       a room that rays found; otherwise the box as it is, and a hall as large. info->circles: as before if a
 *       camera is chosen, otherwise TS_CIRCLES_ROOM or TS_CIRCLES_OUTSIDE; where no circle is free in the room
 *       the eye stands still. */
void ts_subject_find(ts_info *info, const ts_rays *rays, const ts_scene *scene, const ts_params *params);

#endif
