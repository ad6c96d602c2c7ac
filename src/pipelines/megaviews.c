/* MegaViews: indirect light by instant radiosity with a small map of what is around each of many lights.
 * Kol, Bauszat, Lee and Eisemann, "MegaViews: Scalable Many-View Rendering with Concurrent Scene-View Hierarchy Traversal"
 * (2019). And ManyLoDs, what the paper compares itself to: Hollaender, Ritschel, Eisemann and Boubekeur (2011).
 *
 * Texels of reflective shadow maps become virtual point lights, each of them a view (section 3.1). Pairs of a node of the
 * scene's octree and one of the views' are culled, rendered or split (section 3.2), and fused into whole maps. Pixels gather
 * the light of a few of the views that the same culling leaves them, and a cross-bilateral filter makes that smooth
 * (section 5.1). ManyLoDs has no octree of views: each is rendered by itself, and pixels draw from all of them. Brute force
 * has no use for the scene's inner nodes either: every leaf is rendered for every view.
 *
 * Deviations:
 * - culling, equivalence and subdivision are reconstructed, for the text of figures 4, 6 and 8 is lost (METHODS 13);
 * - queues that are longer than their memory are carried on piece by piece, not by children of the root;
 * - lights stand half a leaf's side above their surface, and leaves that touch theirs are not rendered, for else they would
 *   be in their own shadow, of which the paper does not speak; touching=render is the paper;
 * - nor does it of near lights and of a bias: distances are at least light_near leaves' sides, and what lies behind what a
 *   map shows is lit up to light_bias leaves' diagonals and bias texels' widths, and farther if that node is no more than
 *   bias.plane of its radii above the place's tangent plane, for which maps tell the node, not its distance alone;
 *   shadow.test=distance does without, where bias.slope keeps surfaces out of their own shadow and lets light through walls;
 * - lists end at the nodes of gather_level, where the paper leaves open whether leaves of views are culled one by one;
 * - brute force renders leaves, where the paper rasterizes triangles: what differs from ManyLoDs is then the hierarchy's;
 * - the picture is of indirect light alone. */
#include "../stages/views.h"
#include "../stages/stages.h"
#include "pipelines.h"

/* The octree of the scene, and light from the maps' texels. */
static const ts_step vpl_run[] = {
	{.stage = "root"},
	{.stage = "voxel"},
	{.stage = "octree"},
	{.stage = "vpl"},
	{.stage = "octree_surface", .only_traced = true},
	{0},
};

const ts_step ts_megaviews_steps[] = {
	{.run = ts_rsm_run},
	{.run = vpl_run},
	{.run = ts_shared_maps_run},
	{.run = ts_gbuffer_run},
	{.run = ts_gather_run},
	{0},
};

const ts_step ts_manylods_steps[] = {
	{.run = ts_rsm_run},
	{.run = vpl_run},
	{.run = ts_own_maps_run},
	{.run = ts_gbuffer_run},
	{.run = ts_gather_run},
	{0},
};

const ts_step ts_bruteforce_steps[] = {
	{.run = ts_rsm_run},
	{.run = vpl_run},
	{.run = ts_all_maps_run},
	{.run = ts_gbuffer_run},
	{.run = ts_gather_run},
	{0},
};

enum { LEAVES_A_FACE = 8, PAIRS_A_VIEW = 1024 };

static u64 least(u64 a, u64 b) { return a < b ? a : b; }

/* Surfaces fill as many voxels of a level as some faces of the root, and nodes above them are a third as many. */
static u64 expected_nodes(u32 level) { return least((u64)LEAVES_A_FACE << 2 * level, 1ull << 3 * level); }

/* Of n voxels those that lights are in: nearly as many as are few lights, nearly all with many. */
static u64 expected_lit(u64 n_lights, u64 n) { return n_lights > 0 ? n_lights * n / (n_lights + n) + 1 : 0; }

void ts_expect_views(ts_expected *expected, const ts_scene *scene, const ts_params *params, u64 n_lights, u64 n_places,
                     bool alone)
{
	u32 levels = params->levels, level = ts_gather_level_of(params, params->view_field, alone);
	u64 leaves = expected_nodes(levels), view_leaves = alone ? n_lights : expected_lit(n_places, leaves);
	u64 lists = expected_nodes(level), n_pairs = lists * (alone ? n_lights : expected_lit(view_leaves, lists));
	u64 *n = expected->sizes.n;
	n[TS_DIM_nodes] = leaves + leaves / 3;
	n[TS_DIM_leaves] = leaves;
	n[TS_DIM_leaf_triangles] = scene->n_triangles + 2 * leaves;
	n[TS_DIM_vpls] = n_lights;
	n[TS_DIM_view_nodes] = alone ? n_lights : 2 * view_leaves;
	n[TS_DIM_view_leaves] = view_leaves;
	n[TS_DIM_rendered] = n_lights * PAIRS_A_VIEW;
	n[TS_DIM_gather_nodes] = lists;
	n[TS_DIM_gather_pairs] = n_pairs;
	expected->work = (u64)params->queue_mb << 20;
}

/* Paths begin at the texels of the maps, and there several of them may: their first lights are in the same places. */
static void expect(ts_expected *expected, const ts_scene *scene, const ts_params *params, bool alone)
{
	ts_hulls_expect(expected, scene, params);
	u64 texels = expected->sizes.n[TS_DIM_texels], n_paths = params->vpls != 0 ? params->vpls : texels;
	expected->sizes.n[TS_DIM_paths] = n_paths;
	u64 n_lights = n_paths * params->vpl_bounces, n_places = least(n_paths, texels) + n_lights - n_paths;
	ts_expect_views(expected, scene, params, n_lights, n_places, alone);
}

void ts_megaviews_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	expect(expected, scene, params, false);
}

void ts_manylods_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	expect(expected, scene, params, true);
}
