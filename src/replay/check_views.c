/* Off-screen views, area lights, and how much of them reaches a pixel. */
#include <inttypes.h>
#include "../kernels/base/shade.h"
#include "../methods/stages.h"
#include "check.h"

static const void *elements(const ts_load *load, ts_buffer_id id, u64 *n)
{
	*n = load->item[id] != NULL ? ts_frame_n(&load->run.frame, id) : 0;
	return load->item[id] != NULL ? ts_frame_data(&load->run.frame, id) : NULL;
}

/* Sides of a view: those of its cube, if it is the face of one. */
static ts_status check_sides(const ts_load *load, const ts_offscreen *view, u64 v, const ts_face *cubes)
{
	const ts_buffer_id id = TS_B_offscreen_view;
	u32 most = ts_check_largest(&load->run);
	if (cubes != NULL && view->width != cubes[v / 6].n) {
		return ts_check_refuse(load, id, v, "width", 0, "%" PRIu32 ", as its cube,", cubes[v / 6].n);
	}
	if (view->width > most) return ts_check_refuse(load, id, v, "width", 0, "at most %" PRIu32 ", by the parameters,", most);
	if (view->height == view->width) return TS_OK;
	return ts_check_refuse(load, id, v, "height", 0, "%" PRIu32 ", as its width,", view->width);
}

ts_status ts_check_views(const ts_load *load)
{
	const ts_buffer_id id = TS_B_offscreen_view;
	u64 n, n_cubes, offset = 0;
	const ts_offscreen *views = elements(load, id, &n);
	const ts_face *cubes = elements(load, TS_B_resize_face, &n_cubes);
	bool faces = ts_pipeline_maker(load->pipeline, TS_B_resize_face) != NULL;
	if (views != NULL && faces && n % 6 != 0) {
		return ts_fail("%s: %" PRIu64 " views; six a cube would be right", load->item[id]->path, n);
	}
	if (views != NULL && cubes != NULL && n != 6 * n_cubes) {
		return ts_fail("%s: %" PRIu64 " views; %" PRIu64 ", six a cube, would be right", load->item[id]->path, n,
		               6 * n_cubes);
	}
	for (u64 v = 0; v < n; v++) {
		if (check_sides(load, &views[v], v, cubes) != TS_OK) return TS_ERROR;
		bool empty = views[v].width == 0;
		if (!empty && !(views[v].near > 0.0f)) return ts_check_refuse(load, id, v, "near", 0, "more than 0");
		if (!empty && !(views[v].focal > 0.0f)) return ts_check_refuse(load, id, v, "focal", 0, "more than 0");
		if (views[v].orthographic > 1) return ts_check_refuse(load, id, v, "orthographic", 0, "0 or 1");
		if (views[v].offset != offset) {
			return ts_check_refuse(load, id, v, "offset", 0, "%" PRIu64 ", the texels of the views before it,", offset);
		}
		offset += (u64)views[v].width * views[v].height;
	}
	return TS_OK;
}

/* Who looks lights up by the views' names for them. */
static ts_status check_owners(const ts_load *load, const ts_stage *stage)
{
	u64 n;
	const ts_offscreen *views = elements(load, TS_B_offscreen_view, &n);
	bool asks = ts_stage_writes(stage, TS_B_resolve_lit) || ts_stage_writes(stage, TS_B_rsm_patch);
	for (u64 v = 0; v < n && asks; v++) {
		if (views[v].light == TS_NONE) return ts_check_refuse(load, TS_B_offscreen_view, v, "light", 0, "a light");
	}
	return TS_OK;
}

/* Views are made in the order of their lights, and all of them: one a sample, or one with taps for all of a light's. */
static ts_status check_samples(const ts_load *load, const ts_stage *stage)
{
	const ts_buffer_id id = TS_B_lamp_shape;
	u64 n, first = 0, all = load->run.plan.units;
	const ts_lamp *lamps = elements(load, id, &n);
	bool makes = ts_stage_writes(stage, TS_B_offscreen_view);
	u32 taps = load->run.plan.lights.taps;
	for (u64 i = 0; i < n; i++) {
		u64 most = makes && taps == 0 ? all - first : TS_NONE;
		if (lamps[i].samples == 0 || lamps[i].samples > most) {
			return ts_check_refuse(load, id, i, "samples", 0, "1 to %" PRIu64, most);
		}
		if (makes && lamps[i].first != first) {
			return ts_check_refuse(load, id, i, "first", 0, "%" PRIu64 ", the views before it,", first);
		}
		first += taps != 0 ? 1 : lamps[i].samples;
	}
	if (n == 0 || !makes || first == all) return TS_OK;
	return ts_fail("%s: lights with %" PRIu64 " views; %" PRIu64 " would be right", load->item[id]->path, first, all);
}

/* Deferred shading asks each light's view, or its cube, in order. */
static ts_status check_cubes(const ts_load *load, const ts_stage *stage)
{
	u64 n, n_lights, wanted = 0;
	const ts_light *lights = elements(load, TS_B_lamp_light, &n_lights);
	const ts_offscreen *views = elements(load, TS_B_offscreen_view, &n);
	bool asks = ts_stage_writes(stage, TS_B_resolve_lit) || ts_stage_writes(stage, TS_B_resolve_margin);
	if (lights == NULL || views == NULL || !asks) return TS_OK;
	for (u64 i = 0; i < n_lights; i++) wanted += ts_light_views(&lights[i]);
	if (n == wanted) return TS_OK;
	return ts_fail("%s: %" PRIu64 " views; %" PRIu64 ", one a light and six a point light, would be right",
	               load->item[TS_B_offscreen_view]->path, n, wanted);
}

static ts_status check_lights(const ts_load *load)
{
	const ts_buffer_id id = TS_B_lamp_light;
	u64 n;
	const ts_light *lights = elements(load, id, &n);
	if (load->item[id] != NULL && n == 0) return ts_fail("%s: no light; at least one would be right", load->item[id]->path);
	for (u64 i = 0; i < n; i++) {
		if (lights[i].kind > TS_LIGHT_KIND_SPOT) return ts_check_refuse(load, id, i, "kind", 0, "0, 1 or 2");
	}
	return TS_OK;
}

static ts_status check_lit(const ts_load *load)
{
	const ts_buffer_id id = TS_B_resolve_lit;
	u64 n, n_lamps;
	const u32 *lit = elements(load, id, &n);
	const ts_lamp *lamps = elements(load, TS_B_lamp_shape, &n_lamps);
	for (u64 i = 0; i < n && lamps != NULL; i++) {
		u32 most = lamps[i % n_lamps].samples;
		if (lit[i] > most) return ts_check_refuse(load, id, i, "", 0, "at most %" PRIu32 ", the light's samples,", most);
	}
	return TS_OK;
}

ts_status ts_check_lamps(const ts_load *load, const ts_stage *stage)
{
	if (check_lights(load) != TS_OK || check_samples(load, stage) != TS_OK) return TS_ERROR;
	if (check_owners(load, stage) != TS_OK || check_cubes(load, stage) != TS_OK) return TS_ERROR;
	return check_lit(load);
}
