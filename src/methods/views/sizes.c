/* Computed sizes of many views. */
#include "kernels/views/view_map.h"
#include "methods/registry.h"
#include "methods/views/octree.h"

u64 ts_size_levels(const ts_size_question *q) { return TS_PARAM(&q->run->params, octree_levels) + 1; }

u64 ts_size_mask_words(const ts_size_question *q)
{
	return ts_k_mask_first(TS_PARAM(&q->run->params, octree_levels) + 1);
}

/* Whether an octree's levels are there, and complete. */
static bool has_levels(const ts_size_question *q, ts_buffer_id level)
{
	return ts_is_made(q, level) && ts_frame_n(&q->run->frame, level) == TS_PARAM(&q->run->params, octree_levels) + 2;
}

static u64 leaves_of(const ts_size_question *q, ts_buffer_id level)
{
	if (!has_levels(q, level)) return TS_UNKNOWN;
	const u32 *first = (const u32 *)ts_frame_data(&q->run->frame, level) + TS_PARAM(&q->run->params, octree_levels);
	return first[1] - first[0];
}

u64 ts_size_leaves(const ts_size_question *q) { return leaves_of(q, TS_B_octree_level); }

u64 ts_size_view_leaves(const ts_size_question *q) { return leaves_of(q, TS_B_view_octree_level); }

u64 ts_size_view_side(const ts_size_question *q) { return q->run->plan.views.px; }

u64 ts_size_map_texels(const ts_size_question *q)
{
	ts_pyramid pyramid = ts_view_pyramid(&q->run->params, &q->run->plan);
	return ts_k_pyramid_texels(&pyramid);
}

u64 ts_size_gather_nodes(const ts_size_question *q)
{
	bool views = has_levels(q, TS_B_view_octree_level) && ts_is_made(q, TS_B_view_octree_node);
	if (!views || !has_levels(q, TS_B_octree_level)) return TS_UNKNOWN;
	const u32 *first = (const u32 *)ts_frame_data(&q->run->frame, TS_B_octree_level) + ts_gather_level(q->run);
	return first[1] - first[0];
}
