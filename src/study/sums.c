/* Sums and tables of the families in the report of a frame. */
#include "study/sums.h"
#include <assert.h>

static const ts_bytes_rule *const *bytes;
static const ts_figures_rule *const *figures;

void ts_sums_bytes_use(const ts_bytes_rule *const *rules) { bytes = rules; }
void ts_sums_figures_use(const ts_figures_rule *const *rules) { figures = rules; }

const ts_bytes_rule *const *ts_sums_bytes(void)
{
	assert(bytes != NULL);
	return bytes;
}

const ts_figures_rule *const *ts_sums_figures(void)
{
	assert(figures != NULL);
	return figures;
}

const ts_measure *ts_sums_find(const ts_measured_frame *of, ts_buffer_id id)
{
	for (u32 i = 0; i < of->n_measures; i++) {
		if (ts_pipeline_maker(of->measures[i].method, id) != NULL) return &of->measures[i];
	}
	return NULL;
}
