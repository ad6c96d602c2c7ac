/* Dynamic reflections by MegaViews: all cube maps of a frame as one many-view rendering (section 6, "reflections via
 * cube maps"; METHODS 14), beside those of EPR and MVR.
 *
 * The middle of each reflector's cube is a view to all sides. Octrees, traversal and maps are those of lights
 * (megaviews.c). The nodes that whole maps show are shaded, as MVR shades triangles. The maps become the mip chains of
 * cubes, which the eye's reflective pixels look up as they do MVR's.
 *
 * Deviations:
 * - the paper's maps are of points in one colour each: a node's mean material is shaded in full light for each view;
 * - a view leaves out its own reflector, as every method's cubes do: nodes of the reflector alone, and its triangles in
 *   leaves that it shares with others;
 * - a node has no back: a mean normal turns to the viewer, and surfaces seen from behind, which MVR drops, are shown;
 * - views of a leaf share its map, and so mirrors whose middles are in one leaf show the same. */
#include <math.h>
#include "kernels/raster/mip.h"
#include "methods/stages.h"
#include "methods/views/pipelines.h"

static const ts_step steps[] = {
	{.run = ts_frame_run},
	{.stage = "cube_size"},
	{.stage = "eye"},
	{.stage = "mirror_pixel"},
	{.stage = "octree.root"},
	{.stage = "voxel"},
	{.stage = "octree"},
	{.stage = "octree.surface"},
	{.stage = "octree.reflector"},
	{.stage = "cube_view"},
	{.run = ts_shared_views_run},
	{.stage = "view_map.fuse"},
	{.stage = "view_map.colour"},
	{.stage = "cube_view.mip", .each_batch = true},
	{.stage = "mirror", .each_batch = true},
	{.stage = "image"},
	{0},
};

static void plan_cubes(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request)
{
	(void)counts, (void)request;
	plan->views.field = TS_VIEW_FIELD_ALL;
	plan->views.px = TS_PARAM(params, cube_view_px);
	plan->views.cubes = true;
}

/* The cubes of one reflector at a time. */
static void expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	u64 face = ts_expected_face(params), n = scene->info.n_reflectors;
	const ts_expected_lights lights = {n, n, INFINITY, false, TS_PARAM(params, cube_view_px)};
	ts_expect_mirrors(expected, scene, params);
	ts_expect_views(expected, scene, params, &lights);
	expected->batches = n;
	expected->sizes.n[TS_DIM_texels] = n != 0 ? 6 * face * face : 0;
	expected->sizes.n[TS_DIM_mip_texels] = n != 0 ? ts_k_mip_texels((u32)face, TS_NONE) : 0;
}

const ts_pipeline ts_pipeline_megaviews_reflections = {
	.name = "megaviews",
	.effect = &ts_effect_reflections,
	.paper = "MegaViews 3 and 6",
	.doc = "all cubes as views, in one traversal of the octrees of scene and views",
	.steps = steps,
	.plan = plan_cubes,
	.expect = expect,
	.lower = "octree.levels, cube_view.px or reflectors.count",
	.only_named = true,
};
