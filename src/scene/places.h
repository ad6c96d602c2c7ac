/* The options of a scene by name and text, as options of the command, lines of cases.txt and of params.txt say them. */
#ifndef TS_SCENE_PLACES_H
#define TS_SCENE_PLACES_H
#include "scene/sources.h"

enum { TS_MAX_MIRRORS = 64 };

/* It must not be moved: its options point into it, and to the texts, which are the caller's. */
typedef struct {
	ts_scene_options options;
	f32 eye[3], target[3], lamp[3], mirrors[TS_MAX_MIRRORS][4];
} ts_places;

/* Whether an option has that name: camera, eye, target, fov, reflector, mirror, lamp or animation. */
bool ts_place_is(const char *name);
/* Sets an option; a mirror is added. fov says that the parameter eye.fov holds, and sets no parameter. */
ts_status ts_place_set(ts_places *places, const char *name, const char *text);

#endif
