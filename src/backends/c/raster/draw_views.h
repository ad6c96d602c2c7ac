/* Draws the triangles of the scene into several views. One thread draws a view; if there are more threads, one draws
 * each band of its rows. */
#ifndef TS_BACKENDS_C_RASTER_DRAW_VIEWS_H
#define TS_BACKENDS_C_RASTER_DRAW_VIEWS_H
#include "kernels/raster/draw.h"

/* A view does not show triangles of `object`; TS_NONE: it shows all. */
typedef struct {
	ts_camera_k view;
	ts_target target; /* its first texel */
	u32 object;
} ts_draw_view;

ts_draw_view ts_draw_view_offscreen(const ts_offscreen *offscreen, ts_target target);

/* False: no memory. */
bool ts_draw_views(const ts_arrays *scene, const ts_draw_view *views, u32 n, u32 threads);

#endif
