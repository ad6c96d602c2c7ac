/* Light gathered at the pixels of the G-buffer. */
#include "methods/raster/tools/truth_gather.h"
#include "kernels/raster/gbuffer.h"
#include "methods/raster/raster.h"

ts_status ts_truth_indirect_begin(ts_run *run, const char *effect)
{
	static const ts_buffer_id needs[] = {TS_B_rsm_patch, TS_B_gbuffer_pixel, TS_N_BUFFERS};
	return ts_truth_begin(run, effect, needs);
}

typedef struct {
	const ts_truth_gathered *of;
	const ts_gpixel *pixels;
	f32 *light_at;
} gatherer;

static u32 pixel_of(const void *user, u64 i)
{
	const gatherer *g = user;
	return g->pixels[i].depth != TS_SKY ? (u32)i : TS_NONE;
}

static void gather(const void *user, u64 i, const ts_share *share)
{
	const gatherer *g = user;
	const ts_gpixel *pixel = &g->pixels[i];
	ts_v3 light = g->of->light(g->of->user, share, ts_load3(pixel->position), ts_load3(pixel->normal));
	ts_store3(g->light_at + i * 3, light);
}

f32 ts_share_weight(const ts_share *share) { return (f32)share->items / (f32)share->asked; }

ts_status ts_truth_gather(ts_run *run, ts_buffer_id to, const ts_truth_gathered *of, ts_sampling *sampling)
{
	u64 width = TS_PARAM(&run->params, width), n = ts_eye_size(run);
	gatherer g = {of, ts_frame_data(&run->frame, TS_B_gbuffer_pixel),
	              ts_frame_make3(&run->frame, to, n / width, width, 3)};
	if (g.light_at == NULL) return TS_ERROR;
	memset(g.light_at, 0, n * 3 * sizeof *g.light_at);
	const ts_truth_asked asked = {.label = of->label,
	                              .n = n,
	                              .items = of->items,
	                              .each = of->each,
	                              .pixel = pixel_of,
	                              .ask = gather,
	                              .user = &g,
	                              .threads = run->c.threads};
	ts_truth_ask(&asked, sampling);
	return TS_OK;
}
