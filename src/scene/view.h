/* The eye, and the spaces in which the eye and the added reflectors move. */
#ifndef TS_SCENE_VIEW_H
#define TS_SCENE_VIEW_H
#include "kernels/base/vec.h"
#include "scene/scene.h"

/* Frames in which the eye, and each added reflector, makes one turn. */
#define TS_FRAMES_A_TURN 240u

/* How the eye moves: ts_info.circles. */
enum {
	TS_CIRCLES_NOT,     /* a chosen camera stands still */
	TS_CIRCLES_HALL,    /* in the hall; with eye.distance=outside as far off as the ball about the box needs */
	TS_CIRCLES_ROOM,    /* in the hall; with eye.distance=outside as near as the image holds the box */
	TS_CIRCLES_OUTSIDE, /* as TS_CIRCLES_ROOM, but with eye.distance=far outside, too */
	TS_CIRCLES_PATH,    /* along the scene's path, and then again from its first frame */
};

/* A box by its middle and half its extents, world units. A flat box counts as 1/32 of its greatest extent thick, and a
 * point as two units wide, so that no half extent is 0. */
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

/* The eye of frame params->frame on a path: behind its end the last pose, or as TS_CIRCLES_PATH says. With n 0, as
 * ts_view_eye. */
void ts_view_on_path(ts_view *view, const ts_info *info, const ts_path_eye *path, u32 n, const ts_params *params);

/* Frames after which the eye's motion repeats; 1 on a path of n frames that does not repeat and ends at rest. */
u32 ts_view_period(const ts_info *info, u32 n);

/* The axes of an eye that looks from one point at another; for an eye that looks straight up or down, right is +x. */
void ts_view_aim(f32 right[3], f32 up[3], f32 back[3], ts_v3 eye, ts_v3 target);

/* Whether there are no walls: the hall is as wide as the box, and the scene is a thing seen from outside. */
bool ts_view_is_open(const ts_info *info);

/* The unit direction from the eye through the point (x, y) of the image, in pixels from the top left. */
ts_v3 ts_view_way(const ts_view *view, f32 x, f32 y);
/* Where p is seen.
 * Returns: whether p is in front of the eye and in the image, by `margin` pixels or more.
 * Out:     *depth along the eye's axis. */
bool ts_view_holds(const ts_view *view, ts_v3 p, f32 margin, f32 *depth);

/* Makes `camera` the chosen one, or with NULL none: the eye circles. */
void ts_view_choose(ts_info *info, const ts_camera *camera);

#endif
