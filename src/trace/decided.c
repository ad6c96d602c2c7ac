/* Margins against their thresholds. */
#include "decided.h"
#include "../kernels/num.h"

static const f32 sub_pixels = 1.0f, chance = 0.00000095367431640625f;

static const struct { ts_buffer_id buffer, margin; } margins[] = {
	{TS_B_eye_depth_triangle, TS_B_eye_margin},
	{TS_B_face_depth_triangle, TS_B_face_margin},
	{TS_B_cull_keep, TS_B_cull_margin},
	{TS_B_splat_depth_index, TS_B_splat_tie},
};

ts_status ts_decided_open(ts_decided *decided, const ts_trace *reference, ts_buffer_id id)
{
	*decided = (ts_decided){.margin = TS_N_BUFFERS};
	for (u32 i = 0; i < sizeof margins / sizeof *margins; i++) {
		if (margins[i].buffer == id) decided->margin = margins[i].margin;
	}
	if (decided->margin == TS_N_BUFFERS) return TS_OK;
	const ts_trace_item *item = &reference->item[decided->margin], *of = &reference->item[id];
	u64 every = decided->margin == TS_B_eye_margin || decided->margin == TS_B_face_margin ? 2 : 1;
	if (item->path == NULL || item->npy.n != of->npy.n * every) {
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
	if (margin == TS_B_cull_margin) {
		memcpy(&number, first, sizeof number);
		return number > chance;
	}
	memcpy(&edge, first, sizeof edge);
	memcpy(&depth, second, sizeof depth);
	return (edge == TS_EMPTY || ts_u2f((u32)edge) > sub_pixels) && (depth == TS_EMPTY || ts_u2f((u32)depth) > sub_pixels);
}

ts_status ts_decided_is(ts_decided *decided, u64 element, bool *is)
{
	*is = true;
	if (decided->reader == NULL) return TS_OK;
	u64 held, every = decided->margin == TS_B_eye_margin || decided->margin == TS_B_face_margin ? 2 : 1;
	u64 copy = 0;
	const void *first = ts_reader_at(decided->reader, element * every, &held);
	if (first == NULL) return TS_ERROR;
	memcpy(&copy, first, every == 2 ? sizeof copy : ts_buffer_table[decided->margin].element_bytes);
	const void *second = every == 2 ? ts_reader_at(decided->reader, element * 2 + 1, &held) : &copy;
	if (second == NULL) return TS_ERROR;
	*is = is_decided(decided->margin, &copy, second);
	return TS_OK;
}
