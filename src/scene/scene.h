/* The scene as the stages see it: plain arrays of records.def's records. */
#ifndef TS_SCENE_SCENE_H
#define TS_SCENE_SCENE_H
#include <touchstone/scene.h>
#include "kernels/base/records.h"
#include "model/param.h"

#define TS_COORDINATE_LIMIT 16777216.0f /* of any coordinate in the world */

typedef struct {
	char *name;
	f32 eye[3], right[3], up[3], back[3]; /* world */
	f32 yfov;                             /* turns */
	ts_path_eye *path;                    /* of a camera that the file moves: its pose in each frame, repeated */
	u32 n_path;
} ts_camera;

/* A node of the file that has a name, which the option `reflector` takes, and triangles at or below it. */
typedef struct {
	char *name;
	u64 n_triangles;
} ts_named_node;

struct ts_scene {
	char *name;
	ts_vertex *vertices;
	u32 n_vertices;
	ts_triangle *triangles;
	u32 n_triangles;
	ts_material *materials;
	u32 n_materials;
	ts_slot *slots;
	u32 n_slots;
	ts_image *images;
	u32 n_images;
	u64 *texels;
	u64 n_texels;
	ts_light *lights;
	u32 n_lights;
	ts_object *objects;
	u32 n_objects;
	ts_surfel *surfels;
	u32 n_surfels; /* a scene may have these only, or triangles only, or both */
	ts_stand *stands;
	u32 n_stands;         /* TS_N_STANDS, or 0: the places of the shadow lamps follow from the hall */
	ts_path_eye *path;    /* the eye of each frame */
	u32 n_path;           /* 0: the eye stands still or circles */
	ts_motion *motion;    /* by frame, then by object; vertices of objects in motion are in object space */
	u32 n_motion;         /* frames, after which the motion repeats; 0: the file moves nothing */
	bool is_checkerboard; /* the surfels are those of builtin/checkerboard.c */
	ts_info info;
	ts_camera *cameras;
	u32 n_cameras;
	ts_named_node *nodes; /* parents first */
	u32 n_nodes;
	u32 camera;           /* the chosen one; TS_NONE: the eye circles */
	u64 n_triangles_file; /* triangles before mirrors were added */
	u64 n_degenerate;     /* zero-area triangles among them */
	double origin[3];     /* what was subtracted from the file's coordinates, and from those of options */
	char **notes;
	u32 n_notes; /* lines about parts of the file that are ignored or changed */
};

/* What ts_scene_open does (open/open.c). */
ts_status ts_scene_load(ts_scene **scene, const char *spec, const ts_params *params, const ts_scene_options *options);

/* Indices into ts_scene.stands. */
enum { TS_STAND_SPOT, TS_STAND_BALL, TS_N_STANDS };

/* Indices into ts_material's slot. Flags, wrap modes and kinds of light: kernels/base/scene.h, texture.h, shade.h. */
enum { TS_SLOT_BASE, TS_SLOT_METALROUGH, TS_SLOT_NORMAL, TS_SLOT_OCCLUSION, TS_SLOT_EMISSIVE, TS_N_SLOTS };

#endif
