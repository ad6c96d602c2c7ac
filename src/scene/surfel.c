/* Surfels from points: circles, checked ellipses, and ellipses deformed by a map. */
#include "scene/surfel.h"
#include <stdlib.h>
#include <string.h>
#include "model/core.h"

#define RIGHT 0.00390625f      /* 1/256: greatest cosine of a right angle */
#define SKEW 1.52587890625e-5f /* 2^-16: more is not rounding */
#define FACING 0.99f           /* least cosine between u x v and the normal */

/* Perpendicular to n and to the axis that n is farthest from; a unit vector. */
static ts_v3 across(ts_v3 n)
{
	f32 x = ts_abs(n.x), y = ts_abs(n.y), z = ts_abs(n.z);
	ts_v3 axis = ts_v3_make(x <= y && x <= z ? 1.0f : 0.0f, !(x <= y && x <= z) && y <= z ? 1.0f : 0.0f,
	                        !(x <= y && x <= z) && !(y <= z) ? 1.0f : 0.0f);
	return ts_normalize(ts_cross(axis, n));
}

static bool is_length(f32 x) { return x > 0.0f && x <= TS_SURFEL_LIMIT; }

const char *ts_surfel_circle(ts_surfel *surfel, const f32 normal[3], f32 radius)
{
	ts_v3 n = ts_normalize(ts_load3(normal)), u = across(n);
	if (!(ts_length(n) > 0.0f)) return "the normal has no length";
	if (!is_length(radius)) return "the radius is not above 0 and at most 16777216";
	ts_store3(surfel->u, ts_scale(u, radius));
	ts_store3(surfel->v, ts_scale(ts_cross(n, u), radius));
	return ts_length(ts_load3(surfel->u)) > 0.0f ? NULL : "the radius is too small";
}

void ts_surfel_turn(ts_surfel *surfel)
{
	ts_v3 u = ts_load3(surfel->u);
	ts_store3(surfel->u, ts_load3(surfel->v));
	ts_store3(surfel->v, u);
}

const char *ts_surfel_ellipse(ts_surfel *surfel, const f32 normal[3])
{
	ts_v3 u = ts_normalize(ts_load3(surfel->u)), v = ts_normalize(ts_load3(surfel->v));
	if (!is_length(ts_length(ts_load3(surfel->u)))) return "the half-axis u is not longer than 0, at most 16777216";
	if (!is_length(ts_length(ts_load3(surfel->v)))) return "the half-axis v is not longer than 0, at most 16777216";
	if (ts_abs(ts_dot(u, v)) > RIGHT) return "the half-axes u and v are not at a right angle";
	if (normal == NULL) return NULL;
	f32 facing = ts_dot(ts_cross(u, v), ts_normalize(ts_load3(normal)));
	if (!(ts_abs(facing) >= FACING)) return "the half-axes are not at a right angle to the normal";
	if (facing < 0.0f) ts_surfel_turn(surfel);
	return NULL;
}

bool ts_axes_straighten(ts_v3 *u, ts_v3 *v)
{
	f32 uv = ts_dot(*u, *v), difference = ts_dot(*v, *v) - ts_dot(*u, *u);
	if (ts_abs(uv) <= SKEW * ts_length(*u) * ts_length(*v)) return false;
	f32 cot = difference / (2.0f * uv);
	f32 tan = 1.0f / (ts_abs(cot) + ts_sqrt(cot * cot + 1.0f));
	if (cot < 0.0f) tan = -tan;
	f32 cos = 1.0f / ts_sqrt(tan * tan + 1.0f), sin = tan * cos;
	ts_v3 turned = ts_sub(ts_scale(*u, cos), ts_scale(*v, sin));
	*v = ts_add(ts_scale(*u, sin), ts_scale(*v, cos));
	*u = turned;
	return true;
}

void ts_surfel_straighten(ts_surfel *surfel)
{
	ts_v3 u = ts_load3(surfel->u), v = ts_load3(surfel->v);
	if (!ts_axes_straighten(&u, &v)) return;
	ts_store3(surfel->u, u);
	ts_store3(surfel->v, v);
}

enum { HALVES = 1 << 16 };

/* The key of this rank; `high` counts keys by their high halves, `low` is room for equally many counts. */
static u32 key_of_rank(const u32 *keys, u32 n, u64 rank, const u32 *high, u32 *low)
{
	u32 top = 0, bottom = 0;
	while (rank >= high[top]) rank -= high[top++];
	memset(low, 0, HALVES * sizeof *low);
	for (u32 i = 0; i < n; i++) low[keys[i] & (HALVES - 1)] += keys[i] >> 16 == top;
	while (rank >= low[bottom]) rank -= low[bottom++];
	return top << 16 | bottom;
}

static f32 squared(ts_v3 a) { return ts_flush(ts_dot(a, a)); }

/* Quantiles of squares, which sort like the numbers, and like their bits. */
ts_status ts_surfel_quantiles(f32 quantile[TS_SURFEL_QUANTILES], const ts_surfel *surfels, u32 n)
{
	u32 *key = ts_alloc(n + (u64)2 * HALVES, sizeof *key, "radii of surfels");
	if (key == NULL) return TS_ERROR;
	u32 *high = key + n, *low = high + HALVES;
	memset(high, 0, HALVES * sizeof *high);
	for (u32 i = 0; i < n; i++) {
		key[i] = ts_f2u(ts_max(squared(ts_load3(surfels[i].u)), squared(ts_load3(surfels[i].v))));
		high[key[i] >> 16]++;
	}
	for (u64 k = 0; k < TS_SURFEL_QUANTILES; k++) {
		u64 rank = (n - 1) * k / (TS_SURFEL_QUANTILES - 1);
		quantile[k] = ts_sqrt(ts_u2f(key_of_rank(key, n, rank, high, low)));
	}
	free(key);
	return TS_OK;
}
