/* align.frame: q within 24.8 of the lattice, so that edges fit 64 bits, s not negative; for count, points and stages
 * that make points without storing them, fewer than 2^34 lattice squares in the boxes of all pieces. points.offset, for
 * stage points or remade points: the sums of stage points.count for the same align.frame. */
#include <inttypes.h>
#include "kernels/raster/lattice.h"
#include "methods/points/tools/tools.h"

enum { MAX_LATTICE = (1 << 23) - 1 };
static const u64 max_squares = 1ull << 34;

/* Lattice squares that count and points visit. */
static u64 squares(const ts_align *frame)
{
	if (!(frame->s > 0.0f)) return 0;
	ts_box box = ts_k_lattice_cover(frame, TS_SAFE_HALF).touched;
	return box.x1 < box.x0 || box.y1 < box.y0 ? 0 : (u64)(box.x1 - box.x0 + 1) * (u64)(box.y1 - box.y0 + 1);
}

static ts_status check_frames(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	u64 n, all = 0;
	const ts_align *frames = ts_check_elements(load, id, &n);
	bool scatters = ts_stage_writes(stage, TS_B_depth_map_depth) || ts_stage_writes(stage, TS_B_scatter_colour);
	bool walked = scatters || ts_stage_writes(stage, TS_B_points_offset) || ts_stage_reads(stage, TS_B_points_offset);
	for (u64 i = 0; i < n; i++) {
		if (frames[i].s < 0.0f) return ts_check_refuse(load, id, i, "s", 0, "0 or more");
		for (u32 k = 0; k < 6; k++) {
			bool inside = frames[i].q[k] >= -MAX_LATTICE && frames[i].q[k] <= MAX_LATTICE;
			if (!inside) return ts_check_refuse(load, id, i, "q", k, "from -%d to %d", MAX_LATTICE, MAX_LATTICE);
		}
		all += squares(&frames[i]);
		if (walked && all > max_squares) {
			return ts_refuse("%s: element %" PRIu64 ": the pieces up to it span %" PRIu64 " lattice squares; at most "
			                 "%" PRIu64 " would be right",
			                 load->item[id]->path, i, all, max_squares);
		}
	}
	return TS_OK;
}

static ts_status check_counts(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)id;
	bool stored = ts_pipeline_maker(load->pipeline, TS_B_points_record) != NULL;
	if (stored && !ts_stage_writes(stage, TS_B_points_record)) return TS_OK;
	return ts_check_again(load, ts_pipeline_maker(load->pipeline, TS_B_points_offset)->stage, "align.frame");
}

const ts_check_rule ts_points_checks[] = {
	{TS_B_align_frame, TS_CHECK_VALUES, check_frames},
	{TS_B_points_offset, TS_CHECK_VALUES, check_counts},
	{.check = NULL},
};
