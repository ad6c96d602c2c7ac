/* The registered tables, and pipelines by name and by their buffers. */
#include "methods/registry.h"
#include <assert.h>
#include "methods/pipeline.h"

static const ts_registry *used;

void ts_registry_use(const ts_registry *registry) { used = registry; }

const ts_registry *ts_registered(void)
{
	assert(used != NULL);
	return used;
}

const ts_stage *const *ts_stages(void) { return ts_registered()->stages; }

const ts_pipeline *const *ts_pipelines(void) { return ts_registered()->pipelines; }

const ts_pipeline *ts_pipeline_find(const char *effect, const char *name)
{
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		const ts_pipeline *p = *at;
		if (strcmp(p->effect->name, effect) == 0 && strcmp(p->name, name) == 0) return p;
	}
	return NULL;
}

const ts_effect *ts_effect_find(const char *name)
{
	const ts_pipeline *const *at = ts_pipelines();
	while (*at != NULL && strcmp((*at)->effect->name, name) != 0) at++;
	return *at != NULL ? (*at)->effect : NULL;
}

bool ts_pipeline_makes(const ts_pipeline *pipeline, const ts_buffer_id *ids)
{
	while (*ids != TS_N_BUFFERS && ts_pipeline_maker(pipeline, *ids) != NULL) ids++;
	return *ids == TS_N_BUFFERS;
}

const ts_pipeline *ts_pipeline_making(const char *effect, const ts_buffer_id *ids)
{
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		const ts_pipeline *p = *at;
		bool meant = effect == NULL || strcmp(p->effect->name, effect) == 0;
		if (meant && ts_pipeline_makes(p, ids)) return p;
	}
	return NULL;
}

const u64 *ts_pipeline_seen(const ts_run *run, u64 *n)
{
	ts_buffer_id id = run->pipeline->effect->seen;
	*n = ts_frame_n(&run->frame, id);
	return ts_frame_data(&run->frame, id);
}
