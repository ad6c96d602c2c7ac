/* The stages, a function each; table.c says what each reads, writes and computes. */
#ifndef TS_STAGES_STAGES_H
#define TS_STAGES_STAGES_H
#include "stage.h"

ts_status ts_stage_view(ts_run *run);
ts_status ts_stage_pose(ts_run *run);
ts_status ts_stage_resize(ts_run *run);
ts_status ts_stage_eye(ts_run *run);
ts_status ts_stage_pixel(ts_run *run);
ts_status ts_stage_visibility(ts_run *run);
ts_status ts_stage_split(ts_run *run);
ts_status ts_stage_cull(ts_run *run);
ts_status ts_stage_align(ts_run *run);
ts_status ts_stage_count(ts_run *run);
ts_status ts_stage_points(ts_run *run);
ts_status ts_stage_splat(ts_run *run);
ts_status ts_stage_tie(ts_run *run);
ts_status ts_stage_lookup(ts_run *run);
ts_status ts_stage_lookup2(ts_run *run);
ts_status ts_stage_lookup3(ts_run *run);
ts_status ts_stage_shade3(ts_run *run);
ts_status ts_stage_shade2(ts_run *run);
ts_status ts_stage_shade(ts_run *run);
ts_status ts_stage_face(ts_run *run);
ts_status ts_stage_illuminate(ts_run *run);
ts_status ts_stage_mirror(ts_run *run);
ts_status ts_stage_image(ts_run *run);
ts_status ts_stage_eye_margin(ts_run *run);
ts_status ts_stage_cull_margin(ts_run *run);
ts_status ts_stage_face_margin(ts_run *run);
ts_status ts_stage_lamp(ts_run *run);
ts_status ts_stage_lamp_ball(ts_run *run);
ts_status ts_stage_lamp_view(ts_run *run);
ts_status ts_stage_light_view(ts_run *run);
ts_status ts_stage_lamp_cube(ts_run *run);
ts_status ts_stage_offscreen(ts_run *run);
ts_status ts_stage_offscreen_visibility(ts_run *run);
ts_status ts_stage_view_split(ts_run *run);
ts_status ts_stage_scatter(ts_run *run);
ts_status ts_stage_scatter_colour(ts_run *run);
ts_status ts_stage_copy(ts_run *run);
ts_status ts_stage_shadow_resize(ts_run *run);
ts_status ts_stage_shadow_split(ts_run *run);
ts_status ts_stage_shadow_splat(ts_run *run);
ts_status ts_stage_depth(ts_run *run);
ts_status ts_stage_depth_margin(ts_run *run);
ts_status ts_stage_resolve(ts_run *run);
ts_status ts_stage_resolve_margin(ts_run *run);
ts_status ts_stage_pcss(ts_run *run);
ts_status ts_stage_shadow_image(ts_run *run);
ts_status ts_stage_rsm_view(ts_run *run);
ts_status ts_stage_rsm(ts_run *run);
ts_status ts_stage_rsm_patch(ts_run *run);
ts_status ts_stage_gbuffer(ts_run *run);
ts_status ts_stage_nearest(ts_run *run);
ts_status ts_stage_segment(ts_run *run);
ts_status ts_stage_segment_margin(ts_run *run);
ts_status ts_stage_range(ts_run *run);
ts_status ts_stage_box(ts_run *run);
ts_status ts_stage_gather(ts_run *run);
ts_status ts_stage_fit(ts_run *run);
ts_status ts_stage_hull(ts_run *run);
ts_status ts_stage_hull_margin(ts_run *run);
ts_status ts_stage_direct(ts_run *run);
ts_status ts_stage_indirect_image(ts_run *run);
ts_status ts_stage_root(ts_run *run);
ts_status ts_stage_voxel(ts_run *run);
ts_status ts_stage_octree(ts_run *run);
ts_status ts_stage_octree_surface(ts_run *run);
ts_status ts_stage_vpl(ts_run *run);
ts_status ts_stage_particle(ts_run *run);
ts_status ts_stage_view_voxel(ts_run *run);
ts_status ts_stage_view_octree(ts_run *run);
ts_status ts_stage_view_cone(ts_run *run);
ts_status ts_stage_traverse(ts_run *run);
ts_status ts_stage_map(ts_run *run);
ts_status ts_stage_fuse(ts_run *run);
ts_status ts_stage_view_alone(ts_run *run);
ts_status ts_stage_map_all(ts_run *run);
ts_status ts_stage_map_margin(ts_run *run);
ts_status ts_stage_map_all_margin(ts_run *run);
ts_status ts_stage_vpl_pairs(ts_run *run);
ts_status ts_stage_vpl_gather(ts_run *run);
ts_status ts_stage_vpl_gather_margin(ts_run *run);
ts_status ts_stage_bilateral(ts_run *run);
ts_status ts_stage_surfel_setup(ts_run *run);
ts_status ts_stage_surfel_depth(ts_run *run);
ts_status ts_stage_fragment_list(ts_run *run);
ts_status ts_stage_blend(ts_run *run);
ts_status ts_stage_surfel_mean(ts_run *run);
ts_status ts_stage_surfel_depth_margin(ts_run *run);
ts_status ts_stage_blend_margin(ts_run *run);
ts_status ts_stage_surfel_shadow(ts_run *run);
ts_status ts_stage_deferred_lit(ts_run *run);
ts_status ts_stage_deferred_lit_margin(ts_run *run);
ts_status ts_stage_deferred(ts_run *run);
ts_status ts_stage_deferred_margin(ts_run *run);

