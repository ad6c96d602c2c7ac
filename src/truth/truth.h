/* Ground truth: judged by metrics, never by bits. Embree finds the triangle, our own kernel computes the hit from it.
 * No result depends on threads. */
#ifndef TS_TRUTH_TRUTH_H
#define TS_TRUTH_TRUTH_H
#include "../methods/pipeline.h"

typedef struct ts_truth ts_truth;

/* Builds Embree's tree over run->frame's pose.vertex and scene.triangle; degenerate triangles are left out,
 * single-sided back faces and masked texels are skipped by a filter (METHODS 17). *truth by ts_truth_free, before the
 * run ends; NULL on failure: no memory, or Embree's own error. */
ts_status ts_truth_new(ts_truth **truth, const ts_run *run);
/* Releases a tree; NULL is allowed. */
void ts_truth_free(ts_truth *truth);

/* A: rays from the cube's centre along the very same directions as EPR's samples, all params.bounces, own reflector
 * masked. Reads pose.vertex, resize.face, eye.view and pixel.record; makes shade.radiance (P x 3, tinted as in
 * METHODS 2) in run->frame, from which stage `image` makes the picture. Fails without memory. */
ts_status ts_truth_a(ts_truth *truth, ts_run *run);
/* B: the same with true reflections from the surface point, 25 rays a pixel; the own reflector may be hit. */
ts_status ts_truth_b(ts_truth *truth, ts_run *run);

/* What EPR's look-ups are judged by: the triangle, or TS_NONE, that each sample of each reflective pixel hits
 * (P x 25, the first legs of A). *hits by free(); NULL on failure. */
ts_status ts_truth_hits(ts_truth *truth, const ts_run *run, u32 **hits);

/* C (supersample.c): the MVR pipeline at `factor` (1 to 16) times the linear resolution of eye and faces, box-filtered
 * in linear radiance down to width x height. *radiance: width * height * 3 floats, by free(). NULL on failure: a factor
 * that takes a parameter out of its range, or more memory than a run may use. */
ts_status ts_truth_c(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 factor, u32 threads);
enum { TS_TRUTH_C_FACTOR = 4 }; /* of --truth=C */
/* What it is estimated to need of memory at that factor. */
u64 ts_truth_c_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);

/* Truth of shadows (shadow.c). Runs what comes before the first depth map of `effect`, soft-shadows or omni-shadows,
 * in a run that has just begun: pose, eye, lights and the views of their samples, the same for all methods. */
ts_status ts_truth_shadow_begin(ts_run *run, const char *effect);
/* Rays to the very samples that the methods have depth maps of, which leaves the error of the maps. Reads
 * pose.vertex, eye.view, eye.depth_triangle, offscreen.view, lamp.shape and, if the views are of cubes, resize.face;
 * makes resolve.lit in run->frame, from which stage `shadow_image` makes the picture. Fails without memory. */
ts_status ts_truth_samples(ts_truth *truth, ts_run *run);
/* Rays to params.area_samples samples of each light, which with the other leaves what sampling the lights costs.
 * They lie as the methods' do, on the same disc, ball or cone, and see as much: a depth map's image, all around in
 * omni-shadows. Afterwards lamp.shape, the views and the run's plan are those of these samples. Fails without memory
 * and beyond 2^20 samples of all lights. */
ts_status ts_truth_area(ts_truth *truth, ts_run *run);
/* What `area` is estimated to need of memory: views of all its samples, without their depth maps. */
u64 ts_truth_shadow_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);

/* Truth of indirect light (indirect.c). Runs what comes before `direct`, in a run that has just begun: pose, lights,
 * what they see, eye and G-buffer, the same for both methods. */
ts_status ts_truth_indirect_begin(ts_run *run, const char *effect);
/* As `direct`, but only of the triangles of light whose middle the pixel sees, which tells what visibility would
 * change. Reads gbuffer.pixel and rsm_patch.light; makes indirect.irradiance in run->frame, from which stage
 * `indirect_image` makes the picture. Fails without memory. */
