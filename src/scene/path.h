/* An eye that moves along the keyframes of a text file (METHODS 2). */
#ifndef TS_SCENE_PATH_H
#define TS_SCENE_PATH_H
#include "scene/build.h"

/* Bounds of a file, which is untrusted: its bytes, and the frames from 0 to its last keyframe. */
enum { TS_PATH_MAX_BYTES = 1 << 22, TS_PATH_MAX_FRAMES = 65536 };

/* Reads a file of keyframes, a line each: FRAME EX,EY,EZ TX,TY,TZ [FOV], FOV in degrees, of all keyframes or of none;
 * blank lines and what follows '#' count for nothing. Makes the eye of every frame, and a camera of that of frame 0.
 * Failures are the build's, with the number of the line.
 * Returns: the camera's name, or NULL if the build has failed.
 * Args:    own_fov  use the parameter eye.fov, whatever the file says. */
const char *ts_path_add(ts_build *build, const char *file, bool own_fov);

#endif