/* Shared by the stages (run.c). The arrays of the frame that shading kernels read; the vertices are this frame's. */
ts_arrays ts_run_arrays(const ts_run *run);
const ts_info *ts_run_info(const ts_run *run);
/* Arguments of the kernel cull, without its output. */
ts_cull_args ts_cull_arguments(const ts_run *run);
/* rho_scale as samples a pixel a side. */
f32 ts_samples_a_pixel(const ts_params *params);
/* The largest cube face that adapts to the eye: face_max, at most half the eye's height, at least 16. */
u32 ts_largest_face(const ts_params *params);
u32 ts_run_n_cubes(const ts_run *run);
u32 ts_run_n_words(const ts_run *run);
/* The off-screen views are faces of cubes. */
bool ts_run_has_cubes(const ts_run *run);
/* The off-screen views of the batch. */
void ts_run_views(const ts_run *run, u32 *first, u32 *n);
/* A face of a cube as a view, of the light or TS_NONE (offscreen.c). */
void ts_offscreen_of_face(ts_offscreen *view, const ts_face *cube, u32 face, u32 light);
/* Views from a light's middle, six of a point light; and those of all lamps (lamp.c). */
u32 ts_light_views(const ts_light *light);
ts_status ts_light_views_make(ts_run *run);
/* grid_px must be a multiple of 32 (gbuffer.c). */
ts_status ts_grid_check(const ts_params *params);
/* How pixels choose a box (hull.c). */
ts_choice_args ts_choice_arguments(const ts_run *run);
/* view_px must be a power of two; the levels of a view's map (map.c). */
ts_status ts_view_px_check(const ts_params *params);
ts_pyramid ts_view_pyramid(const ts_params *params);
/* The level of the lists of vpl_pairs (vpl_gather.c): gather_level, at most levels; 0 where views have no hierarchy, alone,
 * or nothing is culled. */
u32 ts_gather_level(const ts_run *run);
u32 ts_gather_level_of(const ts_params *params, u32 field, bool alone);
/* How surfels are filtered, as arguments of kernels have it (surfel_setup.c). */
ts_filter ts_surfel_filter(const ts_run *run);
/* The sums of stage `blend` in the order of the surfels (fragment_list.c), and whether the parameter `accumulation` asks for
 * them. */
ts_status ts_blend_in_order(ts_run *run);
bool ts_accumulates_in_order(const ts_params *params);
/* The parameter `shader` asks for shadows (deferred.c). */
bool ts_shader_has_shadows(const ts_params *params);
/* Arguments of the kernels of deferred shading, without their outputs. */
ts_deferred_lit_args ts_deferred_lit_arguments(const ts_run *run);
ts_deferred_args ts_deferred_arguments(const ts_run *run);
/* Arguments of the kernels that make virtual point lights and particles, without offset, paths and lights. */
ts_vpl_args ts_vpl_arguments(const ts_run *run);
ts_particle_args ts_particle_arguments(const ts_run *run);
/* How pixels gather from them, without the output. */
ts_vpl_gather_args ts_vpl_gather_arguments(const ts_run *run);
/* Arguments of the kernels that make points, without their output. */
ts_points_args ts_points_arguments(const ts_run *run);
/* Arguments of the kernels that ask depth maps, without their output. */
ts_resolve_args ts_resolve_arguments(const ts_run *run);
/* resolve.lit, made before the first batch; NULL without memory. */
u32 *ts_resolve_output(ts_run *run);
/* Texels of units [first, first + n): cubes with all faces, or views. */
u64 ts_run_n_texels(const ts_run *run, u32 first, u32 n);
/* The run's backend at work: see backend.h. */
ts_status ts_run_launch(ts_run *run, ts_kernel kernel, const void *args, u64 n);
ts_status ts_run_fill(ts_run *run, ts_buffer_id id, u8 byte);
/* Makes a buffer of zeros, for what mostly stays zero. */
void *ts_run_zeros(ts_run *run, ts_buffer_id id, u32 n_dims, const u64 *shape);
/* Of a buffer with a SUM row, whose size is then known. The total must stay below 2^32 - 1. */
ts_status ts_run_scan(ts_run *run, ts_buffer_id id, u64 *total);
/* The message of more; `what` names what is counted. */
ts_status ts_run_too_many(u64 n, const char *what);

#endif
