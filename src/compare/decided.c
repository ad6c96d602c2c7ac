/* Margins against their thresholds. */
#include "decided.h"
#include "../kernels/base/num.h"

static const f32 steps = 1.0f, chance = 0.00000095367431640625f;

/* Margins of so many elements each. */
static const struct { ts_buffer_id buffer, margin; u32 of; } margins[] = {
	{TS_B_eye_depth_triangle, TS_B_eye_margin, 1},
	{TS_B_face_depth_triangle, TS_B_face_margin, 1},
	{TS_B_cull_keep, TS_B_cull_margin, 1},
	{TS_B_splat_depth_index, TS_B_splat_tie, 1},
	{TS_B_scatter_depth, TS_B_depth_margin, 1},
	{TS_B_resolve_lit, TS_B_resolve_margin, 1},
	{TS_B_segment_label, TS_B_segment_margin, 1},
	{TS_B_hull_box, TS_B_hull_margin, 1},
	{TS_B_map_depth_node, TS_B_map_margin, 1},
	{TS_B_vpl_gather_irradiance, TS_B_vpl_gather_margin, 3},
	{TS_B_surfel_depth_surfel, TS_B_surfel_depth_margin, 1},
	{TS_B_blend_sum, TS_B_blend_margin, 8},
	{TS_B_blend_heaviest, TS_B_blend_margin, 1},
	{TS_B_image_radiance, TS_B_deferred_margin, 3},
};

/* True if runs of the method have these margins. Of a file alone that is not known, but few pictures have any. */
static bool is_measured(const ts_trace *reference, ts_buffer_id margin)
{
	if (reference->pipeline == NULL) return margin != TS_B_deferred_margin;
	return ts_pipeline_maker(reference->pipeline, margin) != NULL;
}

/* Margins are pairs of f32 bits in words of 64, a f32, or of ties a byte. */
static u64 every(ts_buffer_id margin) { return ts_buffer_table[margin].element_bytes == sizeof(u64) ? 2 : 1; }

ts_status ts_decided_open(ts_decided *decided, const ts_trace *reference, ts_buffer_id id)
{
	*decided = (ts_decided){.margin = TS_N_BUFFERS};
	for (u32 i = 0; i < sizeof margins / sizeof *margins; i++) {
		if (margins[i].buffer != id || !is_measured(reference, margins[i].margin)) continue;
		decided->margin = margins[i].margin;
		decided->of = margins[i].of;
	}
	if (decided->margin == TS_N_BUFFERS) return TS_OK;
	const ts_trace_item *item = &reference->item[decided->margin], *of = &reference->item[id];
	if (item->path == NULL || item->npy.n * decided->of != of->npy.n * every(decided->margin)) {
		return ts_fail("%s: --decided needs %s for each element of %s; render the reference with --margins", reference->dir,
		               ts_buffer_table[decided->margin].name, ts_buffer_table[id].name);
	}
	decided->reader = ts_trace_read(item, decided->margin);
	return decided->reader != NULL ? TS_OK : TS_ERROR;
}

void ts_decided_close(ts_decided *decided)
{
	ts_reader_close(decided->reader);
	decided->reader = NULL;
}

static bool is_decided(ts_buffer_id margin, const void *first, const void *second)
{
	u64 edge, depth;
	f32 number;
	if (margin == TS_B_splat_tie) return *(const u8 *)first == 0;
	if (every(margin) == 1) {
		memcpy(&number, first, sizeof number);
		return !(number <= (margin == TS_B_cull_margin ? chance : steps)); /* all ones are none */
	}
	memcpy(&edge, first, sizeof edge);
	memcpy(&depth, second, sizeof depth);
	return (edge == TS_EMPTY || ts_u2f((u32)edge) > steps) && (depth == TS_EMPTY || ts_u2f((u32)depth) > steps);
}

ts_status ts_decided_is(ts_decided *decided, u64 element, bool *is)
{
	*is = true;
	if (decided->reader == NULL) return TS_OK;
	u64 held, n = every(decided->margin), copy = 0;
	const void *first = ts_reader_at(decided->reader, element / decided->of * n, &held);
	if (first == NULL) return TS_ERROR;
	memcpy(&copy, first, ts_buffer_table[decided->margin].element_bytes);
	const void *second = n == 2 ? ts_reader_at(decided->reader, element / decided->of * 2 + 1, &held) : &copy;
	if (second == NULL) return TS_ERROR;
	*is = is_decided(decided->margin, &copy, second);
	return TS_OK;
}
