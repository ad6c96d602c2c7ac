/* The eye. */
#ifndef TS_SCENE_VIEW_H
#define TS_SCENE_VIEW_H
#include "../kernels/vec.h"
#include "scene.h"

/* The eye of frame params->frame: the scene's chosen camera, which stands still, or else circling the middle of the
 * scene's box (SPEC 0.3.8): one turn in 240 frames, from +x towards +z, on 0.35 or 0.9 of half the box, at 0.35 of its
 * height, looking at its middle a little below.
 * near is 2^-10 of half the box's diagonal. Reads params->{frame, eye, fov, width, height}. */
void ts_view_eye(ts_view *view, const ts_scene *scene, const ts_params *params);

/* Half the extents of the scene's box, world units. A flat box counts as 1/32 of its greatest extent thick, and a
 * point as two units wide: none is 0. */
ts_v3 ts_view_half_box(const ts_scene *scene);

#endif
