/* Whether two points see each other. */
#include "truth/query.h"

#define SKIP 0.000244140625f /* 2^-12 of the greatest coordinate */

f32 ts_truth_skip(ts_v3 p) { return ts_max(ts_max(ts_abs(p.x), ts_abs(p.y)), ts_abs(p.z)) * SKIP; }

static ts_truth_query ray_of(const ts_truth_pair *pair)
{
	return (ts_truth_query){.origin = pair->from,
	                        .direction = ts_normalize(ts_sub(pair->to, pair->from)),
	                        .near = ts_truth_skip(pair->from),
	                        .masked = TS_NONE,
	                        .from = pair->from};
}

static bool is_free(const ts_truth_pair *pair, const ts_truth_hit *hit)
{
	return hit->triangle == TS_NONE || hit->t >= ts_length(ts_sub(pair->to, pair->from)) - pair->reach;
}

bool ts_truth_sees(const ts_truth *truth, ts_v3 from, ts_v3 to, f32 reach)
{
	const ts_truth_pair pair = {from, to, reach};
	ts_truth_query ray = ray_of(&pair);
	ts_truth_hit hit = ts_truth_cast(truth, &ray);
	return is_free(&pair, &hit);
}

void ts_truth_sees_all(bool *sees, const ts_truth *truth, const ts_truth_pair *pairs, u32 n)
{
	ts_truth_query rays[TS_TRUTH_PAIRS] = {{.near = 0}};
	ts_truth_hit hits[TS_TRUTH_PAIRS];
	for (u32 i = 0; i < n; i++) rays[i] = ray_of(&pairs[i]);
	ts_truth_cast_all(hits, truth, rays, n);
	for (u32 i = 0; i < n; i++) sees[i] = is_free(&pairs[i], &hits[i]);
}
