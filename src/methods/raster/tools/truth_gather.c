/* Light gathered at the pixels of the G-buffer. */
#include "truth_gather.h"
#include "../../../kernels/raster/gbuffer.h"

enum { CHUNK = 4096 }; /* pixels between two signs of progress */

ts_status ts_truth_indirect_begin(ts_run *run, const char *effect)
{
	static const ts_buffer_id needs[] = {TS_B_rsm_patch, TS_B_gbuffer_pixel, TS_N_BUFFERS};
	return ts_truth_begin(run, effect, needs);
}

static ts_v3 light_of(const ts_gpixel *pixel, u64 i, ts_truth_light *light, const void *user)
{
	if (pixel->depth == TS_SKY) return ts_v3_make(0.0f, 0.0f, 0.0f);
	return light(user, i, ts_load3(pixel->position), ts_load3(pixel->normal));
}

ts_status ts_truth_gather(ts_run *run, ts_buffer_id to, ts_truth_light *light, const void *user, const char *label)
{
	u64 width = TS_PARAM(&run->params, width), height = TS_PARAM(&run->params, height), n = width * height;
	const ts_gpixel *pixels = ts_frame_data(&run->frame, TS_B_gbuffer_pixel);
	f32 *light_at = ts_frame_make3(&run->frame, to, height, width, 3);
	if (light_at == NULL) return TS_ERROR;
	for (u64 first = 0; first < n; first += CHUNK) {
		u64 end = first + CHUNK < n ? first + CHUNK : n;
		ts_progress(label, first, n);
#pragma omp parallel for num_threads((int)run->c.threads) schedule(dynamic, 64)
		for (u64 i = first; i < end; i++) ts_store3(light_at + i * 3, light_of(&pixels[i], i, light, user));
	}
	ts_progress(label, n, n);
	return TS_OK;
}
