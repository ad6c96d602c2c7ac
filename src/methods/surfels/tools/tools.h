/* Functions of this folder's files: for tools.c, and the tables of bench. */
#ifndef TS_METHODS_SURFELS_TOOLS_TOOLS_H
#define TS_METHODS_SURFELS_TOOLS_TOOLS_H
#include "replay/check.h"
#include "study/notes.h"
#include "study/tables/text.h"
#include "truth/sampling.h"
#include "truth/truth.h"

extern const ts_check_rule ts_surfels_checks[];

/* Truths of surfels (truth_surfels.c), in a run of their own: the mean of params.truth_grid_rays^2 pictures, each by a
 * ray in one cell of the grid of every pixel, at ts_truth_place. `discs` casts the rays into the surfels, `surface`
 * into the surface that was sampled, which must be known. *radiance: width * height * 3 floats; release by free(). NULL
 * on failure: no memory, or Embree's error. */
ts_status ts_truth_discs(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads,
                         ts_sampling *sampling);
ts_status ts_truth_surface(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads,
                           ts_sampling *sampling);
/* Places the ray of a cell in its pixel by a hash, uniform over the cell. place: from the left and from above, [0,1).
 * pixel: counted along the rows; cell: below side * side. */
void ts_truth_place(double place[2], u32 pixel, u32 cell, u32 side, u32 seed);
/* The estimate of their memory beside the mean of their pictures: a picture, and the tree of `discs`. */
u64 ts_truth_discs_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);
u64 ts_truth_surface_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);
/* Whether the surfels were sampled from the scene's triangles (params.surfels_from_mesh), or are the built-in
 * checkerboard. */
bool ts_truth_has_surface(const ts_scene *scene, const ts_params *params);

/* Statistics on whether the surfels that epsilon blends are one surface (layers.c). */
typedef struct {
	u32 pixels, apart; /* judged pixels, which show a surface; those that blend two layers that face the same way */
	f32 gap;           /* median between these, world units */
} ts_layers;

/* Measures after stage surfel_depth. */
ts_status ts_layers_measure(ts_layers *layers, const ts_run *run);
/* For ts_note_rule: a line if at least a hundredth of the pixels blends two layers. */
ts_status ts_layers_note(char note[TS_NOTE_CHARS], const ts_run *run);

/* Tables of bench. */

ts_status ts_bench_crumbs(const ts_job *job);

#endif
