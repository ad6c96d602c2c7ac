/* Functions that stages share. */
#ifndef TS_METHODS_STAGES_H
#define TS_METHODS_STAGES_H
#include "kernels/base/scene.h"
#include "methods/stage.h"

/* For launches that need the places of triangles, but not their materials. */
#define TS_BUT_SURFACES TS_BUT(scene.slots), TS_BUT(scene.images), TS_BUT(scene.texels), TS_BUT(scene.lights)

/* Shared by the stages (run.c). The arrays of the frame that shading kernels read; the vertices are this frame's. */
ts_arrays ts_run_arrays(const ts_run *run);
/* ts_run_arrays without pointers, for launches that bind them. */
ts_arrays ts_run_scene(const ts_run *run);
const ts_info *ts_run_info(const ts_run *run);
/* The factor of display values, beside the exposure, for gathered light, since one bounce is dim. */
f32 ts_image_gain(const ts_run *run);
/* The largest cube face that adapts to the eye: cube.max_px, at most half the eye's height, at least 16. */
u32 ts_largest_face(const ts_params *params);
/* Whether a buffer was made; it may be empty. */
bool ts_run_made(const ts_run *run, ts_buffer_id id);
/* Whether a buffer was made and is not empty. */
bool ts_run_has(const ts_run *run, ts_buffer_id id);
/* Whether the off-screen views are faces of cubes. */
bool ts_run_has_cubes(const ts_run *run);
/* The off-screen views of the batch. */
void ts_run_views(const ts_run *run, u32 *first, u32 *n);
/* A face of a cube as a view, of the light or TS_NONE (offscreen.c). */
void ts_offscreen_of_face(ts_offscreen *view, const ts_face *cube, u32 face, u32 light);
/* The number of views from a light's middle, six for a point light; and the stage's views for all lamps (lamp.c). */
u32 ts_light_views(const ts_light *light);
ts_status ts_light_views_make(ts_run *run);
/* Fails unless depth_grid.px is a multiple of 32 (nearest.c). */
ts_status ts_grid_check(const ts_params *params);
/* Number of texels of units [first, first + n): cubes with all faces, or views. */
u64 ts_run_n_texels(const ts_run *run, u32 first, u32 n);
/* Fails with the message about too many of `what`. */
ts_status ts_run_too_many(u64 n, const char *what);

#endif
