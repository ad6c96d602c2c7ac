/* Traces. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <touchstone/trace.h>
#include "api/api.h"
#include "api/golden_trace.h"
#include "model/digest.h"
#include "trace/emitted/emit.h"
#include "trace/emitted/sums.h"
#include "trace/item.h"
#include "trace/keep.h"

ts_status ts_api_effect(const char *effect)
{
	if (ts_effect_find(effect) != NULL) return TS_OK;
	return ts_fail("there is no effect \"%.40s\"; ts_method_at names all", effect);
}

const ts_pipeline *ts_api_method(const char *effect, const char *method)
{
	char names[256] = "";
	size_t n = 0;
	const ts_pipeline *pipeline = ts_pipeline_find(effect, method);
	if (pipeline != NULL || ts_api_effect(effect) != TS_OK) return pipeline;
	for (const ts_pipeline *const *p = ts_pipelines(); *p != NULL && n < sizeof names; p++) {
		if (strcmp((*p)->effect->name, effect) != 0) continue;
		n += (size_t)snprintf(names + n, sizeof names - n, "%s%s", n > 0 ? ", " : "", (*p)->name);
	}
	ts_fail("%s by %.40s: no such method; there are %s", effect, method, names);
	return NULL;
}

/* "image.srgb,image.radiance". */
static ts_status read_buffers(ts_keep *keep, const ts_pipeline *pipeline, const char *names)
{
	char name[64];
	if (*names == 0) return ts_fail("ts_run_options.buffers: names none; NULL would keep all");
	for (const char *at = names; *at != 0; at += *at == ',') {
		size_t n = strcspn(at, ",");
		ts_buffer_id id;
		snprintf(name, sizeof name, "%.*s", (int)(n < sizeof name ? n : sizeof name - 1), at);
		if (!ts_trace_find(&id, name)) {
			return ts_fail("ts_run_options.buffers: there is no buffer \"%s\"; ts_buffer_at names all", name);
		}
		if (!ts_emit_is_scene(id) && ts_pipeline_maker(pipeline, id) == NULL) {
			return ts_fail("ts_run_options.buffers: %s by %s makes no %s", pipeline->effect->name, pipeline->name,
			               name);
		}
		keep->keep[id] = true;
		at += n;
	}
	return TS_OK;
}

static ts_status run_method(const ts_context *context, ts_trace **trace, const ts_scene *scene, const ts_params *params,
                            const ts_pipeline *pipeline, const ts_run_options *options)
{
	ts_keep keep = {.whole = options->buffers == NULL, .margins = options->margins != 0};
	ts_how how = context->how;
	how.arrival = options->arrival != 0;
	if (options->buffers != NULL && read_buffers(&keep, pipeline, options->buffers) != TS_OK) return TS_ERROR;
	if (options->buffers != NULL && keep.margins) {
		return ts_fail("ts_run_options: margins are part of a whole trace; buffers NULL would be right");
	}
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = ts_trace_keep(trace, pipeline, scene, params, &how, &keep);
	ts_api_leave();
	for (u32 id = 0; status == TS_OK && id < TS_N_BUFFERS; id++) {
		if (!keep.keep[id] || (*trace)->item[id].path != NULL) continue;
		status = ts_fail("ts_run_options.buffers: this run makes no %s; a whole trace may", ts_buffer_table[id].name);
	}
	if (status == TS_OK) return TS_OK;
	ts_trace_close(*trace);
	*trace = NULL;
	return status;
}

ts_status ts_trace_run(ts_context *context, ts_trace **trace, const ts_scene *scene, const ts_params *params,
                       const char *effect, const char *method, const ts_run_options *options)
{
	ts_run_options ours = {0};
	if (TS_LACKS(trace)) return TS_ERROR;
	*trace = NULL;
	if (TS_LACKS(context) || TS_LACKS(scene) || TS_LACKS(params) || TS_LACKS(effect) || TS_LACKS(method)) {
		return TS_ERROR;
	}
	if (ts_api_options(&ours, sizeof ours, options, "ts_run_options") != TS_OK) return TS_ERROR;
	const ts_pipeline *pipeline = ts_api_method(effect, method);
	return pipeline != NULL ? run_method(context, trace, scene, params, pipeline, &ours) : TS_ERROR;
}

