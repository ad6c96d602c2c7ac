/* The lamps of a trace and the views of their depth maps, checked for matching references. */
#include <inttypes.h>
#include "methods/raster/tools/probe.h"

/* Views per sample. */
static u32 views_each(const ts_probe_lamps *l) { return l->lens == TS_PROBE_A_CUBE ? 6 : 1; }

bool ts_probe_lamp_has_cube(const ts_probe_lamps *l, u32 light)
{
	return l->lens == TS_PROBE_VIEW_OR_CUBE ? ts_k_has_cube(&l->lights[light]) : l->lens == TS_PROBE_A_CUBE;
}

u32 ts_probe_lamp_view(const ts_probe_lamps *l, u32 light, u32 sample)
{
	u32 first = 0;
	if (l->lens != TS_PROBE_VIEW_OR_CUBE) return (l->lamps[light].first + sample) * views_each(l);
	for (u32 i = 0; i < light; i++) first += ts_probe_lamp_has_cube(l, i) ? 6 : 1;
	return first;
}

json_t *ts_probe_lamp_view_name(const ts_probe_lamps *l, const ts_offscreen *view, u32 light)
{
	u32 v = (u32)(view - l->views);
	if (!ts_probe_lamp_has_cube(l, light)) return ts_probe_int(v);
	if (l->lens == TS_PROBE_A_CUBE) return ts_probe_face_name(v / 6, v % 6);
	return ts_probe_face_name(light, v - ts_probe_lamp_view(l, light, 0));
}

static ts_status check_views(const ts_probe *p, const ts_probe_lamps *l, u64 *n_texels)
{
	const char *path = p->trace->item[TS_B_offscreen_view].path;
	*n_texels = 0;
	for (u32 v = 0; v < l->n_views; v++) {
		const ts_offscreen *view = &l->views[v];
		u32 w = view->width, h = view->height;
		bool fits = w >= 1 && h >= 1 && w <= TS_PROBE_SIDE && h <= TS_PROBE_SIDE;
		if (!fits || view->offset != *n_texels || view->light >= l->n_lights) {
			return ts_fail("%s: element %u: %u x %u of light %u at texel %" PRIu64 "; of %u lights, at %" PRIu64
			               " would be right",
			               path, (unsigned)v, (unsigned)w, (unsigned)h, (unsigned)view->light, view->offset,
			               (unsigned)l->n_lights, *n_texels);
		}
		*n_texels += (u64)w * h;
	}
	return TS_OK;
}

/* Each lamp has its samples among the views. */
static ts_status check_lamps(const ts_probe *p, const ts_probe_lamps *l)
{
	const char *path = p->trace->item[TS_B_lamp_shape].path;
	u32 each = views_each(l);
	if (ts_probe_n(p, TS_B_lamp_shape) != l->n_lights) return ts_fail("%s: as many as lamp.light would be right", path);
	if (l->n_views % each != 0) return ts_fail("%s: six views a cube would be right", p->trace->dir);
	for (u32 i = 0; i < l->n_lights; i++) {
		u64 first = l->lamps[i].first, n = l->lens == TS_PROBE_TAPS ? 1 : l->lamps[i].samples;
		if (l->lamps[i].samples > 0 && (first + n) * each <= l->n_views) continue;
		return ts_fail("%s: element %u: %u samples from %" PRIu64 " on; there are %u views", path, (unsigned)i,
		               (unsigned)l->lamps[i].samples, first, (unsigned)l->n_views);
	}
	if (l->lens != TS_PROBE_VIEW_OR_CUBE || ts_probe_lamp_view(l, l->n_lights, 0) == l->n_views) return TS_OK;
	return ts_fail("%s: one view per light, and six where its light goes all around, would be right",
	               p->trace->item[TS_B_offscreen_view].path);
}

ts_status ts_probe_read_lamps(ts_probe *p, ts_probe_lens lens, ts_probe_lamps *l)
{
	u64 n_lights = ts_probe_n(p, TS_B_lamp_light), n_views = ts_probe_n(p, TS_B_offscreen_view), n_texels;
	*l = (ts_probe_lamps){.lens = lens, .n_lights = (u32)n_lights, .n_views = (u32)n_views};
	l->lights = ts_probe_whole(p, TS_B_lamp_light);
	l->views = l->lights != NULL ? ts_probe_whole(p, TS_B_offscreen_view) : NULL;
	l->lamps = l->views != NULL ? ts_probe_whole(p, TS_B_lamp_shape) : NULL;
	if (l->lamps == NULL) return TS_ERROR;
	if (n_views >= 1u << 20 || n_lights >= TS_NONE) return ts_fail("%s: too large", p->trace->dir);
	if (check_views(p, l, &n_texels) != TS_OK || check_lamps(p, l) != TS_OK) return TS_ERROR;
	return ts_probe_shapes(p, n_texels);
}
