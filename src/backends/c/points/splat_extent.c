/* Where splats of many points may be. */
#include "backends/c/points/splat_extent.h"
#include "backends/wide.h"

enum { FEW = 8 };

/* Squares around points, along an axis from the eye, with a margin for rounding. */
static ts_range towards(ts_range of, f32 wide, f32 eye, f32 sign)
{
	f32 room = wide + 0.000001f * (ts_max(ts_abs(of.least), ts_abs(of.most)) + ts_abs(eye) + wide);
	ts_range r = {(of.least - room - eye) * sign, (of.most + room - eye) * sign};
	return sign < 0 ? (ts_range){r.most, r.least} : r;
}

ts_splat_reach ts_splat_reach_of(const ts_splat_live *live, u64 at)
{
	ts_splat_reach r = {.slack = live->slack[at]};
	for (u32 axis = 0; axis < 3; axis++)
		r.along[axis] = ts_abs(live->side[axis][at]) + ts_abs(live->side[3 + axis][at]);
	return r;
}

ts_splat_extent ts_splat_extent_of(const ts_splat_face *f, const ts_splat_bounds *points, const ts_splat_reach *reach)
{
	ts_splat_extent e;
	for (u32 r = 0; r < 3; r++) {
		ts_row row = f->row[r];
		e.of[r] = towards(points->of[row.axis], reach->along[row.axis], f->eye[row.axis], row.sign);
	}
	return e;
}

/* With a margin for rounding. */
bool ts_splat_is_beside(const ts_splat_face *f, const ts_splat_extent *e)
{
	f32 ahead = ts_max(e->of[2].most, f->view.near) * 1.001f;
	for (u32 r = 0; r < 2; r++) {
		f32 rounded = 0.0001f * ts_max(ts_abs(e->of[r].least), ts_abs(e->of[r].most));
		if (e->of[r].least - rounded > ahead || e->of[r].most + rounded < -ahead) return true;
	}
	return false;
}

static i32 texel_near(const ts_splat_face *f, f32 x)
{
	return ts_k_floor_within(ts_clamp(x, 0.0f, (f32)(f->view.width - 1)), (f32)f->view.width);
}

/* Texels, x or y, and one more on each side. */
static void span_of(const ts_splat_face *f, ts_range across, ts_range ahead, f32 sign, i32 span[2])
{
	f32 least = across.least / (across.least < 0 ? ahead.least : ahead.most);
	f32 most = across.most / (across.most < 0 ? ahead.most : ahead.least);
	f32 middle = (f32)f->view.width * 0.5f;
	span[0] = texel_near(f, middle + f->view.focal * (sign < 0 ? -most : least) - 1.0f);
	span[1] = texel_near(f, middle + f->view.focal * (sign < 0 ? -least : most) + 1.0f);
}

ts_box ts_splat_extent_box(const ts_splat_face *f, const ts_splat_extent *e)
{
	i32 x[2], y[2];
	if (!(e->of[2].least > f->view.near)) return ts_k_view_box(&f->view);
	span_of(f, e->of[0], e->of[2], 1, x);
	span_of(f, e->of[1], e->of[2], -1, y);
	return (ts_box){x[0], y[0], x[1], y[1]};
}

/* Differences, products, sums and roots are rounded monotonically. */
f32 ts_splat_nearest(ts_v3 eye, const ts_splat_bounds *points)
{
	f32 d[3];
	for (u32 axis = 0; axis < 3; axis++) {
		ts_range of = points->of[axis];
		f32 from = ts_k_along(eye, axis);
		d[axis] = ts_max(ts_max(of.least - from, from - of.most), 0.0f);
	}
	return ts_put(ts_length(ts_v3_make(d[0], d[1], d[2])));
}

/* Bit 63: a key is `least` or more; both are below 2^63, except TS_EMPTY. */
TS_WIDE(u64, any_beyond, (const u64 *key, u32 n, u64 least), (key, n, least))
{
	u64 any = 0;
	for (u32 i = 0; i < n; i++) any |= (least - 1 - key[i]) | key[i];
	return any;
}

static bool is_beyond(const u64 *key, u32 n, u64 least)
{
	if (n >= FEW) return any_beyond(key, n, least) >> 63 != 0;
	for (u32 i = 0; i < n; i++) {
		if (key[i] >= least) return true;
	}
	return false;
}

bool ts_splat_is_hidden(const ts_splat_face *f, ts_box box, const ts_splat_bounds *points)
{
	u64 least = (u64)ts_f2u(ts_splat_nearest(f->view.eye, points)) << 32;
	if (least == 0) return false;
	for (i32 y = box.y0; y <= box.y1; y++) {
		const u64 *row = &f->texels[y * f->view.width];
		if (is_beyond(row + box.x0, (u32)(box.x1 - box.x0 + 1), least)) return false;
	}
	return true;
}

#include "backends/selftest.h"
