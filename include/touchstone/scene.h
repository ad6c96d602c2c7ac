/* SPDX-License-Identifier: Apache-2.0 */
/* Scenes: triangles, materials, textures, lights, cameras, reflectors and surfels. Immutable once opened.
 *
 * Surfels are records ts_surfel of records.def in world space: an ellipse by its centre and two half-axes, and its
 * colour. They belong to the scene; a scene may have surfels only, triangles only, or both. Those that ask for pixels
 * read them as the buffer scene.surfel; a scene without surfels has no such buffer. Every surfel of an opened scene has
 * finite floats, coordinates within 2^24, half-axes longer than 0 and at a right angle to each other; either may be
 * the longer. The normal is not stored: it is the unit vector of u x v, made by the kernel that sets a surfel up. */
#ifndef TOUCHSTONE_SCENE_H
#define TOUCHSTONE_SCENE_H
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <touchstone/context.h>
#include <touchstone/params.h>
#include <touchstone/records.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct ts_scene ts_scene;

/* The camera that every scene has: an eye that circles, as in the papers' tables. */
#define TS_CAMERA_CIRCLE "circle"

/* The animation that every scene has: everything stands still, as the nodes say. */
#define TS_ANIMATION_NONE "none"

/* How to open a scene, beside the parameters. All members but `bytes` may be 0. Coordinates must be finite and within
 * 2^24, the eye must not be its target, and a radius must be above 0. Rays find no places in built-in scenes: there
 * eye, mirrors and lamps stand by box and walls unless a member says otherwise. */
typedef struct {
	size_t bytes;          /* sizeof(ts_scene_options) */
	const char *camera;    /* name of a camera of the file; NULL: its first one, and without any an eye that rays place;
	                        * "circle": eye, mirrors and lamps by the scene's box and walls alone, the eye circling */
	const char *reflector; /* name of a node of the file to make a mirror of; NULL: those marked in extras */
	const float *eye;      /* x, y and z of the eye; NULL: the camera's */
	const float *target;   /* what that eye looks at; NULL: the middle of the room or of the thing */
	const char *animation; /* name of an animation of the file, which moves nodes; NULL: its first one; "none" */
	const char *path;      /* text file of keyframes along which the eye moves (METHODS 2); NULL: none */
	int own_fov;           /* not 0: the parameter eye.fov, even where the camera has a field of view */
	const float (*mirrors)[4]; /* balls that stand still, beside the reflectors: x, y, z and radius */
	uint32_t n_mirrors;
	const float *lamp; /* x, y and z of the lamp of shadows and indirect light; NULL: rays or the hall place the lamp */
} ts_scene_options;

/* Opens a scene. *scene is to be released by ts_scene_free; NULL on failure.
 *   spec     a built-in scene, a row of ts_builtin_at, optionally with ":triangles=COUNT" (10000 to 16000000;
 *            suffixes k and M; by default 300k) and ":texels=SIDE" (no texture is larger than SIDE a side: a power of
 *            two, 16 to 512; by default 512), that of surfels with ":surfels=COUNT"; or the path of a .gltf, .glb or
 *            .ply file. Files are untrusted: every count, offset and index is checked, and nothing outside the file's
 *            own folder is opened.
 *   params   reads reflectors.*, seed, eye.*, width and height: the added mirrors.
 *   options  NULL: all defaults.
 * The result does not depend on threads. */
TS_API ts_status ts_scene_open(ts_context *context, ts_scene **scene, const char *spec, const ts_params *params,
                               const ts_scene_options *options);

/* Opens a scene from the bytes of a .glb, .gltf or .ply file, which its first bytes tell. The bytes are not needed
 * afterwards. A .gltf that names files beside it is refused: data URIs, or a .glb, would be right.
 *   name     in messages and in traces; the others as for ts_scene_open. */
TS_API ts_status ts_scene_open_bytes(ts_context *context, ts_scene **scene, const void *file, size_t file_bytes,
                                     const char *name, const ts_params *params, const ts_scene_options *options);

/* An image that textures read: height rows of width RGBA texels, from the top, each side 1 to 65536. */
typedef struct {
	const uint8_t *rgba;
	uint32_t width, height;
	int srgb; /* not 0: red, green and blue are sRGB-coded */
} ts_image_array;

/* A camera with a name, for ts_scene_options.camera. The axes are unit vectors. */
typedef struct {
	const char *name;
	float eye[3], right[3], up[3], back[3]; /* world; the camera looks along -back */
	float yfov;                             /* vertical field of view in turns; 0: the parameter eye.fov */
} ts_camera_array;

/* A scene as the caller's arrays. All members but `bytes` may be 0. Padding and ts_object's first_vertex and n_vertices
 * are not read. */
typedef struct {
	size_t bytes;                 /* sizeof(ts_scene_arrays) */
	const char *name;             /* in messages and in traces; NULL: "arrays" */
	const ts_vertex *vertices;    /* each vertex names its object */
	const ts_triangle *triangles; /* three vertices of one object each */
	const ts_material *materials;
	const ts_slot *slots;
	const ts_image_array *images;
	const ts_light *lights;   /* none: a sun, as in a file without lights */
	const ts_object *objects; /* none: all vertices are of object 0, the static scene, which is no mirror. Any other
	                           * object is a mirror unless its reflector is TS_NO_INDEX */
	const ts_surfel *surfels;
	const ts_camera_array *cameras;
	uint32_t n_vertices, n_triangles, n_materials, n_slots, n_images, n_lights, n_objects, n_surfels, n_cameras;
} ts_scene_arrays;

/* Makes a scene of arrays, which are copied, as ts_scene_open makes one of a file: with the same checks, added mirrors,
 * and places that rays find.
 * In: options: reflector and animation must be NULL. */
TS_API ts_status ts_scene_make(ts_context *context, ts_scene **scene, const ts_scene_arrays *arrays,
                               const ts_params *params, const ts_scene_options *options);

/* Releases a scene; NULL is allowed. */
TS_API void ts_scene_free(ts_scene *scene);

/* Prints what was loaded, and what in the file was not understood: as text, or as JSON if json is not 0. */
TS_API ts_status ts_scene_print(const ts_scene *scene, FILE *out, int json);

/* A built-in scene, and one line on what it shows. */
typedef struct {
	const char *name, *doc;
} ts_builtin_info;

/* Built-in scene i, from 0; NULL behind the last. */
TS_API const ts_builtin_info *ts_builtin_at(size_t i);

#ifdef __cplusplus
}
#endif
#endif
