/* Functions of this folder's files for tools.c. */
#ifndef TS_METHODS_POINTS_TOOLS_TOOLS_H
#define TS_METHODS_POINTS_TOOLS_TOOLS_H
#include "replay/check.h"
#include "study/stage_pictures.h"
#include "study/sums.h"
#include "trace/read.h"
#include "trace/where.h"
#include "truth/sampling.h"
#include "truth/texels.h"

extern const ts_check_rule ts_points_checks[];
extern const ts_stage_picture_rule ts_points_pictures[];
extern const ts_where_rule ts_points_places[];
extern const ts_picture_mark ts_points_marks[];
extern const ts_bytes_rule ts_points_bytes[];
extern const ts_figures_rule ts_points_figures[];

/* Copies points.record into a folder of the output (viewer.c). */
ts_status ts_points_view(const ts_run *run, const char *folder);

/* Truths of reflections (truth_reflect.c). A: rays from the cube's centre along the very same directions as EPR's
 * samples, all params.lookup_bounces, own reflector masked. Reads pose.vertex, cube_size.face, eye.view and
 * mirror_pixel.record; makes shade.radiance (P x 3, tinted as in METHODS 2) in run->frame, from which stage `image`
 * makes the picture. Fails without memory. */
ts_status ts_truth_a(ts_truth *truth, ts_run *run, ts_sampling *sampling);
/* B: like A, with true reflections from the surface point, 25 rays per pixel; the own reflector may be hit. */
ts_status ts_truth_b(ts_truth *truth, ts_run *run, ts_sampling *sampling);

/* The hits by which EPR's look-ups are judged: the triangle, or TS_NONE, that the centre of the texel sees which each
 * sample of each reflective pixel reads (P x 25); TS_NONE also at pixels that `sampling` did not choose. Release *hits
 * by free(); NULL on failure. */
ts_status ts_truth_hits(ts_truth *truth, const ts_run *run, const ts_sampling *sampling, u32 **hits);

/* Adds the number of these rays that hit something, and of the run's look-ups (lookup.point) that are empty there.
 * Fails without memory. */
ts_status ts_truth_missed(u64 *n_hits, u64 *n_missed, ts_truth *truth, const ts_run *run, const ts_sampling *sampling);

/* C (truth_supersample.c): the MVR pipeline at `factor` (1 to 16) times the linear resolution of eye and faces,
 * box-filtered in linear radiance down to width x height. *radiance: width * height * 3 floats; release by free(). NULL
 * on failure: the factor takes a parameter out of its range, or more memory is needed than a run may use. */
ts_status ts_truth_c(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 factor, u32 threads);
enum { TS_TRUTH_C_FACTOR = 4 }; /* of --truth=C */
/* The work of C at that factor, and the estimate of its memory. */
u64 ts_truth_c_rays(const ts_scene *scene, const ts_params *params);
u64 ts_truth_c_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);

/* Truth of shadows (truth_shadow.c). Runs the stages before the first depth map of `effect`, soft-shadows or
 * omni-shadows, in a run that has just begun: pose, eye, lights and the views of their samples, which are the same for
 * all methods. */
ts_status ts_truth_shadow_begin(ts_run *run, const char *effect);
/* Rays to the samples for which the methods have depth maps, so that the difference is the error of the maps. Reads
 * pose.vertex, eye.view, eye.depth_triangle, offscreen.view, lamp.shape and, if the views are of cubes, cube_size.face;
 * makes shadow_test.lit in run->frame, from which stage `image.shadow` makes the picture. Fails without memory. */
ts_status ts_truth_samples(ts_truth *truth, ts_run *run, ts_sampling *sampling);
/* Rays to params.truth_area_samples samples of each light; the difference from ts_truth_samples is the error of
 * sampling the lights. Samples are distributed as those of the methods, on the same disc, ball or cone, and have the
 * same field of view: that of a depth map, in omni-shadows all directions. Afterwards lamp.shape, the views and the
 * run's plan are those of these samples. Fails without memory and beyond 2^20 samples of all lights. */
ts_status ts_truth_area(ts_truth *truth, ts_run *run, ts_sampling *sampling);
/* The estimate of the memory of `area`: views of all its samples, without their depth maps. */
u64 ts_truth_shadow_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);

/* Off-screen buffers (truth_texels.c): a ray through the centre of every texel. Triangles with an alpha mask do not
 * count, and depths are right within the shadow bias; leaks are also farther than the triangle is anywhere within half
 * a texel of the centre, and apart is also what reaches into the texel beside its centre. Reads also offscreen.view or,
 * of cubes, cube_size.face. With points.cull=off, and density.rate, points.snap, visibility.test and
 * points.conservative as they are by default, there are no holes and no leaks, unless density.capped is counted. Fails
 * only if the device fails that holds the buffer. */
ts_status ts_truth_texels(ts_texel_counts *counts, ts_truth *truth, const ts_run *run, ts_buffer_id id);

/* Texels in which points in the order of arrival may answer otherwise: of equal distances the lowest index wins, and
 * indices differ. All other texels must be equal. A rule of compare/decided.h (tie.c). */
/* Opens splat.tie and the inputs of stage splat in the reference; if one of them is missing there are no ties. */
ts_status ts_splat_ties_open(void **ties, const ts_trace *reference);
void ts_splat_ties_close(void *ties);

/* *allows: the reference's key and the candidate's, mapped to the reference's indices, name two points that both offer
 * the least distance to this texel. */
ts_status ts_splat_tie_allows(void *ties, u64 texel, u64 ref, u64 cand, bool *allows);

#endif
