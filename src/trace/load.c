/* From the files of traces to a run. */
#include "trace/load.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "kernels/base/num.h"

const ts_trace_item *ts_load_item(const ts_trace *reference, const ts_trace *candidate, ts_buffer_id id)
{
	if (candidate != NULL && candidate->item[id].path != NULL) return &candidate->item[id];
	return reference->item[id].path != NULL ? &reference->item[id] : NULL;
}

ts_status ts_load_match(const ts_trace *reference, const ts_trace *candidate)
{
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	if (!reference->has_params)
		return ts_fail("%s/trace.json: no params; a stage cannot run without them", reference->dir);
	if (ts_params_check(&reference->params) != TS_OK) return TS_ERROR;
	if (reference->arrival) {
		return ts_fail(
			"%s/trace.json: order is \"arrival\"; a reference must be canonical, for its stages make points in "
			"order",
			reference->dir);
	}
	if (candidate == NULL) return TS_OK;
	if (candidate->pipeline != reference->pipeline) {
		return ts_fail("%s is of method %s; %s, of %s, cannot be its reference", candidate->dir,
		               candidate->pipeline->name, reference->dir, reference->pipeline->name);
	}
	for (size_t row = 0; row < n && candidate->has_params; row++) {
		char ours[64], theirs[64];
		ts_params_format(&reference->params, row, ours, sizeof ours);
		ts_params_format(&candidate->params, row, theirs, sizeof theirs);
		if (strcmp(ours, theirs) != 0) {
			return ts_fail("%s/trace.json: parameter %s is %s; %s would be right, as in %s", candidate->dir,
			               table[row].name, theirs, ours, reference->dir);
		}
	}
	return TS_OK;
}

static ts_status check_item(const ts_trace_item *item, ts_buffer_id id)
{
	if (item->cropped) return ts_refuse("%s: is cropped to a part of the picture; a stage needs all of it", item->path);
	ts_dim of = ts_buffer_counts(id);
	bool named = of == TS_DIM_none || ts_dim_table[of].bits == 32;
	u64 most = named && item->npy.n_dims == 1 ? TS_NONE : UINT64_MAX;
	if (item->npy.shape[0] <= most) return TS_OK;
	return ts_refuse("%s: %" PRIu64 " elements are more than 32-bit indices can name", item->path, item->npy.shape[0]);
}

/* Chooses the files and refuses those that cannot be loaded. */
static ts_status choose(ts_load *load, const ts_buffer_id *ids)
{
	char missing[512] = "";
	size_t used = 0;
	load->item[TS_B_scene_info] = ts_load_item(load->reference, load->candidate, TS_B_scene_info);
	for (; *ids != TS_N_BUFFERS; ids++) {
		load->item[*ids] = ts_load_item(load->reference, load->candidate, *ids);
		/* Without these the hall gives the stands, scene.info the eye's path, and scene.object the motions. */
		bool spared = *ids == TS_B_scene_stand || *ids == TS_B_scene_path || *ids == TS_B_scene_motion;
		if (load->item[*ids] != NULL || spared || used >= sizeof missing) continue;
		used += (size_t)snprintf(missing + used, sizeof missing - used, "%s%s", used > 0 ? ", " : "",
		                         ts_buffer_table[*ids].name);
	}
	if (used > 0) {
		return ts_refuse("%s%s%s: no file of %s", load->reference->dir, load->candidate != NULL ? " and " : "",
		                 load->candidate != NULL ? load->candidate->dir : "", missing);
	}
	u64 bytes = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (load->item[id] == NULL) continue;
		if (check_item(load->item[id], (ts_buffer_id)id) != TS_OK) return TS_ERROR;
		u64 more = load->item[id]->npy.n * ts_buffer_table[id].element_bytes; /* fits, as a file's size does */
		bytes = more > UINT64_MAX - bytes ? UINT64_MAX : bytes + more;
	}
	if (bytes <= ts_memory_limit()) return TS_OK;
	return ts_fail_as(TS_KIND_MEMORY, "%s: the buffers that are needed have %.1f GB; a run may use %.1f GB",
	                  load->reference->dir, (double)bytes / 1e9, (double)ts_memory_limit() / 1e9);
}

