/* Code that truths of indirect light share (METHODS 17): light is gathered at every pixel of the G-buffer. */
#ifndef TS_METHODS_RASTER_TOOLS_TRUTH_GATHER_H
#define TS_METHODS_RASTER_TOOLS_TRUTH_GATHER_H
#include "truth/sampling.h"
#include "truth/truth.h"

/* Runs, in a run that has just begun, the stages before the light of a method of indirect light: pose, lights, their
 * views, eye and G-buffer, which are the same for all methods. */
ts_status ts_truth_indirect_begin(ts_run *run, const char *effect);

/* The light from a share of the items that arrives at a pixel's surface, at p with the normal n, or that the surface
 * reflects. */
typedef ts_v3 ts_truth_light(const void *user, const ts_share *share, ts_v3 p, ts_v3 n);

/* Light gathered at a pixel from `items` items, by `each` rays per item. */
typedef struct {
	const char *label;
	ts_truth_light *light;
	const void *user;
	u64 items, each;
} ts_truth_gathered;

/* The weight of a sampled item: the number of all items over that of the sampled. */
f32 ts_share_weight(const ts_share *share);
/* Reads gbuffer.pixel; makes `to`, indirect.irradiance or indirect.specular, in run->frame, from which stage
 * `image.indirect` makes the picture. Fails without memory. */
ts_status ts_truth_gather(ts_run *run, ts_buffer_id to, const ts_truth_gathered *of, ts_sampling *sampling);

#endif
