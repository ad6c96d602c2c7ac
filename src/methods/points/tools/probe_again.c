/* Points that the method does not store: stage `points` makes them from the trace, as if they were stored. */
#include <stdlib.h>
#include "methods/points/tools/probe.h"
#include "replay/replay.h"

/* A copy of the stage's buffer, instead of a file. */
static ts_status hold(ts_probe *p, ts_buffer_id id)
{
	const ts_buffer *made = &p->load->run.frame.buffer[id];
	ts_trace_item *item = &p->trace->item[id];
	size_t bytes = (size_t)made->n * ts_buffer_table[id].element_bytes;
	p->whole[id] = ts_alloc((size_t)made->n, ts_buffer_table[id].element_bytes, ts_buffer_table[id].name);
	if (p->whole[id] == NULL) return TS_ERROR;
	item->path = (char *)(uintptr_t)ts_buffer_table[id].name;
	memcpy(p->whole[id], made->data, bytes);
	item->memory = p->whole[id];
	item->npy = (ts_npy){.n = made->n, .n_dims = made->n_dims};
	memcpy(item->npy.shape, made->shape, sizeof made->shape);
	return TS_OK;
}

ts_status ts_probe_points_again(ts_probe *p)
{
	const ts_stage *points = ts_stage_find("points");
	bool counted = ts_probe_makes(p, TS_B_points_offset), stored = ts_probe_makes(p, TS_B_points_record);
	if (!counted || stored || ts_probe_has(p, TS_B_points_record)) return TS_OK;
	static const ts_buffer_id needed[] = {TS_B_points_offset, TS_B_align_frame, TS_B_split_piece, TS_N_BUFFERS};
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	if (ts_probe_load_for(p, (const char *const[]){points->name, NULL}) != TS_OK) return TS_ERROR;
	if (ts_replay_stage(&p->load->run, points) != TS_OK) return TS_ERROR;
	p->sizes.n[TS_DIM_points] = ts_frame_n(&p->load->run.frame, TS_B_points_record);
	return hold(p, TS_B_points_record) == TS_OK ? hold(p, TS_B_points_key) : TS_ERROR;
}
