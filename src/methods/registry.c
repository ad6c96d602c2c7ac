/* The registered tables. */
#include "methods/registry.h"
#include <assert.h>

static const ts_registry *used;

void ts_registry_use(const ts_registry *registry) { used = registry; }

const ts_registry *ts_registered(void)
{
	assert(used != NULL);
	return used;
}

const ts_stage *const *ts_stages(void) { return ts_registered()->stages; }

const ts_pipeline *const *ts_pipelines(void) { return ts_registered()->pipelines; }
