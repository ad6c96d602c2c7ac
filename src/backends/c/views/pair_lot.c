/* Pairs of nodes in groups, called lots, by the kernels' own functions in loops without branches, which compilers
 * vectorize. */
#include "backends/c/views/pair_lot.h"
#include "backends/wide.h"

static inline void copy_row(f32 *to, const f32 *from) { memcpy(to, from, TS_ROW * sizeof *to); }
static inline void copy_whole(u32 *to, const u32 *from) { memcpy(to, from, TS_ROW * sizeof *to); }

static inline void fill_row(f32 *to, f32 value)
{
	for (u32 k = 0; k < TS_ROW; k++) to[k] = value;
}

static inline void fill_whole(u32 *to, u32 value)
{
	for (u32 k = 0; k < TS_ROW; k++) to[k] = value;
}

static inline void count_up(u32 *to, u32 value)
{
	for (u32 k = 0; k < TS_ROW; k++) to[k] = value + k;
}

/* Pairs nodes of the scene with one node of views. */
static inline void lay_scene(ts_pair_lot *lot, u32 at, const ts_lot_job *job, const ts_pair_row *row)
{
	const ts_lane_nodes *s = &job->scene, *v = &job->views;
	const ts_lane_cones *c = &job->cones;
	f32 *const to[3] = {lot->x + at, lot->y + at, lot->z + at};
	f32 *const axis[3] = {lot->axis_x + at, lot->axis_y + at, lot->axis_z + at};
	for (u32 axis_i = 0; axis_i < 3; axis_i++) {
		f32 from = v->at[axis_i][row->other];
		for (u32 k = 0; k < TS_ROW; k++) to[axis_i][k] = s->at[axis_i][row->first + k] - from;
		fill_row(axis[axis_i], c->axis[axis_i][row->other]);
	}
	copy_row(lot->node_radius + at, s->radius + row->first);
	copy_whole(lot->node_leaf + at, s->leaf + row->first);
	count_up(lot->node + at, row->first);
	fill_row(lot->view_radius + at, v->radius[row->other]);
	fill_whole(lot->view_leaf + at, v->leaf[row->other]);
	fill_row(lot->cosine + at, c->cosine[row->other]);
	fill_row(lot->sine + at, c->sine[row->other]);
	fill_whole(lot->views + at, c->views[row->other]);
	fill_whole(lot->view + at, row->other);
}

/* Pairs nodes of views with one node of the scene. */
static inline void lay_views(ts_pair_lot *lot, u32 at, const ts_lot_job *job, const ts_pair_row *row)
{
	const ts_lane_nodes *s = &job->scene, *v = &job->views;
	const ts_lane_cones *c = &job->cones;
	f32 *const to[3] = {lot->x + at, lot->y + at, lot->z + at};
	f32 *const axis[3] = {lot->axis_x + at, lot->axis_y + at, lot->axis_z + at};
	for (u32 axis_i = 0; axis_i < 3; axis_i++) {
		f32 place = s->at[axis_i][row->other];
		for (u32 k = 0; k < TS_ROW; k++) to[axis_i][k] = place - v->at[axis_i][row->first + k];
		copy_row(axis[axis_i], c->axis[axis_i] + row->first);
	}
	copy_row(lot->view_radius + at, v->radius + row->first);
	copy_whole(lot->view_leaf + at, v->leaf + row->first);
	copy_row(lot->cosine + at, c->cosine + row->first);
	copy_row(lot->sine + at, c->sine + row->first);
	copy_whole(lot->views + at, c->views + row->first);
	count_up(lot->view + at, row->first);
	fill_row(lot->node_radius + at, s->radius[row->other]);
	fill_whole(lot->node_leaf + at, s->leaf[row->other]);
	fill_whole(lot->node + at, row->other);
}

TS_WIDE(void, lay_rows, (ts_pair_lot * lot, const ts_lot_job *job, const ts_pair_row *row, u32 n_rows),
        (lot, job, row, n_rows))
{
	u32 at = 0;
	for (u32 i = 0; i < n_rows; i++) {
		if (row[i].of_views != 0) {
			lay_views(lot, at, job, &row[i]);
		} else {
			lay_scene(lot, at, job, &row[i]);
		}
		fill_whole(lot->step + at, row[i].step);
		fill_whole(lot->mine + at, row[i].mine);
		at += row[i].n;
	}
	lot->n = at;
	for (u32 k = 0; k < TS_LANES; k++) lot->mine[at + k] = 0;
}

void ts_pair_lot_lay(ts_pair_lot *lot, const ts_lot_job *job, const ts_pair_row *row, u32 n_rows)
{
	lay_rows(lot, job, row, n_rows);
}

