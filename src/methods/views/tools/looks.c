/* What tables look at beside figures. */
#include <math.h>
#include "methods/stages.h"
#include "methods/views/tools/tools.h"

/* Share of the empty texels in the fused maps of leaves, in %. */
static double empty_share(const ts_run *run)
{
	if (!run->frame.buffer[TS_B_view_map_fused_depth].made) return NAN;
	const u32 *depth = ts_frame_data(&run->frame, TS_B_view_map_fused_depth);
	const ts_node *node = ts_frame_data(&run->frame, TS_B_view_octree_node);
	u64 n = ts_frame_n(&run->frame, TS_B_view_octree_node), all = 0, empty = 0;
	u64 n_texels = (u64)2 * run->plan.views.px * run->plan.views.px;
	for (u64 i = 0; i < n; i++) {
		if (node[i].children != 0) continue;
		for (u64 k = 0; k < n_texels; k++) empty += depth[i * n_texels + k] == TS_NONE;
		all += n_texels;
	}
	return 100 * ((double)empty / (double)all);
}

const ts_table_code ts_views_codes[] = {
	{"empty_share", .look = empty_share},
	{0},
};
