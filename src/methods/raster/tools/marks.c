/* Which pixels of a picture are lit: counts of those that all samples of all lights reach, some, or none. */
#include "methods/raster/tools/tools.h"
#include "study/picture.h"

/* Over the samples of pixels. */
static ts_status mark_lit(ts_picture *picture, const ts_run *run)
{
	if (!run->frame.buffer[TS_B_shadow_test_lit].made) return TS_OK;
	u64 n_pixels = (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height);
	const ts_lamp *lamps = ts_frame_data(&run->frame, TS_B_lamp_shape);
	const u32 *lit = ts_frame_data(&run->frame, TS_B_shadow_test_lit);
	u64 n, n_lamps = ts_frame_n(&run->frame, TS_B_lamp_shape), all = 0;
	const u64 *seen = ts_pipeline_seen(run, &n);
	for (u64 k = 0; k < n_lamps; k++) all += lamps[k].samples;
	picture->n_lamps = n_lamps;
	picture->n_samples = all;
	picture->lit = (ts_lit){0};
	for (u64 i = 0; i < n_pixels; i++) {
		u64 reach = 0, asked = 0;
		for (u64 at = i; at < n; at += n_pixels) {
			asked += seen[at] != TS_EMPTY ? all : 0;
			for (u64 k = 0; k < n_lamps; k++) reach += lit[at * n_lamps + k];
		}
		if (asked == 0) continue;
		picture->lit.seen++;
		picture->lit.full += reach == asked;
		picture->lit.part += reach > 0 && reach < asked;
		picture->lit.none += reach == 0;
	}
	return TS_OK;
}

const ts_picture_mark ts_raster_marks[] = {mark_lit, ts_near_light_mark, NULL};
