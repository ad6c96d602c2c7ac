/* Sources of scenes: each fills a build. Failures stick to the build, as in build.h. */
#ifndef TS_SCENE_SOURCES_H
#define TS_SCENE_SOURCES_H
#include "scene/build.h"
#include "scene/rays.h"
#ifdef __cplusplus
extern "C" {
#endif

/* The file of a scene. */
typedef struct {
	const char *name;  /* its path, unless it is in memory */
	const void *bytes; /* NULL: not in memory */
	size_t n_bytes;
} ts_scene_file;

/* gltf.cc: a .gltf or .glb file. The node called `reflector` (may be NULL) and nodes with {"reflector": true} in their
 * extras become objects of their own, marked as reflectors. So do nodes that the animation of that name moves (NULL:
 * the file's first; TS_ANIMATION_NONE: none), unmarked; reflectors on them move with them. Points without a size get
 * the mean distance to `neighbours` nearest points of their primitive, 1 to TS_MAX_NEIGHBOURS. */
void ts_gltf_load(ts_build *build, const ts_scene_file *file, const char *reflector, const char *animation,
                  u32 neighbours);

/* ply.c: a .ply file of points. `neighbours` as in ts_gltf_load, but of all points; missing normals are estimated. */
void ts_ply_load(ts_build *build, const ts_scene_file *file, u32 neighbours);

/* open.c: implements ts_scene_open_bytes. */
ts_status ts_scene_of_bytes(ts_scene **scene, const ts_scene_file *file, const ts_params *params,
                            const ts_scene_options *options);

/* builtin.c: whether spec is NAME or NAME:OPTIONS, NAME being one of ts_builtin_at. */
bool ts_builtin_is(const char *spec);
/* The names as words, "a, b and c", for a message. Cut to text_bytes. */
void ts_builtin_names(char *text, size_t text_bytes);
/* Fills a build with the scene that spec, for which ts_builtin_is is true, names. Reads params->{seed,
 * surfels.radius}. */
void ts_builtin_make(ts_build *build, const char *spec, const ts_params *params);
/* Opens a built-in scene with the reflectors that params ask for; needs neither glTF nor JSON. wanted may be NULL.
 * *scene by ts_scene_free; NULL on failure, also where spec is no built-in scene. */
ts_status ts_builtin_open(ts_scene **scene, const char *spec, const ts_params *params, const ts_scene_options *wanted);

/* arrays.c: implements ts_scene_make. */
ts_status ts_scene_of_arrays(ts_scene **scene, const ts_scene_arrays *arrays, const ts_params *params,
                             const ts_scene_options *options);

/* ground.c: a square under the box of a scene. */
void ts_ground_add(ts_build *build, const ts_info *info);

/* reflectors.c: as many reflectors as the parameters say, on periodic paths (METHODS 4). With `rays`
 * each is at a free place at frame 0; NULL: their places follow from the hall alone. */
void ts_reflectors_add(ts_build *build, const ts_params *params, const char *camera, const ts_rays *rays);
/* Adds reflecting balls at rest: x, y, z and radius of each. */
void ts_reflectors_stand(ts_build *build, const f32 (*mirrors)[4], u32 n);

/* arrange.c: adds eye, mirrors and lamps, as the options say, after the triangles of a scene. With `find`, as for
 * files, rays find the places that the options leave open, and a ground is added if the parameter asks for it. Box,
 * hall and eye are those of the scene before ground and mirrors are added.
 * Returns: the name of the chosen camera, which belongs to the build; NULL: none. */
const char *ts_arrange(ts_build *build, const ts_params *params, const ts_scene_options *options, bool find);

#ifdef __cplusplus
}
#endif
#endif
