/* Bounds of a cube's path lengths to a triangle, so that most need not be measured.
 *
 * The points t that ts_k_closest_on_triangle returns are on the triangle, however it rounds: see closest_lanes.h. So t
 * is within `reach` of the middle m. Light passes through a point x of the ball with centre c and radius R, straight or
 * not: the path length is f(x) = |eye - x| + |x - t| >= |eye - x| + |x - m| - reach. Without the reach that is convex,
 * with a slope of -(u + v) at c, where u and v are the unit vectors from c to the eye and to m. So
 * f(x) >= |eye - c| + |c - m| - reach - R |u + v|.
 *
 * The kernel rounds some fifty times in a row, each time by 2^-24 of at most the sum of all coordinates. The slack is
 * 2^-15 of that sum. Beyond 2^26, where products may overflow, it is infinite, and nothing is left out. */
#include "backends/c/points/density_bound.h"
#include <math.h>
#include "backends/wide.h"

/* Margins for rounding: the slack, 2^-19 of the square of |u + v|, 2^-13 of a need. */
#define SLACK 0.000030517578125f
#define TINY 0.0000000000009094947f
#define BEYOND 67108864.0f
#define COSINE 0.0000019073486328125f
#define NEED 0.9998779296875f

static inline f32 extent_of(ts_v3 p) { return ts_abs(p.x) + ts_abs(p.y) + ts_abs(p.z); }

TS_WIDE(void, enclose, (ts_density_part *restrict p), (p))
{
	for (u32 i = 0; i < p->n; i++) {
		ts_v3 a = ts_part_corner(p, 0, i), b = ts_part_corner(p, 1, i), c = ts_part_corner(p, 2, i);
		ts_v3 m = ts_scale(ts_add(ts_add(a, b), c), 0.333333343f);
		f32 reach = ts_max(ts_length(ts_sub(a, m)), ts_length(ts_sub(b, m)));
		p->middle[0][i] = m.x;
		p->middle[1][i] = m.y;
		p->middle[2][i] = m.z;
		p->reach[i] = ts_max(reach, ts_length(ts_sub(c, m)));
	}
}

void ts_density_begin(ts_density_part *p)
{
	enclose(p);
	p->extent = 0.0f;
	for (u32 i = 0; i < p->n; i++) {
		ts_v3 a = ts_part_corner(p, 0, i), b = ts_part_corner(p, 1, i), c = ts_part_corner(p, 2, i);
		p->extent = ts_max(p->extent, extent_of(a) + extent_of(b) + extent_of(c));
		p->shortest[i] = INFINITY;
		p->densest[i] = 0.0f;
		p->any[i] = 0;
	}
}

TS_WIDE(void, find_lanes, (u32 *restrict may, const ts_density_part *restrict p, ts_density_cube r, f32 slack),
        (may, p, r, slack))
{
	ts_v3 to_eye = ts_sub(r.eye, r.centre);
	f32 eye = ts_length(to_eye);
	for (u32 i = 0; i < p->n; i++) {
		ts_v3 out = ts_sub(ts_v3_make(p->middle[0][i], p->middle[1][i], p->middle[2][i]), r.centre);
		f32 distance = ts_length(out), cosine = ts_dot(to_eye, out) / (eye * distance);
		f32 slope = ts_sqrt(ts_max(2.0f + 2.0f * cosine, 0.0f) + COSINE);
		f32 nearest = distance - p->reach[i] - slack;
		u32 is = eye - r.radius * slope + nearest > p->shortest[i] ? 0u : 1u;
		may[i] = r.half_size > NEED * (p->densest[i] * ts_max(nearest, r.least)) ? 1u : is;
	}
}

u32 ts_density_may_count(u32 list[TS_PART], const ts_density_part *p, const ts_density_cube *of)
{
	u32 may[TS_PART], n = 0;
	f32 extent = p->extent + extent_of(of->eye) + extent_of(of->centre) + of->radius;
	find_lanes(may, p, *of, extent < BEYOND ? SLACK * extent + TINY : INFINITY);
	for (u32 i = 0; i < p->n; i++) {
		list[n] = i;
		n += may[i];
	}
	return n;
}

#include "backends/selftest.h"
