/* Points side by side: see point_batch.h. */
#include "backends/c/points/point_batch.h"
#include <stddef.h>
#include "backends/wide.h"

typedef struct {
	ts_lanes3 w, normal;
} found;

static inline ts_v2 lattice_of(const ts_point_batch *from, ts_v3 p, u32 i)
{
	return ts_k_lattice(ts_lane3(&from->origin, i), ts_lane3(&from->u, i), ts_lane3(&from->v, i), from->scale[i], p);
}

/* ts_k_lattice_weights, and the triangle's normal. */
TS_WIDE(void, weigh, (found *restrict to, const ts_point_batch *restrict from), (to, from))
{
	u32 n = ts_whole_lanes(from->n);
	for (u32 i = 0; i < n; i++) {
		ts_v3 a = ts_lane3(&from->corner[0], i), b = ts_lane3(&from->corner[1], i), c = ts_lane3(&from->corner[2], i);
		ts_v2 p = lattice_of(from, a, i), q = lattice_of(from, b, i), r = lattice_of(from, c, i);
		ts_set_lane3(&to->w, i, ts_k_weights_around(p, q, r, from->x[i], from->y[i]));
		ts_set_lane3(&to->normal, i, ts_cross(ts_sub(b, a), ts_sub(c, a)));
	}
}

void ts_points_flush(ts_point_batch *batch, ts_surface_bins *bins)
{
	found f;
	ts_repeat_last(batch->triangle, offsetof(ts_point_batch, place) - offsetof(ts_point_batch, triangle), batch->n);
	weigh(&f, batch);
	for (u32 i = 0; i < batch->n; i++) {
		ts_surface_ask ask = {.triangle = batch->triangle[i],
		                      .w = ts_lane3(&f.w, i),
		                      .normal = ts_lane3(&f.normal, i),
		                      .p = ts_lane3(&batch->centre, i),
		                      .viewer = ts_lane3(&batch->viewer, i),
		                      .footprint = batch->length[i],
		                      .place = batch->place[i]};
		ts_surface_bins_add(bins, &ask);
	}
	batch->n = 0;
}

void ts_points_add(ts_point_batch *batch, ts_surface_bins *bins, const ts_arrays *scene, const ts_point_ask *ask)
{
	u32 i = batch->n++;
	batch->triangle[i] = ask->triangle;
	batch->x[i] = ask->x;
	batch->y[i] = ask->y;
	ts_set_corners(batch->corner, i, scene, ask->triangle);
	ts_set_lane3(&batch->origin, i, ts_load3(ask->frame->c));
	ts_set_lane3(&batch->u, i, ts_load3(ask->frame->u));
	ts_set_lane3(&batch->v, i, ts_load3(ask->frame->v));
	batch->scale[i] = ask->frame->s;
	ts_set_lane3(&batch->centre, i, ask->centre);
	ts_set_lane3(&batch->viewer, i, ask->viewer);
	batch->length[i] = ask->length;
	batch->place[i] = ask->place;
	if (batch->n == TS_ABREAST) ts_points_flush(batch, bins);
}

#include "backends/selftest.h"
