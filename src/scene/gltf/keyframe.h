/* Interpolation between the keyframes of an animation (glTF 2.0 appendix C; METHODS 2). Only the kernels' arithmetic
 * (CONTRACT rule 4) is used, so every build gives the same bits. */
#ifndef TS_SCENE_GLTF_KEYFRAME_H
#define TS_SCENE_GLTF_KEYFRAME_H
#include "scene/scene.h"
#ifdef __cplusplus
extern "C" {
#endif

/* Frames of an animation of so many seconds, 30 a second and at least 1; seconds are from 0 to 2^16. */
u32 ts_keyframe_count(f32 seconds);
/* The time of a frame, in seconds. */
f32 ts_keyframe_time(u32 frame);

/* Linear interpolation of n numbers: a at s = 0, b at s = 1. */
void ts_keyframe_line(f32 *to, const f32 *a, const f32 *b, u32 n, f32 s);
/* Spherical interpolation on the shorter arc between quaternions of any length above 0. */
void ts_keyframe_turn(f32 to[4], const f32 a[4], const f32 b[4], f32 s);
/* n numbers on the Hermite cubic from a, with slope `from`, to b, with slope `into`. Slopes are per second; the
 * keyframes are `seconds` apart. */
void ts_keyframe_cubic(f32 *to, const f32 *a, const f32 *from, const f32 *into, const f32 *b, u32 n, f32 s,
                       f32 seconds);

#ifdef __cplusplus
}
#endif
#endif
