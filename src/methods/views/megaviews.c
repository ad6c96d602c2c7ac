/* MegaViews: indirect light by instant radiosity, with a small map of the surroundings of each of many lights.
 * Kol, Bauszat, Lee and Eisemann, "MegaViews: Scalable Many-View Rendering with Concurrent Scene-View Hierarchy
 * Traversal" (2019). And ManyLoDs, to which the paper compares itself: Hollaender, Ritschel, Eisemann and Boubekeur
 * (2011).
 *
 * Texels of reflective shadow maps become virtual point lights, each of them a view (section 3.1). Pairs of a node of
 * the scene's octree and one of the views' are culled, rendered or split (section 3.2), and fused into whole maps.
 * Pixels gather the light of a few of the views that the same culling leaves them, and a cross-bilateral filter makes
 * that smooth (section 5.1). ManyLoDs has no octree of views: each is rendered by itself, and pixels draw from all of
 * them. Brute force does not use the scene's inner nodes either: every leaf is rendered for every view.
 *
 * Deviations:
 * - culling, equivalence and subdivision are reconstructed, for the text of figures 4, 6 and 8 is lost (METHODS 13);
 * - queues that are longer than their memory continue piece by piece, not by children of the root;
 * - lights stand half a leaf's side above their surface, and leaves near theirs are not rendered, because they would
 *   otherwise shadow themselves, which the paper does not mention; view_map.apart=0 is the paper;
 * - a leaf that is wider than a texel fills the texels that a ball in its cube covers, as the paper does not define a
 *   node's projection: its bounding sphere, view_map.fill=1, throws too much shadow;
 * - the paper mentions neither near lights nor a bias: distances are at least vpl_gather.near leaves' sides. Places are
 *   lit up to vpl_gather.bias leaves' diagonals and bias texels' widths behind the map's depth, and farther if the
 *   map's node is no more than vpl_gather.bias_plane of its radii above the place's tangent plane, for which maps store
 *   the node, not its distance alone. vpl_gather.test=distance does without, where depth_map.bias_slope keeps surfaces
 *   out of their own shadow and lets light through walls;
 * - lists end at the nodes of vpl_gather.level, as the paper does not say whether leaves of views are culled one by
 *   one;
 * - brute force renders leaves, where the paper rasterizes triangles: it then differs from ManyLoDs only by the
 *   hierarchy;
 * - the picture shows only indirect light. */
#include <math.h>
#include "methods/stages.h"
#include "methods/views/pipelines.h"
#include "methods/views/views.h"
#include "scene/lamp.h"

/* The octree of the scene, and light from the maps' texels. */
static const ts_step vpl_run[] = {
	{.stage = "octree.root"},
	{.stage = "voxel"},
	{.stage = "octree"},
	{.stage = "vpl.area", .only_if = ts_vpl_at_random, .unnumbered = true},
	{.stage = "vpl"},
	{.stage = "octree.surface", .only_traced = true},
	{0},
};

static const ts_step megaviews_steps[] = {
	{.run = ts_rsm_run},     {.run = vpl_run},       {.run = ts_shared_maps_run},
	{.run = ts_gbuffer_run}, {.run = ts_gather_run}, {0},
};

static const ts_step manylods_steps[] = {
	{.run = ts_rsm_run},     {.run = vpl_run},       {.run = ts_own_maps_run},
	{.run = ts_gbuffer_run}, {.run = ts_gather_run}, {0},
};

static const ts_step bruteforce_steps[] = {
	{.run = ts_rsm_run},     {.run = vpl_run},       {.run = ts_all_maps_run},
	{.run = ts_gbuffer_run}, {.run = ts_gather_run}, {0},
};

void ts_views_plan(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	ts_indirect_plan(plan, params, counts, request);
	ts_plan_views(plan, params);
}

#define IN_CONE 0.68 /* share of the lamp's map that its cone lights: pi/4 of the square, to 15/16 of half its angle */

#define SLANT 3 /* area of the surfaces in the lamp's cone, which are slanted, and some farther away */

/* The area of surfaces in the lamp's cone, from a plane across it where the irradiance is light_irradiance. */
static double lamp_area(const ts_scene *scene, const ts_params *params)
{
	ts_light lamp;
	ts_lamp_spot(&lamp, &scene->info, scene->n_stands == TS_N_STANDS ? scene->stands : NULL, params);
	double cosine = -(double)lamp.spot_offset / (double)lamp.spot_scale; /* of the cone's border */
	double square = (double)lamp.intensity[0] / (double)TS_PARAM(params, light_irradiance);
	return SLANT * 3.14159265 * square * (1 / (cosine * cosine) - 1);
}

/* Paths begin at the lit texels of the maps. Several may begin at one texel: their first lights have the same place. */
static void expect(ts_expected *expected, const ts_scene *scene, const ts_params *params, bool alone)
{
	ts_indirect_expect(expected, scene, params);
	bool own = TS_PARAM(params, lamp_source) == TS_LAMP_SCENE;
	u64 texels = expected->sizes.n[TS_DIM_texels], lit = own ? texels : (u64)(IN_CONE * (double)texels);
	u64 n_paths = TS_PARAM(params, vpl_paths) != 0 ? TS_PARAM(params, vpl_paths) : lit,
		n_first = n_paths < lit ? n_paths : lit;
	ts_expected_lights lights = {
		.n = n_paths * TS_PARAM(params, vpl_bounces), .alone = alone, .px = TS_PARAM(params, view_map_px)};
	bool anywhere = ts_vpl_at_random(params);
	lights.n_places = anywhere ? lights.n : n_first + lights.n - n_paths;
	lights.area = own || anywhere || TS_PARAM(params, vpl_bounces) > 1 ? INFINITY : lamp_area(scene, params);
	expected->sizes.n[TS_DIM_paths] = n_paths;
	ts_expect_views(expected, scene, params, &lights);
	ts_expect_gather(expected, scene, params, &lights);
}

static void megaviews_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	expect(expected, scene, params, false);
}

static void manylods_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	expect(expected, scene, params, true);
}

const ts_pipeline ts_pipeline_megaviews_indirect = {
	.name = "megaviews",
	.effect = &ts_effect_indirect,
	.paper = "MegaViews 3 and 5.1",
	.doc = "many small views at once: octrees of scene and virtual point lights share the work of their maps",
	.steps = megaviews_steps,
	.plan = ts_views_plan,
	.expect = megaviews_expect,
	.lower = "octree.levels, vpl_gather.level, view_map.px or vpl.paths",
};

const ts_pipeline ts_pipeline_manylods_indirect = {
	.name = "manylods",
	.effect = &ts_effect_indirect,
	.paper = "MegaViews 4.1",
	.doc = "virtual point lights, each with a map by a traversal of its own",
	.steps = manylods_steps,
	.plan = ts_views_plan,
	.expect = manylods_expect,
	.lower = "octree.levels, vpl_gather.level, view_map.px or vpl.paths",
};

const ts_pipeline ts_pipeline_bruteforce_indirect = {
	.name = "bruteforce",
	.effect = &ts_effect_indirect,
	.paper = "MegaViews 4.1",
	.doc = "virtual point lights, each with a map of every leaf of the scene",
	.steps = bruteforce_steps,
	.plan = ts_views_plan,
	.expect = manylods_expect,
	.lower = "octree.levels, vpl_gather.level, view_map.px or vpl.paths",
	.only_named = true,
};
