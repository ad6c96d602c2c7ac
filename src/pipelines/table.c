/* What pipelines there are. */
#include "pipelines.h"

const ts_pipeline ts_pipeline_table[] = {
	{"epr", "reflections", "EPR 3 and 4", "eye-based point rendering: one pass over the geometry for all cubes",
	 ts_epr_steps, NULL, ts_epr_expect, false},
	{"mvr", "reflections", "EPR 4.2", "multi-view rendering: one pass over the geometry for every cube", ts_mvr_steps,
	 ts_mvr_prepare, ts_mvr_expect, false},
	{"ivir", "reflections", "iVIR 5",
	 "improved view-independent rendering: points as dense as the cubes' texels, for all cubes",
	 ts_ivir_reflections_steps, ts_ivir_prepare, ts_ivir_expect, false},
	{"vir", "reflections", "iVIR 5", "view-independent rendering: points as dense as the worst texel of any cube",
	 ts_ivir_reflections_steps, ts_vir_prepare, ts_vir_expect, true},
	{"ivir", "soft-shadows", "iVIR 4", "one set of points for the depth maps of all light samples", ts_ivir_soft_steps,
	 ts_ivir_soft_prepare, ts_soft_expect, false},
	{"vir", "soft-shadows", "iVIR 4", "the same with the density of view-independent rendering", ts_ivir_soft_steps,
	 ts_vir_soft_prepare, ts_soft_expect, true},
	{"mvr", "soft-shadows", "iVIR 4", "one pass over the geometry for every depth map", ts_mvr_soft_steps,
	 ts_soft_prepare, ts_soft_expect, false},
	{"pcss", "soft-shadows", "iVIR 4",
	 "percentage-closer soft shadows: one depth map a light, filtered as wide as its penumbra",
	 ts_pcss_steps, ts_pcss_prepare, ts_pcss_expect, false},
	{"ivir", "omni-shadows", "iVIR 6", "one set of points for the cubes of all light samples", ts_ivir_omni_steps,
	 ts_ivir_omni_prepare, ts_omni_expect, false},
	{"vir", "omni-shadows", "iVIR 6", "the same with the density of view-independent rendering", ts_ivir_omni_steps,
	 ts_vir_omni_prepare, ts_vir_omni_expect, true},
	{"epr", "omni-shadows", "EPR 5",
	 "points no denser than the eye can tell in a shadow, splatted into the cubes of all light samples",
	 ts_epr_omni_steps, ts_ivir_omni_prepare, ts_omni_expect, false},
	{"mvr", "omni-shadows", "iVIR 6", "one pass over the geometry for every face of every cube", ts_mvr_omni_steps,
	 ts_omni_prepare, ts_omni_expect, false},
	{"hulls", "indirect", "SSAGH 3 and 4",
	 "screen-space approximate Gaussian hulls: light gathered at the corners of depth segments",
	 ts_hulls_steps, ts_indirect_prepare, ts_hulls_expect, false},
	{"direct", "indirect", "SSAGH 5", "the same light gathered by every pixel", ts_direct_steps, ts_indirect_prepare,
	 ts_hulls_expect, false},
	{"megaviews", "indirect", "MegaViews 3 and 5.1",
	 "many small views at once: virtual point lights with maps that octrees of scene and views share",
	 ts_megaviews_steps, ts_indirect_prepare, ts_megaviews_expect, false},
	{"manylods", "indirect", "MegaViews 4.1", "the same lights, the map of each by a traversal of its own",
	 ts_manylods_steps, ts_indirect_prepare, ts_manylods_expect, false},
	{"bruteforce", "indirect", "MegaViews 4.1", "the same lights, every leaf of the scene in the map of each",
	 ts_bruteforce_steps, ts_indirect_prepare, ts_manylods_expect, true},
	{"megaviews", "particles", "MegaViews 3 and 5.2",
	 "many small views at once: glowing particles with maps that octrees of scene and views share",
	 ts_megaviews_particles_steps, ts_particles_prepare, ts_megaviews_particles_expect, false},
	{"manylods", "particles", "MegaViews 4.1", "the same particles, the map of each by a traversal of its own",
	 ts_manylods_particles_steps, ts_particles_prepare, ts_manylods_particles_expect, false},
	{"bruteforce", "particles", "MegaViews 4.1", "the same particles, every leaf of the scene in the map of each",
	 ts_bruteforce_particles_steps, ts_particles_prepare, ts_manylods_particles_expect, true},
	{"deferred", "surfels", "NV40 3 to 5",
	 "deferred surface splatting: surfels blended in three passes, filtered by the lesser radius",
	 ts_surfels_steps, ts_deferred_prepare, ts_surfels_expect, false},
	{"ewa", "surfels", "SPEC 5.6", "the same with the exact EWA filter", ts_surfels_steps, ts_ewa_prepare,
	 ts_surfels_expect, false},
	{0},
};

const ts_pipeline *ts_pipeline_find(const char *effect, const char *name)
{
	for (const ts_pipeline *p = ts_pipeline_table; p->name != NULL; p++) {
		if (strcmp(p->effect, effect) == 0 && strcmp(p->name, name) == 0) return p;
	}
	return NULL;
}
