/* Conversion of numbers of a glTF file for the scene's records: rounded once to binary32, then sanitized (CONTRACT rule
 * 10); and the few values that need arithmetic. */
#ifndef TS_SCENE_GLTF_NUMBERS_H
#define TS_SCENE_GLTF_NUMBERS_H
#include "scene/scene.h"
#ifdef __cplusplus
extern "C" {
#endif

/* A JSON number: NaN gives 0, a number beyond binary32 gives +-2^62. */
f32 ts_number(double x);

/* Normalized integers, glTF 2.0 section 3.11. */
f32 ts_number_unorm8(u32 x);
f32 ts_number_unorm16(u32 x);
f32 ts_number_snorm8(i32 x);
f32 ts_number_snorm16(i32 x);

/* KHR_texture_transform as six coefficients: scale, then rotation (radians, counter-clockwise where v points down),
 * then offset. */
void ts_number_uv_transform(f32 transform[6], const f32 offset[2], f32 rotation, const f32 scale[2]);

/* KHR_lights_punctual: the cone of a spot light, half angles in radians, 0 <= inner < outer. */
void ts_number_cone(f32 *spot_scale, f32 *spot_offset, f32 inner, f32 outer);

/* Radians to turns. */
f32 ts_number_turns(f32 radians);

/* factor[3] times strength. */
void ts_number_scale3(f32 to[3], const f32 factor[3], f32 strength);

#ifdef __cplusplus
}
#endif
#endif
