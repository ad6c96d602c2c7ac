/* The grid of depth and the boxes of its segments. */
#include <inttypes.h>
#include "methods/hulls/tools/tools.h"
#include "methods/stages.h"

static ts_status check_grid(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	(void)id;
	return ts_grid_check(&load->run.params);
}

static ts_status check_segments(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n;
	const ts_segment *boxes = ts_check_elements(load, id, &n);
	for (u64 i = 0; i < n; i++) {
		for (u32 k = 0; k < 2; k++) {
			if (boxes[i].high[k] >= boxes[i].low[k]) continue;
			return ts_check_refuse(load, id, i, "high", k, "at least %" PRIu32 ", as low,", boxes[i].low[k]);
		}
	}
	return TS_OK;
}

const ts_check_rule ts_hulls_checks[] = {
	{TS_B_depth_grid_depth, TS_CHECK_PARAMS, check_grid},
	{TS_B_segment_box, TS_CHECK_VALUES, check_segments},
	{.check = NULL},
};
