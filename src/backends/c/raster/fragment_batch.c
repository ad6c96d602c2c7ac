/* Fragments side by side. Edges are whole numbers below 2^48, which doubles hold exactly: rounded to f32 they equal the
 * kernel's integers. */
#include "backends/c/raster/fragment_batch.h"
#include <stddef.h>
#include "backends/wide.h"

typedef struct {
	ts_lanes3 at[3];
	u32 found[TS_ABREAST]; /* 0: a plane may clip, or the pixel is on an edge or outside */
} corners;

/* A snapped corner, from the pixel's middle. */
typedef struct {
	double x, y;
	f32 z;
	u32 whole; /* 0: a plane of ts_k_clip_to_range may be near */
} snapped;

static inline snapped snap(const ts_camera_k *view, ts_v3 p, i32 x, i32 y)
{
	ts_corner v = ts_k_to_view(view, p);
	f32 px = (f32)view->width * 0.5f + (view->focal * v.x) / v.z;
	f32 py = (f32)view->height * 0.5f - (view->focal * v.y) / v.z;
	u32 whole = v.z >= view->near ? 1u : 0u;
	whole = ts_abs(px) < 8192.0f ? whole : 0u;
	whole = ts_abs(py) < 8192.0f ? whole : 0u;
	i32 sx = (i32)ts_rint(whole != 0u ? px * 256.0f : 0.0f) + view->shift_x - (x * TS_SUB_PIXELS + TS_SUB_CENTRE);
	i32 sy = (i32)ts_rint(whole != 0u ? py * 256.0f : 0.0f) + view->shift_y - (y * TS_SUB_PIXELS + TS_SUB_CENTRE);
	return (snapped){(double)sx, (double)sy, v.z, whole};
}

/* The edge from a to b, at the pixel's middle. */
static inline double edge(snapped a, snapped b) { return a.x * b.y - a.y * b.x; }

/* ts_k_fragment where nothing clips: each edge divided by the area is the same for either orientation; the sum takes
 * the turned corners. */
TS_WIDE(void, find_weights, (ts_fragment_batch *restrict to, corners *restrict from, ts_camera_k view, u32 n),
        (to, from, view, n))
{
	for (u32 i = 0; i < n; i++) {
		ts_v3 a = ts_lane3(&from->at[0], i), b = ts_lane3(&from->at[1], i), c = ts_lane3(&from->at[2], i);
		snapped p = snap(&view, a, to->x[i], to->y[i]), q = snap(&view, b, to->x[i], to->y[i]);
		snapped r = snap(&view, c, to->x[i], to->y[i]);
		double e0 = edge(q, r), e1 = edge(r, p), e2 = edge(p, q), twice = e0 + e1 + e2;
		f32 area = (f32)twice, w0 = ((f32)e0 / area) / p.z, w1 = ((f32)e1 / area) / q.z, w2 = ((f32)e2 / area) / r.z;
		u32 turned = area < 0.0f ? 1u : 0u, whole = p.whole & q.whole & r.whole;
		whole = e0 * twice > 0.0 ? whole : 0u;
		whole = e1 * twice > 0.0 ? whole : 0u;
		from->found[i] = e2 * twice > 0.0 ? whole : 0u;
		f32 sum = w0 + (turned != 0u ? w2 : w1);
		f32 z = ts_put(1.0f / (sum + (turned != 0u ? w1 : w2)));
		ts_v3 w = ts_scale(ts_v3_make(w0, w1, w2), z), at = ts_blend(w, a, b, c);
		ts_v3 normal = ts_cross(ts_sub(b, a), ts_sub(c, a));
		ts_set_lane3(&to->w, i, w);
		ts_set_lane3(&to->normal, i, normal);
		ts_set_lane3(&to->p, i, at);
		to->z[i] = z;
	}
}

/* ts_k_fragment_footprint */
TS_WIDE(void, find_footprints, (ts_fragment_batch *restrict to, ts_camera_k view, u32 n), (to, view, n))
{
	for (u32 i = 0; i < n; i++) {
		f32 width = (to->z[i] / view.focal) * view.side;
		to->footprint[i] = ts_k_footprint(width, ts_sub(ts_lane3(&to->p, i), view.eye), ts_lane3(&to->normal, i));
	}
}

static void find_alone(ts_fragment_batch *to, u32 i, const ts_arrays *scene, const ts_camera_k *view)
{
	ts_corners t = ts_k_corners(scene, to->triangle[i]);
	ts_fragment f = ts_k_fragment_at(view, &t, to->x[i], to->y[i]);
	ts_set_lane3(&to->w, i, f.w);
	ts_set_lane3(&to->p, i, ts_blend(f.w, t.a, t.b, t.c));
	to->z[i] = f.z;
}

void ts_fragments_find(ts_fragment_batch *batch, const ts_arrays *scene, const ts_camera_k *view)
{
	corners c;
	u32 n = ts_whole_lanes(batch->n);
	ts_repeat_last(batch->triangle, offsetof(ts_fragment_batch, place) - offsetof(ts_fragment_batch, triangle),
	               batch->n);
	for (u32 i = 0; i < n; i++) ts_set_corners(c.at, i, scene, batch->triangle[i]);
	find_weights(batch, &c, *view, n);
	for (u32 i = 0; i < batch->n; i++)
		if (c.found[i] == 0) find_alone(batch, i, scene, view);
	find_footprints(batch, *view, n);
}

void ts_fragments_ask(ts_fragment_batch *batch, ts_surface_bins *bins, const ts_camera_k *view, const u32 *lit)
{
	ts_fragments_find(batch, &bins->scene, view);
	for (u32 i = 0; i < batch->n; i++) {
		ts_surface_ask ask = {.triangle = batch->triangle[i],
		                      .w = ts_lane3(&batch->w, i),
		                      .normal = ts_lane3(&batch->normal, i),
		                      .p = ts_lane3(&batch->p, i),
		                      .viewer = view->eye,
		                      .footprint = batch->footprint[i],
		                      .lit = lit != NULL ? lit + batch->place[i] * bins->scene.n_lights : NULL,
		                      .place = batch->place[i]};
		ts_surface_bins_add(bins, &ask);
	}
	batch->n = 0;
}

#include "backends/selftest.h"
