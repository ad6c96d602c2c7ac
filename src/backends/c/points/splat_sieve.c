/* A point is left out by bounds of its splat, with margins for rounding, before the splat is computed. */
#include "backends/c/points/splat_sieve.h"
#include "backends/wide.h"

enum { LANES = TS_SPLAT_LANES, POINTS = TS_SPLAT_POINTS };

/* What a splat may touch: two columns, two rows, more, or nothing. */
enum { RIGHT = 1, BELOW = 2, LARGE = 4, NOTHING = 8 };

/* What the splats of a row have in common; [3] is right, up, ahead. */
typedef struct {
	f32 eye[3], sign[3], reach[3], world_eye[3];
	f32 focal, middle, last, near;
	f32 widest, slack; /* of the inset of boxes */
	f32 margin;        /* in texels, for the rounding of projections */
	i32 width;
} sight;

typedef struct {
	u32 first[POINTS + LANES]; /* texel */
	u32 touched[POINTS + LANES], distance[POINTS + LANES];
} bounds;

/* With a margin for the rounding of corners. */
static f32 reach_of(const ts_splat_face *f, const ts_splat_reach *reach, u32 axis)
{
	f32 along = reach->along[axis];
	return along + reach->slack + 0.000002f * (ts_abs(f->eye[axis]) + 4.0f * along);
}

static sight sight_of(const ts_splat_face *f, const ts_splat_reach *reach)
{
	f32 width = (f32)f->view.width;
	sight s = {.focal = f->view.focal,
	           .middle = width * 0.5f,
	           .last = width - 1.0f,
	           .near = f->view.near,
	           .widest = f->inset,
	           .slack = reach->slack * 1.001f,
	           .margin = width * 0.000002f + 0.0001f,
	           .width = f->view.width};
	for (u32 k = 0; k < 3; k++) {
		s.eye[k] = f->eye[f->row[k].axis];
		s.sign[k] = f->row[k].sign;
		s.reach[k] = reach_of(f, reach, f->row[k].axis);
		s.world_eye[k] = f->eye[k];
	}
	return s;
}

static inline i32 texel_of(f32 x, f32 last) { return (i32)ts_min(ts_max(x, 0.0f), last); }

/* Texels across or down, and whether there is none. */
typedef struct {
	i32 least, most;
	u32 none;
} span;

static inline span span_of(f32 least, f32 most, f32 last)
{
	span s = {texel_of(least, last), texel_of(most, last), 0u};
	s.none = (most < 0.0f ? 1u : 0u) | (least >= last + 1.0f ? 1u : 0u) | (s.most < s.least ? 1u : 0u);
	return s;
}

TS_WIDE(void, find_bounds, (bounds *restrict to, u32 n, sight s, const f32 *const centre[3], const u32 axis[3]),
        (to, n, s, centre, axis))
{
	const f32 *x = centre[0], *y = centre[1], *z = centre[2];
	const f32 *right = centre[axis[0]], *up = centre[axis[1]], *ahead = centre[axis[2]];
	for (u32 i = 0; i < (n + LANES - 1) / LANES * LANES; i++) {
		f32 across = (right[i] - s.eye[0]) * s.sign[0], upwards = (up[i] - s.eye[1]) * s.sign[1];
		f32 depth = (ahead[i] - s.eye[2]) * s.sign[2];
		f32 close = s.focal / (depth - s.reach[2]), far = s.focal / (depth + s.reach[2]);
		f32 inset = ts_max(s.widest - s.slack * close, 0.0f) - s.margin;
		f32 left_end = across - s.reach[0], right_end = across + s.reach[0];
		f32 low_end = upwards - s.reach[1], high_end = upwards + s.reach[1];
		span columns = span_of(s.middle + ts_min(left_end * close, left_end * far) + inset,
		                       s.middle + ts_max(right_end * close, right_end * far) - inset, s.last);
		span rows = span_of(s.middle - ts_max(high_end * close, high_end * far) + inset,
		                    s.middle - ts_min(low_end * close, low_end * far) - inset, s.last);
		u32 behind = depth - s.reach[2] < s.near ? 1u : 0u;
		u32 wide = (u32)(columns.most - columns.least), high = (u32)(rows.most - rows.least);
		u32 large = behind | (wide > 1u ? 1u : 0u) | (high > 1u ? 1u : 0u);
		u32 none = (columns.none | rows.none) & (behind ^ 1u);
		ts_v3 to_point = ts_v3_make(x[i] - s.world_eye[0], y[i] - s.world_eye[1], z[i] - s.world_eye[2]);
		to->first[i] = (u32)(rows.least * s.width + columns.least);
		to->touched[i] = (wide & 1u) | (high & 1u) << 1 | large << 2 | none << 3;
		to->distance[i] = ts_f2u(ts_put(ts_length(to_point)));
	}
}

static inline u64 farther(u64 a, u64 b) { return a > b ? a : b; }

/* Whether a texel may take the point, or tie with it. */
static bool is_open(const ts_splat_face *f, const bounds *b, u32 i)
{
	const u64 *first = &f->texels[b->first[i]];
	u32 right = b->touched[i] & RIGHT, below = (b->touched[i] & BELOW) != 0 ? (u32)f->view.width : 0;
	u64 far = farther(farther(first[0], first[right]), farther(first[below], first[below + right]));
	return far >= (u64)b->distance[i] << 32;
}

static u32 find_near(u32 *restrict near, const bounds *b, u32 n)
{
	u32 n_near = 0;
	for (u32 i = 0; i < n; i++) {
		near[n_near] = i;
		n_near += (b->touched[i] & NOTHING) == 0;
	}
	return n_near;
}

static u32 find_open(u32 *restrict open, const u32 *restrict near, u32 n_near, const ts_splat_face *f, const bounds *b)
{
	u32 n_open = 0;
	for (u32 k = 0; k < n_near; k++) {
		open[n_open] = near[k];
		n_open += (b->touched[near[k]] & LARGE) != 0 || is_open(f, b, near[k]);
	}
	return n_open;
}

u32 ts_splat_sieve_add(ts_splat_sieve *sieve, const ts_splat_face *f, const ts_splat_live *live, u32 row,
                       const ts_splat_reach *reach)
{
	u32 begin = live->index[row], n = ts_splat_live_points(live, row, (u64)row + 1), near[POINTS + 1], open[POINTS + 1];
	const u32 axis[3] = {f->row[0].axis, f->row[1].axis, f->row[2].axis};
	const f32 *const centre[3] = {live->centre[0] + begin, live->centre[1] + begin, live->centre[2] + begin};
	bounds b;
	find_bounds(&b, n, sight_of(f, reach), centre, axis);
	u32 n_open = find_open(open, near, find_near(near, &b, n), f, &b);
	for (u32 k = 0; k < n_open; k++) {
		u32 to = sieve->n++;
		for (u32 of = 0; of < 3; of++) sieve->centre[of][to] = centre[of][open[k]];
		sieve->index[to] = begin + open[k];
	}
	return n_open;
}

#include "backends/selftest.h"
