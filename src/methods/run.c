/* A run: its frame, its counters, and what the stages share. */
#include <assert.h>
#include <inttypes.h>
#include "methods/stages.h"
#include "model/core.h"

void ts_run_begin(ts_run *run, const ts_scene *scene, const ts_params *params, u32 threads)
{
	memset(run, 0, sizeof *run);
	run->scene = scene;
	run->params = *params;
	ts_sizes_clear(&run->sizes);
	ts_sizes_scene(&run->sizes, scene);
	ts_c_begin(&run->c, threads);
	ts_counts counts = ts_scene_counts(scene);
	TS_PARAM_READER(NULL, NULL, ts_plan_default(&run->plan, params, &counts));
	run->n_units = run->plan.units;
	ts_frame_borrow(&run->frame, TS_B_scene_vertex, scene->vertices, scene->n_vertices);
	ts_frame_borrow(&run->frame, TS_B_scene_triangle, scene->triangles, scene->n_triangles);
	ts_frame_borrow(&run->frame, TS_B_scene_material, scene->materials, scene->n_materials);
	ts_frame_borrow(&run->frame, TS_B_scene_slot, scene->slots, scene->n_slots);
	ts_frame_borrow(&run->frame, TS_B_scene_image, scene->images, scene->n_images);
	ts_frame_borrow(&run->frame, TS_B_scene_texel, scene->texels, scene->n_texels);
	ts_frame_borrow(&run->frame, TS_B_scene_light, scene->lights, scene->n_lights);
	ts_frame_borrow(&run->frame, TS_B_scene_object, scene->objects, scene->n_objects);
	if (scene->n_surfels > 0) ts_frame_borrow(&run->frame, TS_B_scene_surfel, scene->surfels, scene->n_surfels);
	if (scene->n_stands > 0) ts_frame_borrow(&run->frame, TS_B_scene_stand, scene->stands, scene->n_stands);
	if (scene->n_path > 0) ts_frame_borrow(&run->frame, TS_B_scene_path, scene->path, scene->n_path);
	if (scene->n_motion > 0)
		ts_frame_borrow_rows(&run->frame, TS_B_scene_motion, scene->motion, scene->n_motion, scene->n_objects);
	ts_frame_borrow(&run->frame, TS_B_scene_info, &scene->info, 1);
}

void ts_run_how(ts_run *run, const ts_how *how)
{
	ts_c_begin(&run->c, how->threads);
	run->c.no_fast_paths = how->no_fast_paths;
	run->backend = how->backend;
	run->arrival = how->arrival;
}

void ts_run_end(ts_run *run) { ts_frame_clear(&run->frame); }

ts_backend *ts_run_backend_of(ts_run *run) { return run->backend != NULL ? run->backend : &run->c.backend; }

const ts_backend *ts_run_backend(const ts_run *run) { return run->backend != NULL ? run->backend : &run->c.backend; }

static void add_timing(ts_run *run, const char *stage, double seconds)
{
	for (u32 i = 0; i < run->n_timings; i++) {
		if (strcmp(run->timings[i].stage, stage) == 0) {
			run->timings[i].seconds += seconds;
			return;
		}
	}
	assert(run->n_timings < TS_MAX_TIMINGS);
	run->timings[run->n_timings++] = (ts_timing){.stage = stage, .seconds = seconds};
}

/* A failure on the device takes precedence, as it causes later ones. */
static ts_status finish(ts_run *run, ts_status status)
{
	ts_status finished = ts_run_backend_of(run)->finish(ts_run_backend_of(run));
	return finished != TS_OK ? finished : status;
}

ts_status ts_run_stage(ts_run *run, const ts_stage *stage)
{
	double start = ts_seconds();
	memset(run->made, 0, sizeof run->made);
	ts_status status;
	TS_PARAM_READER("stage", stage->name, status = stage->run(run));
	if (finish(run, status) != TS_OK) return ts_fail("stage %s: %s", stage->name, ts_error_message());
	if (ts_cancelled()) return ts_fail_as(TS_KIND_CANCELLED, "stage %s: cancelled", stage->name);
	add_timing(run, stage->name, ts_seconds() - start);
	if (run->hook != NULL) TS_PARAM_READER(NULL, NULL, status = finish(run, run->hook(run, stage, run->hook_user)));
	return status;
}

void ts_run_count(ts_run *run, const char *name, i64 value)
{
	for (u32 i = 0; i < run->n_counters; i++) {
		if (strcmp(run->counters[i].name, name) == 0) {
			run->counters[i].value += value;
			return;
		}
	}
	assert(run->n_counters < TS_MAX_COUNTERS);
	run->counters[run->n_counters++] = (ts_counter){.name = name, .value = value};
}

