/* Scenes: triangles, materials, textures, lights, cameras, reflectors and surfels. Immutable once opened.
 *
 * Surfels are records ts_surfel of records.def in world space: an ellipse by its centre and two half-axes, and its
 * colour. They belong to the scene; a scene may have surfels only, triangles only, or both. Those that ask for pixels
 * read them as the buffer scene.surfel; a scene without surfels has no such buffer. Every surfel of an opened scene has
 * finite floats, coordinates within 2^24, half-axes longer than 0 and at a right angle to each other; which is longer
 * is left open. The normal is not stored: it is the unit vector of u x v, made by the kernel that sets a surfel up. */
#ifndef TOUCHSTONE_SCENE_H
#define TOUCHSTONE_SCENE_H
#include <stdint.h>
#include <stdio.h>
#include <touchstone/params.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct ts_scene ts_scene;

/* The camera that every scene has: an eye that circles, as in the papers' tables. */
#define TS_CAMERA_CIRCLE "circle"

/* The animation that every scene has: all stands still, as the nodes say. */
#define TS_ANIMATION_NONE "none"

/* What of a scene is wanted, beside the parameters. Zero-initialise for defaults. Coordinates must be finite and within
 * 2^24, the eye must not be its target, and a radius must be above 0. Rays find places in files only: in a built-in
 * scene eye, mirrors and lamps stand by its box and walls where nothing is said. */
typedef struct {
	const char *camera;    /* name of a camera of the file; NULL: its first one, and without any an eye that rays place;
	                        * "circle": eye, mirrors and lamps by the scene's box and walls alone, the eye circling */
	const char *reflector; /* name of a node of the file to make a mirror of; NULL: those marked in extras */
	const float *eye;      /* x, y and z of an eye that stands there; NULL: the camera's */
	const float *target;   /* what that eye looks at; NULL: the middle of the room or of the thing */
	const char *animation; /* name of an animation of the file, which moves nodes; NULL: its first one; "none" */
	const char *path;      /* text file of keyframes along which the eye moves (METHODS 2); NULL: none */
	int own_fov;           /* not 0: the parameter eye.fov, even where the camera has a field of view */
	const float (*mirrors)[4]; /* balls that stand still, beside the reflectors: x, y, z and radius */
	uint32_t n_mirrors;
	const float *lamp; /* x, y and z of the lamp of shadows and indirect light; NULL: rays or the hall place it */
} ts_scene_options;

/* Opens a scene. Result in *scene, to be released with ts_scene_free; NULL on failure.
 *   spec     a built-in scene, a row of ts_builtin_table, optionally with ":triangles=COUNT" (10000 to 16000000;
 *            suffixes k and M; 300k unless said) and ":texels=SIDE" (no texture is larger than SIDE a side: a power of
 *            two, 16 to 512; 512 unless said), that of surfels with ":surfels=COUNT"; or the path of a .gltf, .glb or
 *            .ply file. Files are untrusted: every count, offset and index is checked, and nothing outside the file's
 *            own folder is opened.
 *   params   reads reflectors.*, seed, eye.*, width and height: the added mirrors.
 *   options  may be NULL.
 * The result does not depend on threads. */
TS_API ts_status ts_scene_open(ts_scene **scene, const char *spec, const ts_params *params,
                               const ts_scene_options *options);

/* Releases a scene; NULL is allowed. */
TS_API void ts_scene_free(ts_scene *scene);

/* What was loaded, and what in the file was not understood: as text, or as JSON if json is not 0. */
TS_API ts_status ts_scene_print(const ts_scene *scene, FILE *out, int json);

/* One row per built-in scene: name and a one-line description. *n receives the length. */
typedef struct {
	const char *name, *doc;
} ts_builtin_info;
TS_API const ts_builtin_info *ts_builtin_table(size_t *n);

#ifdef __cplusplus
}
#endif
#endif
