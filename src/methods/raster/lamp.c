/* The lights with soft shadows, and the views from their samples. There are few per frame, so the host makes them. */
#include <inttypes.h>
#include "kernels/base/shade.h"
#include "methods/stages.h"
#include "scene/lamp.h"

static ts_status make_lamps(ts_run *run, u32 n, ts_light **lights, ts_lamp **lamps)
{
	ts_run_set_size(run, TS_DIM_lamps, n);
	*lights = ts_run_make(run, TS_B_lamp_light);
	*lamps = ts_run_make(run, TS_B_lamp_shape);
	return *lights != NULL && *lamps != NULL ? TS_OK : TS_ERROR;
}

static const ts_stand *stands_of(const ts_run *run)
{
	return run->scene->n_stands == TS_N_STANDS ? run->scene->stands : NULL;
}

static void set_shape(ts_lamp *lamp, const ts_run *run, const ts_light *light, u32 first, u32 samples)
{
	f32 radius = ts_lamp_radius(light, ts_run_info(run), &run->params);
	*lamp = (ts_lamp){.radius = radius, .samples = samples, .first = first};
}

/* The lights share the views evenly; the first lights get the remainder. One view with taps serves a light alone. */
static ts_status lamp(ts_run *run)
{
	ts_light *lights;
	ts_lamp *lamps;
	bool own = run->plan.lights.own;
	u32 n = own ? run->scene->n_lights : 1, views = run->plan.lights.samples, taps = run->plan.lights.taps, first = 0;
	if (n == 0) return ts_fail("lamp.source=scene: the scene has no lights; lamp.source=lamp would be right");
	if (views < n && taps == 0) {
		return ts_fail("lamp.views=%" PRIu32 ": at least %" PRIu32 ", one a light, would be right", views, n);
	}
	if (make_lamps(run, n, &lights, &lamps) != TS_OK) return TS_ERROR;
	const ts_light *from = ts_frame_data(&run->frame, TS_B_scene_light);
	for (u32 i = 0; i < n; i++) {
		u32 own_views = taps != 0 ? 1 : views / n + (i < views % n);
		if (own) {
			lights[i] = from[i];
		} else {
			ts_lamp_spot(&lights[i], ts_run_info(run), stands_of(run), &run->params);
		}
		set_shape(&lamps[i], run, &lights[i], first, taps != 0 ? taps : own_views);
		first += own_views;
	}
	return TS_OK;
}

static ts_status lamp_ball(ts_run *run)
{
	ts_light *light;
	ts_lamp *shape;
	if (make_lamps(run, 1, &light, &shape) != TS_OK) return TS_ERROR;
	ts_lamp_ball(light, ts_run_info(run), stands_of(run), &run->params);
	set_shape(shape, run, light, 0, run->plan.lights.samples);
	return TS_OK;
}

static ts_lens lens_of(const ts_run *run)
{
	return (ts_lens){
		.side = run->plan.offscreen.side, .fov = TS_PARAM(&run->params, lamp_fov), .own = run->plan.lights.own};
}

static ts_status lamp_view(ts_run *run)
{
	ts_lens lens = lens_of(run);
	u64 n_lamps = ts_frame_n(&run->frame, TS_B_lamp_light), offset = 0;
	const ts_light *lights = ts_frame_data(&run->frame, TS_B_lamp_light);
	const ts_lamp *lamps = ts_frame_data(&run->frame, TS_B_lamp_shape);
	ts_run_set_size(run, TS_DIM_views, run->plan.units);
	ts_offscreen *views = ts_run_make(run, TS_B_offscreen_view);
	if (views == NULL) return TS_ERROR;
	for (u32 i = 0; i < n_lamps; i++) {
		u32 n = run->plan.lights.taps != 0 ? 1 : lamps[i].samples;
		for (u32 k = 0; k < n; k++) {
			ts_offscreen *view = &views[lamps[i].first + k];
			ts_lamp_view(view, &lights[i], lamps[i].radius, k, n, ts_run_info(run), &lens);
			view->light = i;
			view->offset = offset;
			offset += (u64)view->width * view->height;
		}
	}
	return TS_OK;
}