typedef void take_digest(void *user, const char *buffer, const char *hex);

static void give_digests(const ts_sums *sums, const ts_pipeline *pipeline, take_digest *each, void *user)
{
	ts_buffer_id ids[TS_N_BUFFERS];
	ts_emit_order(ids, pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS; i++) {
		if (sums->hex[ids[i]][0] != 0) each(user, ts_buffer_table[ids[i]].name, sums->hex[ids[i]]);
	}
}

ts_status ts_run_digests(ts_context *context, const ts_scene *scene, const ts_params *params, const char *effect,
                         const char *method, take_digest *each, void *user)
{
	if (TS_LACKS(context) || TS_LACKS(scene) || TS_LACKS(params) || TS_LACKS(effect) || TS_LACKS(method)) {
		return TS_ERROR;
	}
	if (each == NULL) return ts_fail("ts_run_digests: each is NULL; a function would be right");
	const ts_pipeline *pipeline = ts_api_method(effect, method);
	ts_sums *sums = pipeline != NULL ? ts_alloc(1, sizeof *sums, "digests") : NULL;
	ts_status status = sums != NULL ? ts_api_enter(context) : TS_ERROR;
	if (status == TS_OK) {
		status = ts_sums_of(sums, pipeline, scene, params, &context->how);
		ts_api_leave();
	}
	if (status == TS_OK) give_digests(sums, pipeline, each, user);
	free(sums);
	return status;
}