ts_status ts_truth_lights(ts_truth *truth, ts_run *run);
/* Light after one diffuse bounce by params.bounce_rays rays a pixel, without triangles of light, which with the
 * other leaves what the reflective shadow map costs. Reads gbuffer.pixel and lamp.light; makes the same. */
ts_status ts_truth_bounce(ts_truth *truth, ts_run *run);

/* All virtual point lights of params.vpls, each with its distance bounded as in vpl_gather, if nothing stands
 * between pixel and light but within a leaf's diagonal of the light, which the methods skip, too. Runs what makes
 * them. Reads gbuffer.pixel and rsm_patch.light; makes the same. */
ts_status ts_truth_vpls(ts_truth *truth, ts_run *run);

/* Truth of glowing particles: the same of all params.particles. Runs what comes before the particles of `effect`, in
 * a run that has just begun. */
ts_status ts_truth_particles_begin(ts_run *run, const char *effect);
/* Reads gbuffer.pixel; makes the same. */
ts_status ts_truth_glow(ts_truth *truth, ts_run *run);

/* Truths of surfels (surfels.c), in a run of their own: the mean of params.grid_rays^2 pictures, each by rays
 * through one place of a regular grid in every pixel. `discs` casts them into the surfels, `surface` into what these
 * are samples of, which must be known. *radiance: width * height * 3 floats, by free(). NULL on failure: no memory,
 * or Embree's error. */
ts_status ts_truth_discs(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads);
ts_status ts_truth_surface(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads);
/* What they are estimated to need of memory beside the mean of their pictures: a picture, and the tree of `discs`. */
u64 ts_truth_discs_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);
u64 ts_truth_surface_bytes(const ts_pipeline *method, const ts_scene *scene, const ts_params *params);
/* True if the surfels were sampled from the scene's triangles (params.from_mesh), or are the built-in checkerboard. */
bool ts_truth_has_surface(const ts_scene *scene, const ts_params *params);

/* Truth of off-screen buffers (texels.c): a ray through the centre of every texel. */
typedef struct {
	u64 covered; /* texels whose ray hits a triangle that the view may show and that has no alpha mask */
	u64 holes;   /* of these, those that hold nothing */
	u64 leaks;   /* of these, those that hold what is farther than the ray's hit by more than the shadow bias, and farther
	              * than its triangle is anywhere within half a texel of the centre: something shows through */
	u64 apart;   /* of these, those whose depth is not the hit's within the shadow bias: leaks, and what reaches into the
	              * texel beside its centre */
} ts_texel_counts;

/* True of the buffers that can be judged: scatter.depth, scatter.colour and face.depth_triangle. */
bool ts_truth_judges(ts_buffer_id id);
/* Adds what buffer `id` of the run's batch is like to *counts. Reads also offscreen.view or, of cubes, resize.face.
 * With cull=off, and rate, snap, visibility and conservative as they are by default, there are no holes and no
 * leaks, unless density.capped is counted. Never fails but with the device that the buffer is on. */
ts_status ts_truth_texels(ts_texel_counts *counts, ts_truth *truth, const ts_run *run, ts_buffer_id id);

/* Truth of the maps of virtual point lights and particles (maps.c), of up to 1024 lights, every so many-th. */
typedef struct {
	u64 covered; /* texels along whose middle, from the light on but for a leaf's diagonal, a ray hits something */
	u64 holes;   /* of these, those that are empty */
	u64 leaks;   /* of these, those whose depth, moved to the light, is more than three leaves' sides behind the hit */
	u64 apart;   /* of these, leaks, and those as much before it: whatever of the texel is nearest */
	u64 asked;   /* lights that 64 pixels each, at random, would have light of */
	u64 lit;     /* of these, those that the map lets through, and something stops: light leaks */
	u64 dark;    /* of these, those that the map stops, and nothing does */
} ts_map_counts;

/* Adds what the maps are like after stage vpl_gather, whose buffers are there, and how they answer with the
 * parameters of shadows, whether these are on or off. Fails if a buffer is not there. */
ts_status ts_truth_maps(ts_map_counts *counts, const ts_truth *truth, const ts_run *run);

#endif
