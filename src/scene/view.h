/* The eye. */
#ifndef TS_SCENE_VIEW_H
#define TS_SCENE_VIEW_H
#include "scene.h"

/* The eye of frame params->frame: the scene's chosen camera, or else circling the middle of the scene's box (SPEC 0.3.8).
 * near is 2^-10 of half the box's diagonal. */
void ts_view_eye(ts_view *view, const ts_scene *scene, const ts_params *params);

#endif