ts_status ts_trace_open(ts_context *context, ts_trace **trace, const char *folder)
{
	if (TS_LACKS(trace)) return TS_ERROR;
	*trace = NULL;
	if (TS_LACKS(context) || TS_LACKS(folder) || ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = ts_golden_is(folder) ? ts_golden_open(trace, folder) : ts_trace_open_folder(trace, folder);
	ts_api_leave();
	return status;
}

ts_status ts_trace_open_npy(ts_context *context, ts_trace **trace, const char *path)
{
	ts_buffer_id id;
	if (TS_LACKS(trace)) return TS_ERROR;
	*trace = NULL;
	if (TS_LACKS(context) || TS_LACKS(path) || ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = ts_trace_open_file(trace, path, &id);
	ts_api_leave();
	return status;
}

ts_status ts_trace_open_list(ts_context *context, ts_trace **trace, const char *folder, const char *list, int arrival,
                             const ts_trace *reference)
{
	if (TS_LACKS(trace)) return TS_ERROR;
	*trace = NULL;
	if (TS_LACKS(context) || TS_LACKS(folder) || TS_LACKS(list) || TS_LACKS(reference)) return TS_ERROR;
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = ts_trace_open_layout(trace, folder, list, arrival != 0, reference);
	ts_api_leave();
	return status;
}

ts_status ts_trace_candidate(ts_context *context, ts_trace **trace, const ts_trace *reference, int arrival)
{
	if (TS_LACKS(trace)) return TS_ERROR;
	*trace = NULL;
	if (TS_LACKS(context) || TS_LACKS(reference)) return TS_ERROR;
	ts_trace *made = ts_trace_new("the candidate");
	if (made == NULL) return TS_ERROR;
	made->pipeline = reference->pipeline;
	made->has_params = reference->has_params;
	made->params = reference->params;
	made->arrival = arrival != 0;
	made->open = true;
	*trace = made;
	return TS_OK;
}

ts_status ts_api_buffer(ts_buffer_id *id, const char *name)
{
	return ts_trace_find(id, name) ? TS_OK : ts_fail("there is no buffer \"%.60s\"; ts_buffer_at names all", name);
}

ts_status ts_trace_put(ts_trace *trace, const char *buffer, uint32_t n_dims, const uint64_t *shape, const void *data,
                       size_t bytes)
{
	ts_buffer_id id;
	ts_npy npy = {.n_dims = n_dims};
	if (TS_LACKS(trace) || TS_LACKS(buffer) || TS_LACKS(shape) || ts_api_buffer(&id, buffer) != TS_OK) return TS_ERROR;
	if (bytes > 0 && TS_LACKS(data)) return TS_ERROR;
	if (!trace->open) return ts_fail("ts_trace_put: %s is no candidate; ts_trace_candidate makes one", trace->dir);
	if (n_dims < 1 || n_dims > TS_MAX_DIMS) {
		return ts_fail("%s: %lu dimensions; 1 to %d are right", buffer, (unsigned long)n_dims, TS_MAX_DIMS);
	}
	memcpy(npy.shape, shape, n_dims * sizeof *shape);
	size_t element_bytes = ts_buffer_table[id].element_bytes;
	if (!ts_shape_count(&npy.n, n_dims, shape) || npy.n > SIZE_MAX / element_bytes || npy.n * element_bytes != bytes) {
		return ts_fail("%s: %zu bytes are not those of its shape in elements of %zu bytes", buffer, bytes,
		               element_bytes);
	}
	return ts_item_put(trace, id, &npy, data);
}

int ts_trace_has(const ts_trace *trace, const char *name)
{
	ts_buffer_id id;
	return trace != NULL && name != NULL && ts_trace_find(&id, name) && trace->item[id].path != NULL;
}

/* Loads a buffer from its file. */
static ts_status bring(ts_trace_item *item, ts_buffer_id id)
{
	if (item->memory != NULL) return TS_OK;
	if (item->unpacked != NULL) {
		item->memory = ts_item_unpack(item, id);
		return item->memory != NULL ? TS_OK : TS_ERROR;
	}
	void *data = ts_alloc((size_t)item->npy.n, ts_buffer_table[id].element_bytes, ts_buffer_table[id].name);
	if (data == NULL || ts_trace_copy(data, item, id) != TS_OK) {
		free(data);
		return TS_ERROR;
	}
	item->memory = item->owned = data;
	return TS_OK;
}

/* The item of a buffer that the trace has; NULL with the message set. */
static ts_trace_item *find_item(ts_buffer_id *id, ts_trace *trace, const char *name)
{
	if (TS_LACKS(trace) || TS_LACKS(name) || ts_api_buffer(id, name) != TS_OK) return NULL;
	ts_trace_item *item = &trace->item[*id];
	if (item->path != NULL) return item;
	ts_fail("%s: there is no %s", trace->dir, ts_buffer_table[*id].name);
	return NULL;
}

static const ts_buffer_view *view_of(ts_trace *trace, ts_buffer_id id)
{
	const ts_trace_item *item = &trace->item[id];
	const ts_buffer_info *info = &ts_buffer_table[id];
	ts_buffer_view *view = &trace->view[id];
	*view = (ts_buffer_view){info->name, info->element, info->element_bytes, item->memory, item->npy.n_dims, {0}};
	memcpy(view->shape, item->npy.shape, sizeof view->shape);
	return view;
}

const ts_buffer_view *ts_trace_buffer(ts_trace *trace, const char *name)
{
	ts_buffer_id id;
	ts_trace_item *item = find_item(&id, trace, name);
	return item != NULL && bring(item, id) == TS_OK ? view_of(trace, id) : NULL;
}

const ts_buffer_view *ts_trace_look(ts_trace *trace, const char *name)
{
	ts_buffer_id id;
	return find_item(&id, trace, name) != NULL ? view_of(trace, id) : NULL;
}

const ts_trace_info *ts_trace_about(ts_trace *trace)
{
	if (TS_LACKS(trace)) return NULL;
	trace->info = (ts_trace_info){
		trace->dir,       trace->pipeline->effect->name, trace->pipeline->name, trace->producer, trace->arrival,
		trace->has_params};
	return &trace->info;
}

ts_status ts_trace_digest(ts_trace *trace, const char *name, char hex[65])
{
	ts_buffer_id id;
	if (TS_LACKS(hex)) return TS_ERROR;
	const ts_trace_item *item = find_item(&id, trace, name);
	return item != NULL ? ts_trace_sha256(hex, item, id) : TS_ERROR;
}

int64_t ts_trace_counter(const ts_trace *trace, const char *name)
{
	return trace != NULL && name != NULL ? ts_counter_of(trace->counters, trace->n_counters, name) : 0;
}