static ts_status read_all(ts_load *load)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_trace_item *item = load->item[id];
		if (item == NULL) continue;
		void *to = ts_frame_make(&load->run.frame, (ts_buffer_id)id, item->npy.n_dims, item->npy.shape);
		if (to == NULL || ts_trace_copy(to, item, (ts_buffer_id)id) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Gives stages the scene's arrays and counts; those that were not loaded are empty. */
static void make_scene(ts_load *load)
{
	ts_scene *scene = &load->scene;
	const ts_frame *frame = &load->run.frame;
	scene->vertices = ts_frame_data(frame, TS_B_scene_vertex);
	scene->n_vertices = (u32)ts_frame_n(frame, TS_B_scene_vertex);
	scene->triangles = ts_frame_data(frame, TS_B_scene_triangle);
	scene->n_triangles = (u32)ts_frame_n(frame, TS_B_scene_triangle);
	scene->materials = ts_frame_data(frame, TS_B_scene_material);
	scene->n_materials = (u32)ts_frame_n(frame, TS_B_scene_material);
	scene->slots = ts_frame_data(frame, TS_B_scene_slot);
	scene->n_slots = (u32)ts_frame_n(frame, TS_B_scene_slot);
	scene->images = ts_frame_data(frame, TS_B_scene_image);
	scene->n_images = (u32)ts_frame_n(frame, TS_B_scene_image);
	scene->texels = ts_frame_data(frame, TS_B_scene_texel);
	scene->n_texels = ts_frame_n(frame, TS_B_scene_texel);
	scene->lights = ts_frame_data(frame, TS_B_scene_light);
	scene->n_lights = (u32)ts_frame_n(frame, TS_B_scene_light);
	scene->objects = ts_frame_data(frame, TS_B_scene_object);
	scene->n_objects = (u32)ts_frame_n(frame, TS_B_scene_object);
	if (load->item[TS_B_scene_surfel] != NULL) {
		scene->surfels = ts_frame_data(frame, TS_B_scene_surfel);
		scene->n_surfels = (u32)ts_frame_n(frame, TS_B_scene_surfel);
	}
	if (load->item[TS_B_scene_stand] != NULL) {
		scene->stands = ts_frame_data(frame, TS_B_scene_stand);
		scene->n_stands = (u32)ts_frame_n(frame, TS_B_scene_stand);
	}
	if (load->item[TS_B_scene_path] != NULL) {
		scene->path = ts_frame_data(frame, TS_B_scene_path);
		scene->n_path = (u32)ts_frame_n(frame, TS_B_scene_path);
	}
	if (load->item[TS_B_scene_motion] != NULL && scene->n_objects > 0) {
		scene->motion = ts_frame_data(frame, TS_B_scene_motion);
		scene->n_motion = (u32)(ts_frame_n(frame, TS_B_scene_motion) / scene->n_objects);
	}
	if (load->item[TS_B_scene_info] != NULL && ts_frame_n(frame, TS_B_scene_info) > 0) {
		memcpy(&scene->info, ts_frame_data(frame, TS_B_scene_info), sizeof scene->info);
	}
}

ts_status ts_load_begin(ts_load **load, const ts_buffer_id *ids, const ts_trace *reference, const ts_trace *candidate,
                        u32 threads)
{
	*load = NULL;
	if (ts_load_match(reference, candidate) != TS_OK) return TS_ERROR;
	ts_load *made = ts_alloc_zero(1, sizeof *made, "a run");
	if (made == NULL) return TS_ERROR;
	made->pipeline = reference->pipeline;
	made->reference = reference;
	made->candidate = candidate;
	ts_run_begin(&made->run, &made->scene, &reference->params, threads);
	made->run.traced = true;
	if (choose(made, ids) != TS_OK || read_all(made) != TS_OK) {
		ts_load_end(made);
		return TS_ERROR;
	}
	make_scene(made);
	*load = made;
	return TS_OK;
}

void ts_load_end(ts_load *load)
{
	if (load == NULL) return;
	ts_run_end(&load->run);
	free(load);
}
