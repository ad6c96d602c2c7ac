/* The ground truths that families have registered. */
#include "truth/table.h"
#include <assert.h>

static const ts_truth_kind *table[TS_MAX_TRUTHS + 1];

void ts_truths_use(const ts_truth_kind *const *kinds)
{
	u32 n = 0;
	for (; *kinds != NULL; kinds++) {
		for (const ts_truth_kind *kind = *kinds; kind->name != NULL; kind++) {
			assert(n < TS_MAX_TRUTHS);
			table[n++] = kind;
		}
	}
	table[n] = NULL;
}

const ts_truth_kind *const *ts_truths(void) { return table; }

bool ts_truth_starts_from(const ts_truth_kind *kind, const ts_pipeline *method)
{
	return kind->needs != NULL && ts_pipeline_makes(method, kind->needs);
}
