/* Where scenes come from: each fills a build. The message is set by ts_build_fail. */
#ifndef TS_SCENE_SOURCES_H
#define TS_SCENE_SOURCES_H
#include "build.h"
#ifdef __cplusplus
extern "C" {
#endif

/* gltf.cc: a .gltf or .glb file. The node called `reflector` (may be NULL) and nodes with {"reflector": true} in their
 * extras become objects of their own, static, marked as reflectors. */
void ts_gltf_load(ts_build *build, const char *path, const char *reflector);

/* builtin.c: atrium, gallery, dining. */
bool ts_builtin_is(const char *spec);
void ts_builtin_make(ts_build *build, const char *spec, u32 seed);

/* reflectors.c: as many reflectors as the parameters say, on periodic paths (SPEC 0.3.8). */
void ts_reflectors_add(ts_build *build, const ts_params *params, const char *camera);

#ifdef __cplusplus
}
#endif
#endif
