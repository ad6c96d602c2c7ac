/* Lists of views that pixels draw from: the drawn numbers are indices. */
#include <inttypes.h>
#include "kernels/views/mask.h"
#include "methods/views/tools/tools.h"

/* The sums up to each node of a list add up its cones' views. */
static ts_status check_list(const ts_load *load, u32 from, u32 to)
{
	const u32 *node = ts_frame_data(&load->run.frame, TS_B_vpl_gather_pair_node);
	const u32 *views = ts_frame_data(&load->run.frame, TS_B_vpl_gather_pair_views);
	const ts_cone *cones = ts_frame_data(&load->run.frame, TS_B_view_octree_cone);
	u32 sum = 0;
	for (u32 k = from; k < to; k++) {
		sum += cones[node[k]].views;
		if (views[k] != sum)
			return ts_check_refuse(load, TS_B_vpl_gather_pair_views, k, "", 0, "%" PRIu32 ", the sum,", sum);
	}
	return TS_OK;
}

/* Levels of voxel.before begin where octree.level has them: a voxel's id is its node. */
static ts_status check_voxels(const ts_load *load)
{
	const u32 *before = ts_frame_data(&load->run.frame, TS_B_voxel_before);
	const u32 *level = ts_frame_data(&load->run.frame, TS_B_octree_level);
	for (u32 l = 0; l <= TS_PARAM(&load->run.params, octree_levels) + 1; l++) {
		u32 first = before[ts_k_mask_first(l)];
		if (level[l] == first) continue;
		return ts_check_refuse(load, TS_B_octree_level, l, "", 0, "%" PRIu32 ", as voxel.before,", first);
	}
	return TS_OK;
}

ts_status ts_check_gather(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	if (!ts_stage_reads(stage, id)) return TS_OK;
	const u32 *offset = ts_frame_data(&load->run.frame, TS_B_vpl_gather_pair_offset);
	u64 n_lists = ts_frame_n(&load->run.frame, TS_B_vpl_gather_pair_offset) - 1;
	for (u64 i = 0; i < n_lists; i++) {
		if (check_list(load, offset[i], offset[i + 1]) != TS_OK) return TS_ERROR;
	}
	return check_voxels(load);
}
