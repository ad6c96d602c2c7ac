/* Glowing particles, whose light all surfaces cast shadows in, by MegaViews, ManyLoDs and brute force (see megaviews.c,
 * section 5.2).
 *
 * Particles are lights in the hall's air, each of them a view of all directions, so that nothing is culled. What follows is
 * what follows the virtual point lights of indirect light: the same octree of views, traversal, maps and gathering.
 *
 * Deviations, beside those of megaviews.c:
 * - the paper does not say where particles are and how they move: they are on ellipses about the middle of the hall;
 * - as nothing is culled, pixels draw from all particles, unless cutoff leaves those that are far away;
 * - the picture is of the light of particles alone, and particles themselves are not seen. */
#include <math.h>
#include "../stages.h"
#include "../pipelines.h"

/* What the eye sees, particles, and the octree of the scene. */
static const ts_step particle_run[] = {
	{.run = ts_frame_run},
	{.run = ts_gbuffer_run},
	{.stage = "root"},
	{.stage = "particle"},
	{.stage = "voxel"},
	{.stage = "octree"},
	{.stage = "octree_surface", .only_traced = true},
	{0},
};

const ts_step ts_megaviews_particles_steps[] = {
	{.run = particle_run},
	{.run = ts_shared_maps_run},
	{.run = ts_gather_run},
	{0},
};

const ts_step ts_manylods_particles_steps[] = {
	{.run = particle_run},
	{.run = ts_own_maps_run},
	{.run = ts_gather_run},
	{0},
};

const ts_step ts_bruteforce_particles_steps[] = {
	{.run = particle_run},
	{.run = ts_all_maps_run},
	{.run = ts_gather_run},
	{0},
};

void ts_particles_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)params, (void)counts, (void)request;
	plan->units = 0;
}

static void expect(ts_expected *expected, const ts_scene *scene, const ts_params *params, bool alone)
{
	expected->sizes.n[TS_DIM_views] = 0;
	const ts_expected_lights lights = {TS_PARAM(params, particles), TS_PARAM(params, particles), INFINITY, alone};
	ts_expect_views(expected, scene, params, &lights);
}

void ts_megaviews_particles_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	expect(expected, scene, params, false);
}

void ts_manylods_particles_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	expect(expected, scene, params, true);
}
