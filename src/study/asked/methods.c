/* The pipelines that --method names. */
#include "study/asked/methods.h"
#include <string.h>
#include "study/asked/words.h"

ts_status ts_effect_check(const char *effect)
{
	ts_nearest nearest = ts_nearest_begin(effect);
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++)
		ts_nearest_offer(&nearest, (*at)->effect->name);
	if (nearest.distance == 0) return TS_OK;
	return ts_fail("no effect \"%s\"%s", effect, ts_nearest_hint(&nearest, "touchstone list methods"));
}

void ts_effect_params(ts_job *job, const char *effect)
{
	const ts_effect *meant = ts_effect_find(effect);
	bool mirrors = meant != NULL && meant->mirrors;
	if (!mirrors && !job->mirrored) TS_PARAM_SET(&job->params, reflectors_count, 0);
}

static void add(const ts_pipeline *methods[TS_MAX_METHODS], u32 *n, const ts_pipeline *p)
{
	for (u32 i = 0; i < *n; i++) {
		if (methods[i] == p) return;
	}
	if (*n < TS_MAX_METHODS) methods[(*n)++] = p;
}

ts_status ts_methods_find(const ts_pipeline *methods[TS_MAX_METHODS], u32 *n, const char *effect, const char *names)
{
	char item[32];
	*n = 0;
	if (ts_effect_check(effect) != TS_OK) return TS_ERROR;
	bool all = names == NULL || strcmp(names, "all") == 0;
	for (const ts_pipeline *const *at = ts_pipelines(); all && *at != NULL; at++) {
		const ts_pipeline *p = *at;
		bool meant = names != NULL || !p->only_named;
		if (strcmp(p->effect->name, effect) == 0 && meant) add(methods, n, p);
	}
	while (!all && ts_words_item(&names, item, sizeof item)) {
		ts_nearest nearest = ts_nearest_begin(item);
		for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
			const ts_pipeline *p = *at;
			if (strcmp(p->effect->name, effect) == 0) ts_nearest_offer(&nearest, p->name);
		}
		if (nearest.distance != 0) {
			return ts_fail("--method: no method \"%s\" of %s%s", item, effect,
			               ts_nearest_hint(&nearest, "touchstone list methods"));
		}
		add(methods, n, ts_pipeline_find(effect, item));
	}
	return TS_OK;
}
