/* Glowing particles, with shadows cast by all surfaces, by MegaViews, ManyLoDs and brute force (see megaviews.c,
 * section 5.2).
 *
 * Particles are lights in the hall's air, each of them a view of all directions, so that nothing is culled. The later
 * steps are those of the virtual point lights of indirect light: the same octree of views, traversal, maps and
 * gathering.
 *
 * Deviations, beside those of megaviews.c:
 * - the paper does not say where particles are and how they move: they are on ellipses about the middle of the hall;
 * - as nothing is culled, pixels draw from all particles, unless cutoff excludes those that are far away;
 * - the picture shows only the light of particles, not the particles. */
#include <math.h>
#include "methods/stages.h"
#include "methods/views/pipelines.h"

/* The eye's view, particles, and the octree of the scene. */
static const ts_step particle_run[] = {
	{.run = ts_frame_run},
	{.run = ts_gbuffer_run},
	{.stage = "octree.root"},
	{.stage = "particle"},
	{.stage = "voxel"},
	{.stage = "octree"},
	{.stage = "octree.surface", .only_traced = true},
	{0},
};

static const ts_step megaviews_particles_steps[] = {
	{.run = particle_run},
	{.run = ts_shared_maps_run},
	{.run = ts_gather_run},
	{0},
};

static const ts_step manylods_particles_steps[] = {
	{.run = particle_run},
	{.run = ts_own_maps_run},
	{.run = ts_gather_run},
	{0},
};

static const ts_step bruteforce_particles_steps[] = {
	{.run = particle_run},
	{.run = ts_all_maps_run},
	{.run = ts_gather_run},
	{0},
};

static void particles_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)counts, (void)request;
	ts_plan_views(plan, params);
	plan->units = 0;
}

static void expect(ts_expected *expected, const ts_scene *scene, const ts_params *params, bool alone)
{
	expected->sizes.n[TS_DIM_views] = 0;
	const ts_expected_lights lights = {TS_PARAM(params, particle_count), TS_PARAM(params, particle_count), INFINITY,
	                                   alone, TS_PARAM(params, view_map_px)};
	ts_expect_views(expected, scene, params, &lights);
	ts_expect_gather(expected, scene, params, &lights);
}

static void megaviews_particles_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	expect(expected, scene, params, false);
}

static void manylods_particles_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	expect(expected, scene, params, true);
}

static const ts_effect particles = {
	.name = "particles",
	.doc = "the light of many particles in the air",
	.seen = TS_B_eye_depth_triangle,
	.difference_scale = 8,
	.lower = "octree.levels, vpl_gather.level, view_map.px or particle.count",
};

const ts_pipeline ts_pipeline_megaviews_particles = {
	.name = "megaviews",
	.effect = &particles,
	.paper = "MegaViews 3 and 5.2",
	.doc = "many small views at once: octrees of scene and glowing particles share the work of their maps",
	.steps = megaviews_particles_steps,
	.plan = particles_plan,
	.expect = megaviews_particles_expect,
	.sets = {"view_map.field", "all"},
};

const ts_pipeline ts_pipeline_manylods_particles = {
	.name = "manylods",
	.effect = &particles,
	.paper = "MegaViews 4.1",
	.doc = "glowing particles, each with a map by a traversal of its own",
	.steps = manylods_particles_steps,
	.plan = particles_plan,
	.expect = manylods_particles_expect,
	.sets = {"view_map.field", "all"},
};

const ts_pipeline ts_pipeline_bruteforce_particles = {
	.name = "bruteforce",
	.effect = &particles,
	.paper = "MegaViews 4.1",
	.doc = "glowing particles, each with a map of every leaf of the scene",
	.steps = bruteforce_particles_steps,
	.plan = particles_plan,
	.expect = manylods_particles_expect,
	.only_named = true,
	.sets = {"view_map.field", "all"},
};
