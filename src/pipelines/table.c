/* What pipelines there are. */
#include "pipelines.h"

const ts_pipeline ts_pipeline_table[] = {
	{"epr", "reflections", "EPR 3 and 4", "eye-based point rendering: one pass over the geometry for all cubes",
	 ts_epr_steps, NULL, ts_epr_expect},
	{"mvr", "reflections", "EPR 4.2", "multi-view rendering: one pass over the geometry for every cube", ts_mvr_steps,
	 ts_mvr_prepare, ts_mvr_expect},
	{0},
};

const ts_pipeline *ts_pipeline_find(const char *effect, const char *name)
{
	for (const ts_pipeline *p = ts_pipeline_table; p->name != NULL; p++) {
		if (strcmp(p->effect, effect) == 0 && strcmp(p->name, name) == 0) return p;
	}
	return NULL;
}
