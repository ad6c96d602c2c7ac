/* Node transforms of a scene file, applied to vertices, surfels, lights and cameras. Only + - * / and the square root
 * on binary32, in the order written (CONTRACT rule 4), so every build gives the same bits. */
#ifndef TS_SCENE_PLACE_H
#define TS_SCENE_PLACE_H
#include "kernels/base/vec.h"
#include "scene/scene.h"
#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
	f32 linear[9];   /* row by row */
	f32 origin[3];   /* world units */
	f32 cofactor[9]; /* of linear, scaled to a greatest element of 1: the inverse transpose up to a factor */
	f32 side;        /* 1, or -1 where the node mirrors, or 0 where it flattens */
} ts_place;

/* The world's own origin and axes. */
ts_place ts_place_identity(void);

/* From translation, rotation (a quaternion x y z w of any length above zero) and scale. */
ts_place ts_place_from_trs(const f32 translation[3], const f32 rotation[4], const f32 scale[3]);

/* From glTF's 4 by 4 matrix, column by column; the last row is taken to be 0 0 0 1. */
ts_place ts_place_from_matrix(const f32 matrix[16]);

/* The place of a node below another, by both their places. */
ts_place ts_place_compose(const ts_place *parent, const ts_place *local);

/* Whether every element is within +-2^24, which keeps all that follows finite. */
bool ts_place_is_sane(const ts_place *place);

/* A place as a record of scene.motion. */
ts_motion ts_place_motion(const ts_place *place);

/* A vertex in world space. Where the node flattens, the normal is zero; where it mirrors, the tangent's handedness
 * flips. */
ts_vertex ts_place_vertex(const ts_place *place, const ts_vertex *vertex);

/* A surfel in world space: the node's image of its ellipse, with half-axes at a right angle; where the node mirrors, u
 * and v are exchanged, so that the normal stays on its side. False where the node flattens. */
bool ts_place_surfel(const ts_place *place, const ts_surfel *from, ts_surfel *to);

/* The node's origin, and the unit direction of its -z, along which a light shines, or zero. */
void ts_place_aim(const ts_place *place, f32 position[3], f32 direction[3]);

/* The frame of a camera at the node: looks along -z with +y up, made orthonormal. False where the node leaves no y
 * or no z. */
bool ts_place_camera(const ts_place *place, ts_camera *camera);

#ifdef __cplusplus
}
#endif
#endif
