/* What pipelines there are. */
#include "pipelines.h"

#include <assert.h>

const ts_pipeline ts_pipeline_table[] = {
	{"epr", "reflections", "EPR 3 and 4", "eye-based point rendering: one pass over the geometry for all cubes",
	 ts_epr_run, ts_epr_estimate},
	{"mvr", "reflections", "EPR 4.2", "multi-view rendering: one pass over the geometry for every cube", ts_mvr_run,
	 ts_mvr_estimate},
	{0},
};

const ts_pipeline *ts_pipeline_find(const char *effect, const char *name)
{
	for (const ts_pipeline *p = ts_pipeline_table; p->name != NULL; p++) {
		if (strcmp(p->effect, effect) == 0 && strcmp(p->name, name) == 0) return p;
	}
	return NULL;
}

ts_status ts_run_stages(ts_run *run, const char *const *names)
{
	for (; *names != NULL; names++) {
		const ts_stage *stage = ts_stage_find(*names);
		assert(stage != NULL);
		if (ts_run_stage(run, stage) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* A mirror covers at most a quarter of the image on average. */
u64 ts_common_estimate(const ts_scene *scene, const ts_params *params)
{
	u64 pixels = (u64)params->width * params->height;
	return (u64)scene->n_vertices * sizeof(ts_vertex) +
	       pixels * (sizeof(u64) + sizeof(u32) + 3 * sizeof(f32) + 3) + pixels / 4 * (sizeof(ts_pixel) + 3 * sizeof(f32));
}
