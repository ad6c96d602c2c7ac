/* Where splats of many points may be. */
#include "splat_extent.h"

static ts_range range_of(const f32 *x, u32 n)
{
	ts_range r = {x[0], x[0]};
	for (u32 i = 1; i < n; i++) {
		r.least = ts_min(r.least, x[i]);
		r.most = ts_max(r.most, x[i]);
	}
	return r;
}

ts_splat_bounds ts_splat_bounds_of(const f32 *const centre[3], u32 n)
{
	return (ts_splat_bounds){{range_of(centre[0], n), range_of(centre[1], n), range_of(centre[2], n)}};
}

static ts_range join(ts_range a, ts_range b) { return (ts_range){ts_min(a.least, b.least), ts_max(a.most, b.most)}; }

void ts_splat_bounds_add(ts_splat_bounds *to, const ts_splat_bounds *more)
{
	for (u32 axis = 0; axis < 3; axis++) to->of[axis] = join(to->of[axis], more->of[axis]);
}

/* Of squares around points: as seen from the eye, along an axis, with room for what is rounded. */
static ts_range towards(ts_range of, f32 wide, f32 eye, f32 sign)
{
	f32 room = wide + 0.000001f * (ts_max(ts_abs(of.least), ts_abs(of.most)) + ts_abs(eye) + wide);
	ts_range r = {(of.least - room - eye) * sign, (of.most + room - eye) * sign};
	return sign < 0 ? (ts_range){r.most, r.least} : r;
}

ts_splat_reach ts_splat_reach_of(const ts_splat_live *live, u64 at)
{
	ts_splat_reach r;
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

/* With room for what is rounded. */
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
