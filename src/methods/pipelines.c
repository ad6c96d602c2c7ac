/* What effects and pipelines there are. */
#include "pipelines.h"

const ts_effect ts_effect_table[] = {
	{.name = "reflections", .mirrors = true, .difference_scale = 8, .lower = "fewer --reflectors"},
	{.name = "soft-shadows", .difference_scale = 8, .lower = "map_px or pass"},
	{.name = "omni-shadows", .difference_scale = 8, .lower = "map_px or pass"},
	{.name = "indirect", .difference_scale = 4, .lower = "grid_px or rsm_px"},
	{.name = "particles", .difference_scale = 8, .lower = "levels, gather_level, view_px or particles"},
	{.name = "surfels", .difference_scale = 8, .lower = "map_px or from_mesh"},
	{0},
};

const ts_pipeline ts_pipeline_table[] = {
	{
		.name = "epr", .effect = "reflections", .paper = "EPR 3 and 4",
		.doc = "eye-based point rendering: one pass over the geometry for all cubes",
		.steps = ts_epr_steps, .expect = ts_epr_expect,
	},
	{
		.name = "mvr", .effect = "reflections", .paper = "EPR 4.2",
		.doc = "multi-view rendering: one pass over the geometry for every cube",
		.steps = ts_mvr_steps, .plan = ts_mvr_plan, .expect = ts_mvr_expect,
	},
	{
		.name = "ivir", .effect = "reflections", .paper = "iVIR 5",
		.doc = "improved view-independent rendering: points as dense as the cubes' texels, for all cubes",
		.steps = ts_ivir_reflections_steps, .plan = ts_ivir_plan, .expect = ts_ivir_expect,
	},
	{
		.name = "vir", .effect = "reflections", .paper = "iVIR 5",
		.doc = "view-independent rendering: points as dense as the worst texel of any cube",
		.steps = ts_ivir_reflections_steps, .plan = ts_vir_plan, .expect = ts_vir_expect,
		.only_named = true,
	},
	{
		.name = "ivir", .effect = "soft-shadows", .paper = "iVIR 4",
		.doc = "one set of points for the depth maps of all light samples",
		.steps = ts_ivir_soft_steps, .plan = ts_ivir_soft_plan, .expect = ts_soft_expect,
	},
	{
		.name = "vir", .effect = "soft-shadows", .paper = "iVIR 4",
		.doc = "the same with the density of view-independent rendering",
		.steps = ts_ivir_soft_steps, .plan = ts_vir_soft_plan, .expect = ts_soft_expect,
		.only_named = true,
	},
	{
		.name = "mvr", .effect = "soft-shadows", .paper = "iVIR 4",
		.doc = "one pass over the geometry for every depth map",
		.steps = ts_mvr_soft_steps, .plan = ts_soft_plan, .expect = ts_soft_expect,
	},
	{
		.name = "pcss", .effect = "soft-shadows", .paper = "iVIR 4",
		.doc = "percentage-closer soft shadows: one depth map a light, filtered as wide as its penumbra",
		.steps = ts_pcss_steps, .plan = ts_pcss_plan, .expect = ts_pcss_expect,
	},
	{
		.name = "ivir", .effect = "omni-shadows", .paper = "iVIR 6",
		.doc = "one set of points for the cubes of all light samples",
		.steps = ts_ivir_omni_steps, .plan = ts_ivir_omni_plan, .expect = ts_omni_expect,
	},
	{
		.name = "vir", .effect = "omni-shadows", .paper = "iVIR 6",
		.doc = "the same with the density of view-independent rendering",
		.steps = ts_ivir_omni_steps, .plan = ts_vir_omni_plan, .expect = ts_vir_omni_expect,
		.only_named = true,
	},
	{
		.name = "epr", .effect = "omni-shadows", .paper = "EPR 5",
		.doc = "points no denser than the eye can tell in a shadow, splatted into the cubes of all light samples",
		.steps = ts_epr_omni_steps, .plan = ts_ivir_omni_plan, .expect = ts_omni_expect,
	},
	{
		.name = "mvr", .effect = "omni-shadows", .paper = "iVIR 6",
		.doc = "one pass over the geometry for every face of every cube",
		.steps = ts_mvr_omni_steps, .plan = ts_omni_plan, .expect = ts_omni_expect,
	},
	{
		.name = "hulls", .effect = "indirect", .paper = "SSAGH 3 and 4",
		.doc = "screen-space approximate Gaussian hulls: light gathered at the corners of depth segments",
		.steps = ts_hulls_steps, .plan = ts_indirect_plan, .expect = ts_hulls_expect,
	},
	{
		.name = "direct", .effect = "indirect", .paper = "SSAGH 5",
		.doc = "the same light gathered by every pixel",
		.steps = ts_direct_steps, .plan = ts_indirect_plan, .expect = ts_hulls_expect,
	},
	{
		.name = "megaviews", .effect = "indirect", .paper = "MegaViews 3 and 5.1",
		.doc = "many small views at once: virtual point lights with maps that octrees of scene and views share",
		.steps = ts_megaviews_steps, .plan = ts_indirect_plan, .expect = ts_megaviews_expect,
		.lower = "levels, gather_level, view_px or vpls",
	},
	{
		.name = "manylods", .effect = "indirect", .paper = "MegaViews 4.1",
		.doc = "the same lights, the map of each by a traversal of its own",
		.steps = ts_manylods_steps, .plan = ts_indirect_plan, .expect = ts_manylods_expect,
		.lower = "levels, gather_level, view_px or vpls",
	},
	{
		.name = "bruteforce", .effect = "indirect", .paper = "MegaViews 4.1",
		.doc = "the same lights, every leaf of the scene in the map of each",
		.steps = ts_bruteforce_steps, .plan = ts_indirect_plan, .expect = ts_manylods_expect,
		.lower = "levels, gather_level, view_px or vpls",
		.only_named = true,
	},
	{
		.name = "megaviews", .effect = "particles", .paper = "MegaViews 3 and 5.2",
		.doc = "many small views at once: glowing particles with maps that octrees of scene and views share",
		.steps = ts_megaviews_particles_steps, .plan = ts_particles_plan, .expect = ts_megaviews_particles_expect,
		.sets = {"view_field", "all"},
	},
	{
		.name = "manylods", .effect = "particles", .paper = "MegaViews 4.1",
		.doc = "the same particles, the map of each by a traversal of its own",
		.steps = ts_manylods_particles_steps, .plan = ts_particles_plan, .expect = ts_manylods_particles_expect,
		.sets = {"view_field", "all"},
	},
	{
		.name = "bruteforce", .effect = "particles", .paper = "MegaViews 4.1",
		.doc = "the same particles, every leaf of the scene in the map of each",
		.steps = ts_bruteforce_particles_steps, .plan = ts_particles_plan, .expect = ts_manylods_particles_expect,
		.only_named = true,
		.sets = {"view_field", "all"},
	},
	{
		.name = "deferred", .effect = "surfels", .paper = "NV40: 3-Pass Deferred Shading",
		.doc = "deferred surface splatting: surfels blended in three passes, filtered by the lesser radius",
		.steps = ts_surfels_steps, .plan = ts_deferred_plan, .expect = ts_surfels_expect,
		.sets = {"lamp", "scene"},
	},
	{
		.name = "ewa", .effect = "surfels", .paper = "EWA",
		.doc = "the same with the exact EWA filter",
		.steps = ts_surfels_steps, .plan = ts_ewa_plan, .expect = ts_surfels_expect,
		.sets = {"lamp", "scene"},
	},
	{0},
};

const ts_pipeline *ts_pipeline_find(const char *effect, const char *name)
{
	for (const ts_pipeline *p = ts_pipeline_table; p->name != NULL; p++) {
		if (strcmp(p->effect, effect) == 0 && strcmp(p->name, name) == 0) return p;
	}
	return NULL;
}

const ts_effect *ts_effect_find(const char *name)
{
	const ts_effect *effect = ts_effect_table;
	while (effect->name != NULL && strcmp(effect->name, name) != 0) effect++;
	return effect->name != NULL ? effect : NULL;
}

bool ts_pipeline_makes(const ts_pipeline *pipeline, const ts_buffer_id *ids)
{
	while (*ids != TS_N_BUFFERS && ts_pipeline_maker(pipeline, *ids) != NULL) ids++;
	return *ids == TS_N_BUFFERS;
}

const ts_pipeline *ts_pipeline_making(const char *effect, const ts_buffer_id *ids)
{
	for (const ts_pipeline *p = ts_pipeline_table; p->name != NULL; p++) {
		bool meant = effect == NULL || strcmp(p->effect, effect) == 0;
		if (meant && ts_pipeline_makes(p, ids)) return p;
	}
	return NULL;
}
