/* Outputs of a stage compared with the stage's results from the other buffers. */
#include <inttypes.h>
#include "replay/check.h"

static ts_status compare(const ts_load *load, const ts_frame *right, ts_buffer_id id, const char *maker,
                         const char *from)
{
	size_t bytes = ts_buffer_table[id].element_bytes;
	const u8 *a = ts_frame_data(&load->run.frame, id), *b = ts_frame_data(right, id);
	for (u64 i = 0, n = ts_frame_n(right, id); i < n; i++) {
		if (memcmp(a + i * bytes, b + i * bytes, bytes) == 0) continue;
		u64 value = 0;
		memcpy(&value, b + i * bytes, bytes);
		return ts_check_refuse(load, id, i, "", 0, "%" PRIu64 ", which stage %s makes of the same %s,", value, maker,
		                       from);
	}
	return TS_OK;
}

ts_status ts_check_again(const ts_load *load, const char *maker, const char *from)
{
	const ts_stage *stage = ts_stage_find(maker);
	ts_run again = load->run;
	again.hook = NULL;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		again.frame.buffer[*id] = (ts_buffer){.made = false};
	}
	ts_status status = ts_run_stage(&again, stage);
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (status == TS_OK && load->item[*id] != NULL) status = compare(load, &again.frame, *id, maker, from);
		ts_frame_drop(&again.frame, *id);
	}
	return status;
}
