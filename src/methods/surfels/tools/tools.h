/* What the files of this folder have for tools.c. */
#ifndef TS_SURFELS_TOOLS_H
#define TS_SURFELS_TOOLS_H
#include "../../../replay/check.h"
#include "../../../study/notes.h"
#include "../../../truth/sampling.h"
#include "../../../truth/truth.h"

extern const ts_check_rule ts_surfels_checks[];

/* Truths of surfels (truth_surfels.c), in a run of their own: the mean of params.truth_grid_rays^2 pictures, each
 * by a ray in one cell of the grid of every pixel, at ts_truth_place. `discs` casts them into the surfels, `surface`
 * into what these are samples of, which must be known. *radiance: width * height * 3 floats, by free(). NULL on
 * failure: no memory, or Embree's error. */
ts_status ts_truth_discs(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads,
                         ts_sampling *sampling);
ts_status ts_truth_surface(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads,
                           ts_sampling *sampling);
/* Places the ray of a cell in its pixel by a hash, uniform over the cell. place: from the left and from above, [0,1).
 * pixel: counted along the rows; cell: below side * side. */
void ts_truth_place(double place[2], u32 pixel, u32 cell, u32 side, u32 seed);
/* What they are estimated to need of memory beside the mean of their pictures: a picture, and the tree of `discs`. */
u64 ts_truth_discs_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);
u64 ts_truth_surface_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);
/* True if the surfels were sampled from the scene's triangles (params.surfels_from_mesh), or are the built-in
 * checkerboard. */
bool ts_truth_has_surface(const ts_scene *scene, const ts_params *params);

/* How far the surfels that epsilon blends are one surface (layers.c). */
typedef struct {
	u32 pixels, apart; /* judged, where there is a surface; that blend two layers which face the same way */
	f32 gap;           /* median between these, world units */
} ts_layers;

/* Behind stage surfel_depth. */
ts_status ts_layers_measure(ts_layers *layers, const ts_run *run);
/* For ts_note_rule: a line if a hundredth of the surface or more does. */
ts_status ts_layers_note(char note[TS_NOTE_CHARS], const ts_run *run);

#endif
