/* The rules that families have registered: see texels.h. */
#include "truth/texels.h"
#include <assert.h>

static const ts_texel_rule *const *lists;

void ts_texels_use(const ts_texel_rule *const *rules) { lists = rules; }

const ts_texel_rule *ts_texels_find(ts_buffer_id buffer)
{
	assert(lists != NULL);
	for (const ts_texel_rule *const *list = lists; *list != NULL; list++) {
		for (const ts_texel_rule *rule = *list; rule->judge != NULL; rule++) {
			if (rule->buffer == buffer) return rule;
		}
	}
	return NULL;
}
