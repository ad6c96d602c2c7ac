/* What a reference does not decide: places where a port with other sub-pixel bits, or other snapping, may legally answer
 * otherwise. An element is decided if every edge that matters is more than one sub-pixel (1/256 pixel) from it and every
 * other depth farther behind than such a step, and rounding, change the two depths; if its random number is more than
 * 2^-20 from the threshold; for splats, if no other point offered the same distance; for shadows, if no comparison with a
 * depth map turns within such a step; for segments of depth and the boxes of pixels, if no comparison of depths turns
 * by rounding; for maps of many views and the light of pixels, if no test of a pair, of a texel's edge or of a shadow
 * does; and for surfels, if no surfel, fragment or outline comes or goes by rounding. Undecided can be elements of
 * eye.depth_triangle, face.depth_triangle, cull.keep, splat.depth_index, resolve.lit but of PCSS, scatter.depth of
 * triangles, segment.label, hull.box, map.depth_node, vpl_gather.irradiance, surfel_depth.surfel, blend.sum, blend.heaviest
 * and image.radiance of surfels; of other buffers every element is decided. The reference must hold the margins
 * (render --margins). */
#ifndef TS_TRACE_DECIDED_H
#define TS_TRACE_DECIDED_H
#include "../trace/read.h"
#include "../trace/reader.h"

typedef struct {
	ts_buffer_id margin; /* TS_N_BUFFERS: everything is decided */
	u32 of;              /* elements to one of them */
	ts_reader *reader;
} ts_decided;

/* Opens the margins of a buffer. TS_ERROR if the reference lacks them. Release by ts_decided_close, also on failure. */
ts_status ts_decided_open(ts_decided *decided, const ts_trace *reference, ts_buffer_id id);
void ts_decided_close(ts_decided *decided);
/* Whether the reference decides an element. */
ts_status ts_decided_is(ts_decided *decided, u64 element, bool *is);

#endif