/* ts_k_pair_fate, as numbers. */
TS_WIDE(void, decide, (ts_pair_lot *restrict lot, u32 n, f32 apart, ts_pair_counts *restrict counts),
        (lot, n, apart, counts))
{
	u32 culled = 0, near = 0, rendered = 0, wide = 0, several = 0, end = ts_whole_lanes(lot->n);
	for (u32 i = 0; i < end; i++) {
		ts_v3 vs = ts_v3_make(lot->x[i], lot->y[i], lot->z[i]);
		ts_v3 axis = ts_v3_make(lot->axis_x[i], lot->axis_y[i], lot->axis_z[i]);
		ts_aperture psi = {lot->cosine[i], lot->sine[i]};
		f32 node = lot->node_radius[i], view = lot->view_radius[i], d = ts_length(vs);
		f32 fs = ts_k_pair_outside_psi(vs, axis, psi), slack = d * TS_CULL_DISTANCE, nearest = d - view;
		f32 size = ts_k_paraboloid_size(ts_abs(vs.x) / d, node / nearest, n);
		u32 outside = (fs > 0.0f ? 1u : 0u) & (fs > (node + view) + slack ? 1u : 0u);
		u32 same =
			(nearest > node ? 1u : 0u) & (size >= 0.0f ? 1u : 0u) & (size < 1.0f ? 1u : 0u) & (view <= node ? 1u : 0u);
		u32 leaf = lot->node_leaf[i], view_leaf = lot->view_leaf[i], leaves = leaf & view_leaf;
		u32 mine = lot->mine[i];
		u32 seen = outside ^ 1u;
		u32 beside = seen & (same ^ 1u) & leaves & (d < apart * node ? 1u : 0u);
		u32 split = seen & (same ^ 1u) & (leaves ^ 1u);
		u32 split_view = leaf | ((view_leaf ^ 1u) & (node * 0.5f < view ? 1u : 0u));
		u32 drawn = seen & (beside ^ 1u) & (split ^ 1u) & mine;
		u32 is_wide = drawn & (same ^ 1u);
		lot->split[i] = split + (split & split_view);
		lot->rendered[i] = drawn;
		culled += outside & mine;
		near += beside & mine;
		rendered += drawn;
		wide += is_wide;
		several += is_wide & (lot->views[i] > 1u ? 1u : 0u);
	}
	counts->culled += culled;
	counts->near += near;
	counts->rendered += rendered;
	counts->wide += wide;
	counts->several += several;
}

TS_WIDE(u64, count_served, (const ts_pair_lot *restrict lot), (lot))
{
	u64 sum = 0;
	for (u32 i = 0; i < ts_whole_lanes(lot->n); i++) sum += lot->rendered[i] != 0u ? lot->views[i] : 0u;
	return sum;
}

void ts_pair_lot_decide(ts_pair_lot *lot, const ts_lot_job *job, ts_pair_counts *counts)
{
	decide(lot, job->pyramid.n, job->apart, counts);
	counts->served += count_served(lot);
}

TS_WIDE(void, find_depths, (ts_pair_lot *restrict lot), (lot))
{
	u32 end = ts_whole_lanes(lot->n);
	for (u32 i = 0; i < end; i++) {
		lot->depth[i] = ts_f2u(ts_put(ts_length(ts_v3_make(lot->x[i], lot->y[i], lot->z[i]))));
	}
}

TS_WIDE(void, find_middles, (ts_pair_lot *restrict lot, u32 n), (lot, n))
{
	u32 end = ts_whole_lanes(lot->n);
	for (u32 i = 0; i < end; i++) {
		lot->middle[i] = ts_k_paraboloid_texel(ts_v3_make(lot->x[i], lot->y[i], lot->z[i]), n);
	}
}

/* With points, a node that is wider than a texel fills its caps (ts_k_map_pair). */
TS_WIDE(void, find_wide, (ts_pair_lot *restrict lot, ts_pyramid pyramid), (lot, pyramid))
{
	u32 end = ts_whole_lanes(lot->n);
	for (u32 i = 0; i < end; i++) {
		ts_v3 vs = ts_v3_make(lot->x[i], lot->y[i], lot->z[i]);
		f32 radius = lot->node_radius[i] * pyramid.fill;
		u32 wide = (ts_k_map_width(&pyramid, vs, radius) > 1.0f ? 1u : 0u) & (radius > 0.0f ? 1u : 0u);
		lot->half[0].mask[i] = lot->half[1].mask[i] = wide != 0u ? TS_LOT_MANY : 0u;
	}
}

TS_WIDE(void, find_caps, (ts_pair_lot *restrict lot, u32 n, f32 fill, u32 back), (lot, n, fill, back))
{
	u32 end = ts_whole_lanes(lot->n);
	ts_lot_half *half = &lot->half[back];
	for (u32 i = 0; i < end; i++) {
		ts_cap cap = ts_k_cap(ts_v3_make(lot->x[i], lot->y[i], lot->z[i]), lot->node_radius[i] * fill, back != 0);
		ts_cap_box box = ts_k_cap_box(&cap, n);
		half->b[i] = cap.b;
		half->c[i] = cap.c;
		half->y[i] = cap.y;
		half->z[i] = cap.z;
		half->left[i] = box.x.from;
		half->right[i] = box.x.to - 1;
		half->top[i] = box.y.from;
		half->bottom[i] = box.y.to - 1;
	}
}