static ts_status lamp_cube(ts_run *run)
{
	u32 n = run->plan.units;
	const ts_light *light = ts_frame_data(&run->frame, TS_B_lamp_light);
	const ts_lamp *shape = ts_frame_data(&run->frame, TS_B_lamp_shape);
	ts_sizes_cubes(&run->sizes, n);
	ts_face *cubes = ts_run_make(run, TS_B_cube_size_face);
	if (cubes == NULL) return TS_ERROR;
	for (u32 k = 0; k < n; k++) {
		ts_lamp_cube(&cubes[k], light, shape->radius, k, n, ts_run_info(run), run->plan.offscreen.side);
		cubes[k].offset = k != 0 ? cubes[k - 1].offset + (u64)6 * cubes[k - 1].n * cubes[k - 1].n : 0;
	}
	return TS_OK;
}

u32 ts_light_views(const ts_light *light) { return ts_k_has_cube(light) ? 6 : 1; }

/* View k of a light. */
static void set_view(ts_offscreen *view, const ts_light *light, u32 k, u32 index, const ts_info *info,
                     const ts_lens *lens)
{
	ts_face cube;
	if (ts_k_has_cube(light)) {
		ts_lamp_cube(&cube, light, 0.0f, 0, 1, info, lens->side);
		ts_offscreen_of_face(view, &cube, k, index);
	} else {
		ts_lamp_view(view, light, 0.0f, 0, 1, info, lens);
		view->light = index;
	}
}

ts_status ts_light_views_make(ts_run *run)
{
	ts_lens lens = lens_of(run);
	const ts_light *lights = ts_frame_data(&run->frame, TS_B_lamp_light);
	u64 n_lights = ts_frame_n(&run->frame, TS_B_lamp_light), n = 0, texels = (u64)lens.side * lens.side, offset = 0;
	for (u64 i = 0; i < n_lights; i++) n += ts_light_views(&lights[i]);
	ts_run_set_size(run, TS_DIM_views, n);
	ts_offscreen *view = ts_run_make(run, TS_B_offscreen_view);
	if (view == NULL) return TS_ERROR;
	for (u32 i = 0; i < n_lights; i++) {
		for (u32 k = 0; k < ts_light_views(&lights[i]); k++, view++, offset += texels) {
			set_view(view, &lights[i], k, i, ts_run_info(run), &lens);
			view->offset = offset;
		}
	}
	return TS_OK;
}

const ts_stage ts_stage_lamp = {
	.name = "lamp",
	.kind = "map",
	.paper = "iVIR 4",
	.doc = "the lights of soft shadows",
	.run = lamp,
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_scene_light, TS_B_scene_stand),
	.makes = TS_BUFFERS(TS_B_lamp_light, TS_B_lamp_shape),
};

const ts_stage ts_stage_lamp_ball = {
	.name = "lamp.ball",
	.kind = "map",
	.paper = "iVIR 6",
	.doc = "the light of omnidirectional shadows",
	.run = lamp_ball,
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_scene_stand),
	.makes = TS_BUFFERS(TS_B_lamp_light, TS_B_lamp_shape),
};

const ts_stage ts_stage_lamp_view = {
	.name = "lamp.view",
	.kind = "map",
	.paper = "iVIR 4",
	.doc = "a depth map for each sample of each light",
	.run = lamp_view,
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_lamp_light, TS_B_lamp_shape),
	.makes = TS_BUFFERS(TS_B_offscreen_view),
};

const ts_stage ts_stage_lamp_own_view = {
	.name = "lamp.own_view",
	.kind = "map",
	.paper = "NV40: Timings & Comparison",
	.doc = "a depth map for each light, six for a point light",
	.run = ts_light_views_make,
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_lamp_light),
	.makes = TS_BUFFERS(TS_B_offscreen_view),
};

const ts_stage ts_stage_lamp_cube = {
	.name = "lamp.cube",
	.kind = "map",
	.paper = "iVIR 6",
	.doc = "a cube for each sample of the light",
	.run = lamp_cube,
	.looks_at = TS_BUFFERS(TS_B_scene_info, TS_B_lamp_light, TS_B_lamp_shape),
	.makes = TS_BUFFERS(TS_B_cube_size_face),
};
