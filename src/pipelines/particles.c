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
#include "../stages/stages.h"
#include "pipelines.h"

const ts_step ts_megaviews_particles_steps[] = {
	{.stage = "view"},
	{.stage = "pose"},
	{.stage = "eye"},
	{.stage = "eye_margin", .only_margins = true},
	{.stage = "gbuffer"},
	{.stage = "root"},
	{.stage = "particle"},
	{.stage = "voxel"},
	{.stage = "octree"},         /* of the scene */
	{.stage = "octree_surface", .only_traced = true},
	{.stage = "view_voxel"},
	{.stage = "view_octree"},    /* of the particles */
	{.stage = "view_cone"},
	{.stage = "traverse", .only_traced = true},
	{.stage = "map"},
	{.stage = "map_margin", .only_margins = true},
	{.stage = "fuse"},
	{.stage = "vpl_pairs"},
	{.stage = "vpl_gather"},
	{.stage = "vpl_gather_margin", .only_margins = true},
	{.stage = "bilateral"},
	{.stage = "indirect_image"},
	{0},
};

const ts_step ts_manylods_particles_steps[] = {
	{.stage = "view"},
	{.stage = "pose"},
	{.stage = "eye"},
	{.stage = "eye_margin", .only_margins = true},
	{.stage = "gbuffer"},
	{.stage = "root"},
	{.stage = "particle"},
	{.stage = "voxel"},
	{.stage = "octree"},
	{.stage = "octree_surface", .only_traced = true},
	{.stage = "view_alone"},
	{.stage = "traverse", .only_traced = true},
	{.stage = "map"},
	{.stage = "map_margin", .only_margins = true},
	{.stage = "fuse"},
	{.stage = "vpl_pairs"},
	{.stage = "vpl_gather"},
	{.stage = "vpl_gather_margin", .only_margins = true},
	{.stage = "bilateral"},
	{.stage = "indirect_image"},
	{0},
};

const ts_step ts_bruteforce_particles_steps[] = {
	{.stage = "view"},
	{.stage = "pose"},
	{.stage = "eye"},
	{.stage = "eye_margin", .only_margins = true},
	{.stage = "gbuffer"},
	{.stage = "root"},
	{.stage = "particle"},
	{.stage = "voxel"},
	{.stage = "octree"},
	{.stage = "octree_surface", .only_traced = true},
	{.stage = "view_alone"},
	{.stage = "map_all"},
	{.stage = "map_all_margin", .only_margins = true},
	{.stage = "fuse"},
	{.stage = "vpl_pairs"},
	{.stage = "vpl_gather"},
	{.stage = "vpl_gather_margin", .only_margins = true},
	{.stage = "bilateral"},
	{.stage = "indirect_image"},
	{0},
};

void ts_particles_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)params, (void)counts, (void)request;
	plan->units = 0;
}

static void expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params, bool alone)
{
	ts_sizes_views(sizes, 0);
	ts_sizes_set(sizes, "B", 0);
	ts_expect_views(sizes, scene, params, params->particles, params->particles, alone);
}

void ts_megaviews_particles_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params)
{
	expect(sizes, scene, params, false);
}

void ts_manylods_particles_expect(ts_sizes *sizes, const ts_scene *scene, const ts_params *params)
{
	expect(sizes, scene, params, true);
}
