/* Whether two points see each other. */
#include "query.h"

#define SKIP 0.000244140625f /* 2^-12 of the greatest coordinate */

f32 ts_truth_skip(ts_v3 p) { return ts_max(ts_max(ts_abs(p.x), ts_abs(p.y)), ts_abs(p.z)) * SKIP; }

bool ts_truth_sees(const ts_truth *truth, ts_v3 from, ts_v3 to, f32 reach)
{
	ts_v3 way = ts_sub(to, from);
	ts_truth_query ray = {
		.origin = from, .direction = ts_normalize(way), .near = ts_truth_skip(from), .masked = TS_NONE, .from = from};
	ts_truth_hit hit = ts_truth_cast(truth, &ray);
	return hit.triangle == TS_NONE || hit.t >= ts_length(way) - reach;
}
