/* The shapes of the added reflectors: closed surfaces of revolution of about 2000 triangles. */
#ifndef TS_SCENE_SHAPES_H
#define TS_SCENE_SHAPES_H
#include "scene/build.h"

/* Appends one shape to the build's current object, around the origin; `radius` is that of the ball that holds it, world
 * units. shape: TS_SHAPE_SPHERE, _CYLINDER, _TORUS or _LATHE. Normals point outwards, and triangles are
 * counter-clockwise seen from outside. Failures stick to the build. */
void ts_shape_add(ts_build *build, u32 shape, f32 radius, u32 material);

#endif