i64 ts_counter_of(const ts_counter *counters, u32 n, const char *name)
{
	for (u32 i = 0; i < n; i++) {
		if (strcmp(counters[i].name, name) == 0) return counters[i].value;
	}
	return 0;
}

i64 ts_run_counter(const ts_run *run, const char *name) { return ts_counter_of(run->counters, run->n_counters, name); }

const ts_info *ts_run_info(const ts_run *run) { return ts_frame_data(&run->frame, TS_B_scene_info); }

ts_arrays ts_run_arrays(const ts_run *run)
{
	const ts_frame *frame = &run->frame;
	return (ts_arrays){
		.vertices = ts_frame_handle(frame, TS_B_pose_vertex),
		.triangles = ts_frame_handle(frame, TS_B_scene_triangle),
		.materials = ts_frame_handle(frame, TS_B_scene_material),
		.slots = ts_frame_handle(frame, TS_B_scene_slot),
		.images = ts_frame_handle(frame, TS_B_scene_image),
		.texels = ts_frame_handle(frame, TS_B_scene_texel),
		.lights = ts_frame_handle(frame, TS_B_scene_light),
		.objects = ts_frame_handle(frame, TS_B_scene_object),
		.n_triangles = run->scene->n_triangles,
		.n_lights = run->scene->n_lights,
		.ambient = ts_run_info(run)->ambient,
	};
}

ts_arrays ts_run_scene(const ts_run *run)
{
	return (ts_arrays){
		.n_triangles = (u32)ts_run_size(run, TS_DIM_triangles),
		.n_lights = (u32)ts_run_size(run, TS_DIM_lights),
		.ambient = ts_run_info(run)->ambient,
	};
}

bool ts_run_made(const ts_run *run, ts_buffer_id id) { return run->frame.buffer[id].made; }

bool ts_run_has(const ts_run *run, ts_buffer_id id) { return ts_run_made(run, id) && run->frame.buffer[id].n > 0; }

u64 ts_run_n_texels(const ts_run *run, u32 first, u32 n)
{
	u64 texels = 0;
	if (ts_run_has_cubes(run)) {
		const ts_face *cubes = ts_frame_data(&run->frame, TS_B_cube_size_face);
		for (u32 r = first; r < first + n; r++) texels += (u64)6 * cubes[r].n * cubes[r].n;
	} else if (ts_run_made(run, TS_B_offscreen_view)) {
		const ts_offscreen *views = ts_frame_data(&run->frame, TS_B_offscreen_view);
		for (u32 v = first; v < first + n; v++) texels += (u64)views[v].width * views[v].height;
	}
	return texels;
}

bool ts_run_has_cubes(const ts_run *run) { return ts_run_has(run, TS_B_cube_size_face); }

void ts_run_views(const ts_run *run, u32 *first, u32 *n)
{
	u32 each = ts_run_has_cubes(run) ? 6 : 1;
	*first = each * run->first_unit;
	*n = ts_frame_n(&run->frame, TS_B_offscreen_view) > 0 ? each * run->n_units : 0;
}

ts_status ts_run_fill(ts_run *run, ts_buffer_id id, u8 byte)
{
	ts_backend *backend = ts_run_backend_of(run);
	return backend->fill(backend, &run->frame, id, byte);
}

void *ts_run_zeros(ts_run *run, ts_buffer_id id, u32 n_dims, const u64 *shape)
{
	void *data = ts_frame_zeros(&run->frame, id, n_dims, shape);
	bool good = data != NULL && (run->backend == NULL || ts_run_fill(run, id, 0) == TS_OK);
	return good ? data : NULL;
}

ts_status ts_run_scan(ts_run *run, ts_buffer_id id, u64 *total)
{
	ts_backend *backend = ts_run_backend_of(run);
	const ts_sum_info *sum = ts_sum_of(id);
	if (backend->scan(backend, &run->frame, id, total) != TS_OK) return TS_ERROR;
	if (*total >= TS_NONE) return ts_run_too_many(*total, sum->what);
	if (sum->size != TS_DIM_none) ts_run_set_size(run, sum->size, *total);
	return TS_OK;
}

ts_status ts_run_too_many(u64 n, const char *what)
{
	return ts_fail(
		"%" PRIu64
		" %s are more than 32-bit indices can name; lower density.scale, depth_map.px, cube.max_px or the image's "
		"size",
		n, what);
}
