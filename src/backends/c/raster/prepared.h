/* A triangle that is clipped and set up once for a view and many pixels; fast paths share it. */
#ifndef TS_BACKENDS_C_RASTER_PREPARED_H
#define TS_BACKENDS_C_RASTER_PREPARED_H
#include "kernels/raster/draw.h"

/* A triangle in the view: its polygon and the triangles of its fan, by their last corner. */
typedef struct {
	u32 triangle;
	ts_corners corners;
	ts_polygon polygon;
	ts_setup setup[TS_MAX_CORNERS];
} ts_prepared;

/* clips: a plane of ts_k_clip_to_range may clip the triangle. */
static inline void ts_prepare_if(ts_prepared *p, const ts_arrays *scene, const ts_camera_k *view, u32 triangle,
                                 bool clips)
{
	p->triangle = triangle;
	p->corners = ts_k_corners(scene, triangle);
	p->polygon = ts_k_polygon(view, p->corners.a, p->corners.b, p->corners.c);
	if (clips) ts_k_clip_to_range(view, &p->polygon);
	ts_snapped v[TS_MAX_CORNERS];
	for (u32 k = 0; k < p->polygon.n; k++) v[k] = ts_k_snap_corner(view, &p->polygon.corner[k]);
	for (u32 k = 2; k < p->polygon.n; k++) p->setup[k] = ts_k_setup(v[0], v[k - 1], v[k]);
}

static inline void ts_prepare(ts_prepared *p, const ts_arrays *scene, const ts_camera_k *view, u32 triangle)
{
	ts_prepare_if(p, scene, view, triangle, true);
}

/* The fragment of ts_k_fragment_at. */
static inline ts_fragment ts_prepared_fragment(const ts_prepared *p, const ts_camera_k *view, i32 x, i32 y)
{
	const ts_corner *corner = p->polygon.corner;
	for (u32 k = 2; k < p->polygon.n; k++) {
		if (p->setup[k].area == 0) continue;
		ts_edges e = ts_k_edges(&p->setup[k], x * TS_SUB_PIXELS + TS_SUB_CENTRE, y * TS_SUB_PIXELS + TS_SUB_CENTRE);
		if (!ts_k_covers(&p->setup[k], &e)) continue;
		return ts_k_view_fragment(view, &p->setup[k], &e, &corner[0], &corner[k - 1], &corner[k]);
	}
	return (ts_fragment){.z = 0, .w = {1, 0, 0}};
}

#endif
