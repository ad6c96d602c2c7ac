/* The eye, and where it and the added reflectors move. */
#ifndef TS_SCENE_VIEW_H
#define TS_SCENE_VIEW_H
#include "../kernels/base/vec.h"
#include "scene.h"

/* Frames in which the eye, and each added reflector, comes around once. */
#define TS_FRAMES_A_TURN 240u

/* A box by its middle and half its extents, world units. A flat one counts as 1/32 of its greatest extent thick, and
 * a point as two units wide: no half is 0. */
typedef struct {
	ts_v3 middle, half;
} ts_space;

/* The box of the scene. */
ts_space ts_view_box(const ts_info *info);

/* The hall: the box, but along x and along z no farther from its middle than 0.95 of the way to the first walls, and
 * its middle halfway between them. Where there are not walls on all four sides, as around a thing seen from outside,
 * the hall is the box. The walls are found once, when the scene is made (build_walls.c).
 *
 * Paths of the eye and of the reflectors are measured in the hall and not in the box: many a box is larger
 * than the room in it (a court among galleries, a nave among aisles), or beside it, and the eye would circle behind
 * walls. */
ts_space ts_view_hall(const ts_info *info);

/* The eye of frame params->frame: the scene's chosen camera, which stands still, or else circling the middle of the
 * hall (METHODS 2): one turn in 240 frames, from +x towards +z, on 0.35 or 0.9 of half the hall, at 0.35 of its
 * height, looking at its middle a little below.
 * near is 2^-10 of half the box's diagonal. Reads params->{frame, eye, fov, width, height}. */
void ts_view_eye(ts_view *view, const ts_info *info, const ts_params *params);

/* Makes `camera` the chosen one, or with NULL none: the eye circles. */
void ts_view_choose(ts_info *info, const ts_camera *camera);

#endif
