/* Stages of a comparison as cases. */
#include "cli/compare_shard.h"
#include <stdio.h>
#include <string.h>

json_t *ts_compare_cases(const ts_trace_info *of)
{
	const ts_stage_info *stage;
	json_t *names = json_pack("[s]", "scene");
	int failed = names == NULL;
	for (size_t i = 0; (stage = ts_method_stage(of->effect, of->method, i)) != NULL; i++) {
		failed |= json_array_append_new(names, json_string(stage->name)) != 0;
	}
	if (failed == 0) return names;
	json_decref(names);
	ts_fail("the names of stages: out of memory");
	return NULL;
}

char *ts_compare_own(const json_t *cases, ts_shard shard)
{
	size_t bytes = 1, used = 0, i;
	json_t *name;
	json_array_foreach (cases, i, name) bytes += json_string_length(name) + 1;
	char *own = ts_alloc_zero(bytes, 1, "the names of stages");
	json_array_foreach (cases, i, name) {
		if (own == NULL || !ts_shard_has(shard, i)) continue;
		used += (size_t)snprintf(own + used, bytes - used, "%s%s", used > 0 ? "," : "", json_string_value(name));
	}
	return own;
}
