/* Sources of scenes, and what is added to them: each fills a build. Failures stick to the build, as in build.h. */
#ifndef TS_SCENE_SOURCES_H
#define TS_SCENE_SOURCES_H
#include "model/param.h"
#include "scene/build.h"
#include "scene/lamp.h"
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
/* From now on this process keeps what built-in scenes paint, at most 18 MB a scene, and paints it once: for commands
 * that open one such scene after another. */
void ts_builtin_keep(void);
/* Opens a built-in scene with the reflectors that params ask for; needs neither glTF nor JSON. wanted may be NULL.
 * *scene by ts_scene_free; NULL on failure, also where spec is no built-in scene. */
ts_status ts_builtin_open(ts_scene **scene, const char *spec, const ts_params *params, const ts_scene_options *wanted);

/* arrays.c: implements ts_scene_make. */
ts_status ts_scene_of_arrays(ts_scene **scene, const ts_scene_arrays *arrays, const ts_params *params,
                             const ts_scene_options *options);

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

/* lamp_place.c: free places for the lamps of a file's scene (METHODS 10, lamp). Finds places from which the lamps light
 * what the eye of frame 0 sees: those that follow from the hall, if they are free and light enough of it; else the best
 * of a lattice of places.
 * Returns: false if the lamps stand at the places that follow from the hall.
 * Args:    given  NULL, or where both lamps must stand; then only the target is chosen. */
bool ts_lamp_place(ts_stand stands[TS_N_STANDS], const ts_info *info, const ts_rays *rays, const ts_params *params,
                   const f32 *given);

/* path.c: an eye that moves along the keyframes of a text file (METHODS 2). Bounds of a file, which is untrusted: its
 * bytes, and the frames from 0 to its last keyframe. */
enum { TS_PATH_MAX_BYTES = 1 << 22, TS_PATH_MAX_FRAMES = 65536 };

/* Reads a file of keyframes, a line each: FRAME EX,EY,EZ TX,TY,TZ [FOV], FOV in degrees, of all keyframes or of none;
 * blank lines and what follows '#' count for nothing. Makes the eye of every frame, and a camera of that of frame 0.
 * Failures are the build's, with the number of the line.
 * Returns: the camera's name, or NULL if the build has failed.
 * Args:    own_fov  use the parameter eye.fov, whatever the file says. */
const char *ts_path_add(ts_build *build, const char *file, bool own_fov);

/* shapes.c: the shapes of the added reflectors, closed surfaces of revolution of about 2000 triangles. Appends one
 * shape to the build's current object, around the origin; `radius` is that of the ball that holds it, world units.
 * shape: TS_SHAPE_SPHERE, _CYLINDER, _TORUS or _LATHE. Normals point outwards, and triangles are counter-clockwise seen
 * from outside. Failures stick to the build. */
void ts_shape_add(ts_build *build, u32 shape, f32 radius, u32 material);

/* sample.c: surfels sampled from the triangles of a scene, surfels.from_mesh. Adds surfels to a build whose triangles
 * have been checked: about params->surfels_from_mesh of them, none if that is 0. Each triangle is aligned in its own
 * plane and sampled there as pieces are (EPR 3.2, 3.3; METHODS 2), by a lattice whose spacing, the same for all
 * triangles, gives that number over the whole area. A surfel is a circle in the triangle's plane of
 * params->surfels_radius spacings, coloured as the surface there: base colour times 1 - metallic, textures filtered to
 * the spacing. A double-sided triangle gets each surfel twice, the second turned over, unless params->surfels_sides
 * leaves the second out. Every triangle with an area gets at least one surfel, so fine meshes get more than were asked
 * for; every point of the triangle is within 1.6 spacings of a centre. The order is that of triangles, then of the
 * lattice, and does not depend on threads. */
void ts_sample_add(ts_build *build, const ts_params *params);

/* builtin/checkerboard.c: the exact pattern of the built-in checkerboard, of which its surfels are samples. The albedo
 * of the board, in the plane y = 0 and seen from above, at (x, z); false outside the board. */
bool ts_checkerboard_at(f32 *albedo, f32 x, f32 z);

/* subject.c: finds by rays what pictures of a file should show (METHODS 4), a room from inside, or a thing from
 * outside. Crops the box to what stands on a wide and flat ground that is more than four times as large as the rest;
 * otherwise the box stays.
 * Args: info->box_* is the scene's.
 * Out:  info->box_* */
void ts_subject_crop(ts_info *info, const ts_scene *scene);

/* Chooses room or thing.
 * Args: info has box and hall (build_walls.c), and the chosen camera if there is one (info->circles is TS_CIRCLES_NOT).
 * Out:  info->box_*, info->hall_*: kept if the hall is enclosed, in sight and the eye in it is free; otherwise those of
 *       a room that rays found; otherwise the box as it is, and a hall as large. info->circles: as before if a
 *       camera is chosen, otherwise TS_CIRCLES_ROOM or TS_CIRCLES_OUTSIDE; where no circle is free in the room
 *       the eye stands still. */
void ts_subject_find(ts_info *info, const ts_rays *rays, const ts_scene *scene, const ts_params *params);

#ifdef __cplusplus
}
#endif
#endif