/* ts_k_paraboloid_middle, where n is a power of two and `texel` is 1 / n. */
static inline f32 middle(i32 i, f32 texel) { return (f32)(2 * i + 1) * texel - 1.0f; }

/* Finds which of 2 x 2 texels of the finest level are in the box and inside (ts_k_cap_inside). */
TS_WIDE(void, look_inside, (ts_lot_half *restrict half, u32 lanes, u32 n, u32 first), (half, lanes, n, first))
{
	u32 end = ts_whole_lanes(lanes);
	f32 texel = 1.0f / (f32)n;
	for (u32 i = 0; i < end; i++) {
		f32 b = half->b[i], c = half->c[i], y = half->y[i], z = half->z[i];
		i32 left = half->left[i], top = half->top[i], wider = half->right[i] - left, higher = half->bottom[i] - top;
		f32 y0 = ts_k_cap_along(y, b, middle(left, texel)), y1 = ts_k_cap_along(y, b, middle(left + 1, texel));
		f32 z0 = ts_k_cap_along(z, b, middle(top, texel)), z1 = ts_k_cap_along(z, b, middle(top + 1, texel));
		u32 beside = wider > 0 ? 1u : 0u, below = higher > 0 ? 1u : 0u;
		u32 mask = c + (y0 + z0) >= 0.0f ? 1u : 0u;
		mask |= (c + (y1 + z0) >= 0.0f ? 2u : 0u) & (beside << 1);
		mask |= (c + (y0 + z1) >= 0.0f ? 4u : 0u) & (below << 2);
		mask |= (c + (y1 + z1) >= 0.0f ? 8u : 0u) & ((beside & below) << 3);
		u32 many = (wider > 1 ? 1u : 0u) | (higher > 1 ? 1u : 0u),
			none = (wider < 0 ? 1u : 0u) | (higher < 0 ? 1u : 0u);
		mask = many != 0u ? TS_LOT_MANY : mask;
		half->mask[i] = none != 0u ? 0u : mask;
		half->texel[i] = first + (u32)top * n + (u32)left;
	}
}

/* The greatest term of ts_k_cap_inside along one axis, of the texels that contain `from` and `to`. */
static inline f32 most_along(f32 y, f32 b, i32 from, i32 to, u32 level, f32 texel)
{
	i32 last = (i32)(1u << level) - 1, first = from & ~last, other = to & ~last;
	f32 one = ts_k_cap_least(y, b, middle(first, texel), middle(first + last, texel));
	f32 two = ts_k_cap_least(y, b, middle(other, texel), middle(other + last, texel));
	return ts_max(one, two);
}

/* A box of 2 x 2 texels is in up to 2 x 2 texels of a coarser level. Rounded sums do not fall as a term grows. So none
 * of these is inside unless the greatest terms of both axes together are; ts_k_cap_inside only subtracts more. */
TS_WIDE(void, look_above, (ts_lot_half *restrict half, u32 lanes, u32 n, u32 level), (half, lanes, n, level))
{
	u32 end = ts_whole_lanes(lanes);
	f32 texel = 1.0f / (f32)n;
	for (u32 i = 0; i < end; i++) {
		f32 b = half->b[i];
		f32 y = most_along(half->y[i], b, half->left[i], half->right[i], level, texel);
		f32 z = most_along(half->z[i], b, half->top[i], half->bottom[i], level, texel);
		half->mask[i] = half->c[i] + (y + z) >= 0.0f ? TS_LOT_MANY : half->mask[i];
	}
}

/* ts_k_cap_fill of a half. */
static void place_half(ts_pair_lot *lot, const ts_pyramid *pyramid, u32 back)
{
	ts_lot_half *half = &lot->half[back];
	u32 n = pyramid->n;
	find_caps(lot, n, pyramid->fill, back);
	look_inside(half, lot->n, n, back * n * n);
	for (u32 level = 1; level < pyramid->levels; level++) look_above(half, lot->n, n, level);
}

void ts_pair_lot_place(ts_pair_lot *lot, const ts_lot_job *job)
{
	const ts_pyramid *pyramid = &job->pyramid;
	find_depths(lot);
	if (pyramid->point != 0) find_middles(lot, pyramid->n);
	if (pyramid->point != 0 && pyramid->fill > 0) find_wide(lot, *pyramid);
	for (u32 back = 0; pyramid->point == 0 && back < 2; back++) place_half(lot, pyramid, back);
}

#include "backends/selftest.h"
