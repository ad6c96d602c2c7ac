/* Building a scene: loaders and generators append, ts_build_finish checks and completes. Failures stick: after the
 * first one every call does nothing, and ts_build_finish reports it. */
#ifndef TS_SCENE_BUILD_H
#define TS_SCENE_BUILD_H
#include <stdbool.h>
#include "kernels/base/vec.h"
#include "scene/scene.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct ts_build ts_build;

/* Bounds of an animation in a file: frames, and frames times objects. */
#define TS_MOTION_MAX_FRAMES 65536u
#define TS_MOTION_MAX_PLACES 4194304u

/* NULL on out of memory. Starts with object 0, the static scene, and no material. */
ts_build *ts_build_new(const char *name);
/* Releases a build that will not be finished; NULL is allowed. */
void ts_build_free(ts_build *build);

/* Appending returns the new index, or 0 if the build has failed. Records are copied, padding becomes zero, floats are
 * sanitized (rule 10), normals, tangents and directions are made unit length (zero stays zero). Indices may name what
 * is appended later: ts_build_finish checks them. */

/* A vertex of the current object. Its colours, and those of surfels, are clamped to 0 to 1, and this is noted. */
u32 ts_build_vertex(ts_build *build, const ts_vertex *vertex);
/* As ts_build_vertex, of an object that the file moves: `vertex` is in world space at frame 0, `own` in the object's
 * space. */
u32 ts_build_vertex_moving(ts_build *build, const ts_vertex *vertex, const ts_vertex *own);
/* Moves the vertices from `first` on. */
void ts_build_move(ts_build *build, u32 first, ts_v3 by);
/* Counter-clockwise seen from the front; material TS_NONE is a default one. */
void ts_build_triangle(ts_build *build, u32 a, u32 b, u32 c, u32 material);
/* Base colour, metallic, roughness and occlusion outside 0 to 1 are clamped and noted. */
u32 ts_build_material(ts_build *build, const ts_material *material);
/* A material's reference to an image. */
u32 ts_build_slot(ts_build *build, const ts_slot *slot);
/* The first light replaces the default sun. */
void ts_build_light(ts_build *build, const ts_light *light);
/* Both half-axes must be at right angles and longer than 0, every float finite: the loader's to check. */
u32 ts_build_surfel(ts_build *build, const ts_surfel *surfel);
/* Name and path are copied; of several cameras with one name the first can be chosen. */
void ts_build_camera(ts_build *build, const ts_camera *camera);
/* Notes a node of the file that has a name, which is copied, and triangles; parents come first. */
void ts_build_node(ts_build *build, const char *name, u64 n_triangles);
/* Vertices from here on belong to this object: first_vertex, n_vertices and reflector are filled in. With
 * `object` NULL they belong to object 0 again. Returns the object's index. */
u32 ts_build_object(ts_build *build, const ts_object *object, bool is_reflector);

/* Makes an existing object the current one, to which vertices appended from now on belong. */
void ts_build_select(ts_build *build, u32 object);
/* Sets the motion of the current object: n places, one a frame, with the same n for all moving objects. All its
 * vertices must be appended by ts_build_vertex_moving. */
void ts_build_motion(ts_build *build, const ts_motion *frames, u32 n);

/* Appends an image with its mip chain (CONTRACT rule 37). rgba: width * height * 4 bytes, rows from the top, each side
 * 1 to 65536; srgb: red, green and blue are sRGB-coded. The caller keeps rgba. */
u32 ts_build_image(ts_build *build, const u8 *rgba, u32 width, u32 height, bool srgb);

/* A default for every field: white, roughness 1, metallic 0, no texture, opaque. */
ts_material ts_material_default(void);

/* The coordinates that are appended are counted from that point of the file's: those of options are in the file's. */
void ts_build_origin(ts_build *build, const double origin[3]);

/* Notes one line, cleaned by ts_line_clean, for `touchstone info`: something in the file that is ignored or changed. */
void ts_build_note(ts_build *build, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Fails the build with one line, unless it has failed already. */
void ts_build_fail(ts_build *build, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Failures from here on are of that kind: at first of TS_KIND_ARGUMENT. Returns the kind before. */
ts_kind ts_build_about(ts_build *build, ts_kind kind);
/* Fails with this thread's message, and its kind. */
void ts_build_adopt(ts_build *build);
/* Whether the build has failed, so that a long loop can end; it fails here once its work is cancelled. */
bool ts_build_failed(ts_build *build);

/* Whether the object belongs to the scene itself, at rest or moved by the file, and is no reflector. */
static inline bool ts_build_is_own(const ts_scene *scene, u32 object)
{
	return scene->objects[object].reflector == TS_NONE;
}

/* The scene so far, to read: its arrays (valid until the next append), its box and its hall. */
const ts_scene *ts_build_peek(ts_build *build);

/* Checks every index, refuses coordinates beyond 2^24, adds the default sun if there is no light, sorts the vertices by
 * object (stable), chooses the camera by name (NULL: the eye circles), and hands over *scene, to be released by
 * ts_scene_free. A scene may have no triangles. Always consumes the build; NULL (ts_build_new failed) is allowed and
 * fails. On failure *scene is NULL and the message is set. */
ts_status ts_build_finish(ts_build *build, const ts_params *params, const char *camera, ts_scene **scene);

/* The first camera of that name; TS_NONE if there is none or name is NULL. */
u32 ts_scene_camera(const ts_scene *scene, const char *name);

#ifdef __cplusplus
}
#endif
#endif
