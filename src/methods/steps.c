/* The steps of all methods, flattened once: runs of steps in place, margins after their stages. */
#include <assert.h>
#include <pthread.h>
#include "methods/pipeline.h"

enum { MOST_PIPELINES = 32, MOST_STEPS = 64 };
static ts_step flat[MOST_PIPELINES][MOST_STEPS];

static void append(ts_step *to, u32 *n, const ts_step *step)
{
	assert(*n + 1 < MOST_STEPS); /* the last has no stage */
	to[(*n)++] = *step;
}

static void append_margin(ts_step *to, u32 *n, const ts_step *step)
{
	const ts_stage *stage = ts_stage_find(step->stage);
	assert(stage != NULL);
	const ts_stage *margin = ts_stage_margin(stage);
	if (margin == NULL) return;
	ts_step of = *step;
	of.stage = margin->name;
	of.only_margins = true;
	append(to, n, &of);
}

static void flatten(ts_step *to, u32 *n, const ts_step *step)
{
	for (; step->stage != NULL || step->run != NULL; step++) {
		if (step->run != NULL) {
			flatten(to, n, step->run);
		} else {
			append(to, n, step);
			append_margin(to, n, step);
		}
	}
}

static void flatten_all(void)
{
	for (u32 i = 0; ts_pipelines()[i] != NULL; i++) {
		u32 n = 0;
		assert(i < MOST_PIPELINES);
		flatten(flat[i], &n, ts_pipelines()[i]->steps);
	}
}

const ts_step *ts_pipeline_steps(const ts_pipeline *pipeline)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, flatten_all);
	for (u32 i = 0; ts_pipelines()[i] != NULL; i++) {
		if (pipeline == ts_pipelines()[i]) return flat[i];
	}
	return pipeline->steps;
}
