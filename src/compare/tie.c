/* The rules that families have registered: see tie.h. */
#include "compare/tie.h"
#include <assert.h>

static const ts_tie_rule *const *lists;

void ts_tie_use(const ts_tie_rule *const *rules) { lists = rules; }

const ts_tie_rule *ts_tie_find(ts_buffer_id buffer)
{
	assert(lists != NULL);
	for (const ts_tie_rule *const *list = lists; *list != NULL; list++) {
		for (const ts_tie_rule *rule = *list; rule->open != NULL; rule++) {
			if (rule->buffer == buffer) return rule;
		}
	}
	return NULL;
}
