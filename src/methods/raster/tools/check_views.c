/* eye.view has the size of the picture; cube_size.face has no face larger than the parameters allow, and offsets that
 * are the sums of 6 n^2: texels are addressed by both. offscreen.view: the same, square; six per cube where there are
 * cubes; for stage deferred.lit one per light and six per point light; lights for stage shadow_test. lamp.shape:
 * samples, for stage lamp.view one per view, in order, for views are written at these places. lamp.light: at least one,
 * and its kind. shadow_test.lit: at most the samples. */
#include <inttypes.h>
#include "methods/raster/tools/tools.h"
#include "methods/stages.h"

static ts_status check_eye(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n;
	const ts_params *params = &load->run.params;
	const ts_view *view = ts_check_elements(load, id, &n);
	u32 width = TS_PARAM(params, width), height = TS_PARAM(params, height);
	if (view->width != width) return ts_check_refuse(load, id, 0, "width", 0, "%" PRIu32 ", as the parameter,", width);
	if (view->height == height) return TS_OK;
	return ts_check_refuse(load, id, 0, "height", 0, "%" PRIu32 ", as the parameter,", height);
}

/* The largest side of a cube face or depth map that the parameters allow. */
static u32 largest_side(const ts_run *run)
{
	u32 fixed = run->plan.offscreen.side != 0 ? run->plan.offscreen.side : TS_PARAM(&run->params, cube_px);
	return fixed != 0 ? fixed : ts_largest_face(&run->params);
}

static ts_status check_faces(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n, offset = 0;
	const ts_face *cubes = ts_check_elements(load, id, &n);
	u32 most = largest_side(&load->run);
	for (u64 i = 0; i < n; i++) {
		if (cubes[i].n > most) {
			return ts_check_refuse(load, id, i, "n", 0, "at most %" PRIu32 ", by the parameters,", most);
		}
		if (cubes[i].offset != offset) {
			return ts_check_refuse(load, id, i, "offset", 0, "%" PRIu64 ", the texels of the cubes before it,", offset);
		}
		offset += (u64)6 * cubes[i].n * cubes[i].n;
	}
	return TS_OK;
}

/* Sides of a view: those of its cube, if it is the face of one. */
static ts_status check_sides(const ts_load *load, const ts_offscreen *view, u64 v, const ts_face *cubes)
{
	const ts_buffer_id id = TS_B_offscreen_view;
	u32 most = largest_side(&load->run);
	if (cubes != NULL && view->width != cubes[v / 6].n) {
		return ts_check_refuse(load, id, v, "width", 0, "%" PRIu32 ", as its cube,", cubes[v / 6].n);
	}
	if (view->width > most) {
		return ts_check_refuse(load, id, v, "width", 0, "at most %" PRIu32 ", by the parameters,", most);
	}
	if (view->height == view->width) return TS_OK;
	return ts_check_refuse(load, id, v, "height", 0, "%" PRIu32 ", as its width,", view->width);
}

static ts_status check_views(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n, n_cubes, offset = 0;
	const ts_offscreen *views = ts_check_elements(load, id, &n);
	const ts_face *cubes = ts_check_elements(load, TS_B_cube_size_face, &n_cubes);
	bool faces = ts_pipeline_maker(load->pipeline, TS_B_cube_size_face) != NULL;
	if (faces && n % 6 != 0) {
		return ts_refuse("%s: %" PRIu64 " views; six a cube would be right", load->item[id]->path, n);
	}
	if (cubes != NULL && n != 6 * n_cubes) {
		return ts_refuse("%s: %" PRIu64 " views; %" PRIu64 ", six a cube, would be right", load->item[id]->path, n,
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

/* Stages that index lights by their views need a light for each. */
static ts_status check_owners(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	u64 n;
	const ts_offscreen *views = ts_check_elements(load, id, &n);
	bool asks = ts_stage_writes(stage, TS_B_shadow_test_lit) || ts_stage_writes(stage, TS_B_rsm_patch);
	for (u64 v = 0; v < n && asks; v++) {
		if (views[v].light == TS_NONE) return ts_check_refuse(load, id, v, "light", 0, "a light");
	}
	return TS_OK;
}

/* Views are in the order of their lights, and complete: one per sample, or one with taps for all samples of a light. */
static ts_status check_samples(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	u64 n, first = 0, all = load->run.plan.units;
	const ts_lamp *lamps = ts_check_elements(load, id, &n);
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
	return ts_refuse("%s: lights with %" PRIu64 " views; %" PRIu64 " would be right", load->item[id]->path, first, all);
}

/* Deferred shading reads each light's view, or its cube, in order. */
static ts_status check_cubes(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	u64 n = ts_frame_n(&load->run.frame, id), n_lights, wanted = 0;
	const ts_light *lights = ts_check_elements(load, TS_B_lamp_light, &n_lights);
	bool asks = ts_stage_writes(stage, TS_B_shadow_test_lit) || ts_stage_writes(stage, TS_B_shadow_test_margin);
	if (lights == NULL || !asks) return TS_OK;
	for (u64 i = 0; i < n_lights; i++) wanted += ts_light_views(&lights[i]);
	if (n == wanted) return TS_OK;
	return ts_refuse("%s: %" PRIu64 " views; %" PRIu64 ", one a light and six a point light, would be right",
	                 load->item[id]->path, n, wanted);
}

static ts_status check_lights(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	if (ts_frame_n(&load->run.frame, id) > 0) return ts_check_kinds(load, stage, id);
	return ts_refuse("%s: no light; at least one would be right", load->item[id]->path);
}

static ts_status check_lit(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n, n_lamps;
	const u32 *lit = ts_check_elements(load, id, &n);
	const ts_lamp *lamps = ts_check_elements(load, TS_B_lamp_shape, &n_lamps);
	for (u64 i = 0; i < n && lamps != NULL; i++) {
		u32 most = lamps[i % n_lamps].samples;
		if (lit[i] <= most) continue;
		return ts_check_refuse(load, id, i, "", 0, "at most %" PRIu32 ", the light's samples,", most);
	}
	return TS_OK;
}

/* Cubes are checked before the views of their faces. */
const ts_check_rule ts_raster_checks[] = {
	{TS_B_cube_size_face, TS_CHECK_SIZES, check_faces},
	{TS_B_offscreen_view, TS_CHECK_SIZES, check_views},
	{TS_B_eye_view, TS_CHECK_VALUES, check_eye},
	{TS_B_lamp_light, TS_CHECK_VALUES, check_lights},
	{TS_B_lamp_shape, TS_CHECK_VALUES, check_samples},
	{TS_B_offscreen_view, TS_CHECK_VALUES, check_owners},
	{TS_B_offscreen_view, TS_CHECK_VALUES, check_cubes},
	{TS_B_shadow_test_lit, TS_CHECK_VALUES, check_lit},
	{.check = NULL},
};
