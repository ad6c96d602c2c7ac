/* Files of a trace, written as the stages make them. */
#include "trace/write.h"
#include <stdio.h>
#include <stdlib.h>
#include "output/file.h"
#include "trace/describe.h"
#include "trace/emitted/sums.h"
#include "trace/packed.h"

struct ts_trace_writer {
	const ts_pipeline *pipeline;
	ts_trace_options options;
	ts_sums sums;
	ts_trace_file files[TS_N_BUFFERS];
	ts_file open[TS_N_BUFFERS];
	ts_packer *packer[TS_N_BUFFERS]; /* of the open files; NULL: not compressed */
	u64 left[TS_N_BUFFERS];          /* bytes that the file still lacks */
};

/* `left`: bytes of the file that follow these. */
static ts_status put(ts_trace_writer *w, ts_buffer_id id, const void *data, u64 bytes, u64 left)
{
	if (bytes == 0) return TS_OK;
	if (ts_digest_all(&w->sums.digest[id], data, (size_t)bytes) != TS_OK) return TS_ERROR;
	w->left[id] = left;
	if (!w->files[id].has_file) return TS_OK;
	if (w->packer[id] == NULL) return ts_file_put(&w->open[id], data, (size_t)bytes);
	return ts_packer_put(w->packer[id], &w->open[id], data, (size_t)bytes, left == 0);
}

static bool is_cropped(const ts_trace_writer *w, ts_buffer_id id)
{
	return w->options.crop[2] != 0 && ts_shape_is_image(ts_buffer_shape(id));
}

static void name_file(ts_trace_writer *w, ts_buffer_id id)
{
	char name[TS_EMIT_NAME];
	ts_trace_file *file = &w->files[id];
	ts_emit_name(name, w->pipeline, id);
	snprintf(file->name, sizeof file->name, "%s%s%s", file->shared ? TS_TRACE_SCENE : "", name,
	         w->options.compress ? TS_PACKED_SUFFIX : "");
}

/* Notes the file for trace.json, except its digest. */
static void note_file(ts_trace_writer *w, const ts_chunk *chunk)
{
	ts_trace_file *file = &w->files[chunk->id];
	file->made = true;
	file->has_file = !w->options.without[chunk->id];
	file->n_dims = chunk->n_dims;
	memcpy(file->shape, chunk->shape, sizeof file->shape);
	file->cropped = is_cropped(w, chunk->id);
	if (file->cropped) {
		file->shape[0] = w->options.crop[3];
		file->shape[1] = w->options.crop[2];
	}
	name_file(w, chunk->id);
	ts_npy_descr(file->descr, chunk->id);
}

static ts_status open_file(ts_trace_writer *w, ts_buffer_id id, u64 bytes)
{
	const char *path = w->options.place(w->options.user, w->files[id].name);
	if (path == NULL || ts_file_begin(&w->open[id], path) != TS_OK) return TS_ERROR;
	if (!w->options.compress) return TS_OK;
	w->packer[id] = ts_packer_begin(bytes, path);
	return w->packer[id] != NULL ? TS_OK : TS_ERROR;
}

static ts_status begin_file(ts_trace_writer *w, const ts_chunk *chunk)
{
	char header[TS_NPY_HEADER];
	u64 n;
	note_file(w, chunk);
	const ts_trace_file *file = &w->files[chunk->id];
	if (!ts_shape_count(&n, file->n_dims, file->shape)) return ts_fail("%s: too large for a file", file->name);
	u64 bytes = n * ts_buffer_table[chunk->id].element_bytes;
	size_t head = ts_npy_header(header, file->descr, file->n_dims, file->shape);
	ts_digest_begin(&w->sums.digest[chunk->id]);
	if (file->has_file && open_file(w, chunk->id, head + bytes) != TS_OK) return TS_ERROR;
	return put(w, chunk->id, header, head, bytes);
}

/* The rows of the crop's part of an image. */
static ts_status put_crop(ts_trace_writer *w, const ts_chunk *chunk)
{
	const u32 *crop = w->options.crop;
	u64 pixel_bytes = chunk->bytes / (chunk->shape[0] * chunk->shape[1]);
	for (u32 y = crop[1]; y < crop[1] + crop[3]; y++) {
		const u8 *row = (const u8 *)chunk->data + (y * chunk->shape[1] + crop[0]) * pixel_bytes;
		u64 bytes = crop[2] * pixel_bytes;
		if (put(w, chunk->id, row, bytes, w->left[chunk->id] - bytes) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static ts_status close_file(ts_trace_writer *w, ts_buffer_id id)
{
	ts_digest_end(&w->sums.digest[id], w->files[id].sha256);
	ts_packer_free(w->packer[id]);
	w->packer[id] = NULL;
	return w->files[id].has_file ? ts_file_end(&w->open[id]) : TS_OK;
}

static ts_status take(void *user, const ts_chunk *chunk)
{
	ts_trace_writer *w = user;
	bool complete = !chunk->first && !w->sums.digest[chunk->id].begun;
	if (complete && chunk->bytes == 0) return TS_OK; /* a cube out of sight, after the last one in sight */
	if (chunk->first && begin_file(w, chunk) != TS_OK) return TS_ERROR;
	ts_status status = is_cropped(w, chunk->id)
	                       ? put_crop(w, chunk)
	                       : put(w, chunk->id, chunk->data, chunk->bytes, w->left[chunk->id] - chunk->bytes);
	if (status != TS_OK) return status;
	return w->left[chunk->id] == 0 ? close_file(w, chunk->id) : TS_OK;
}

/* A buffer of the scene, in one part. Its file is written once for all traces with the same scene. */
static ts_status take_scene(void *user, const ts_chunk *chunk)
{
	ts_trace_writer *w = user;
	ts_trace_file *file = &w->files[chunk->id];
	if (w->options.shared == NULL || w->options.without[chunk->id]) return take(w, chunk);
	char *there = w->options.shared->sha256[chunk->id];
	ts_sums own = {.hex = {{0}}};
	if (ts_sums_take(&own, chunk) != TS_OK) return TS_ERROR;
	ts_sums_end(&own);
	bool same = strcmp(there, own.hex[chunk->id]) == 0;
	file->shared = same || there[0] == 0;
	if (!same) {
		ts_status status = take(w, chunk);
		if (status == TS_OK && file->shared) memcpy(there, file->sha256, sizeof file->sha256);
		return status;
	}
	note_file(w, chunk);
	memcpy(file->sha256, there, sizeof file->sha256);
	return TS_OK;
}

ts_status ts_trace_write_begin(ts_trace_writer **writer, const ts_pipeline *pipeline, const ts_run *run,
                               const ts_trace_options *options)
{
	*writer = NULL;
	ts_trace_writer *w = ts_alloc_zero(1, sizeof *w, "a trace");
	if (w == NULL) return TS_ERROR;
	w->pipeline = pipeline;
	w->options = *options;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) w->open[id].descriptor = -1;
	if (ts_emit_scene(run, take_scene, w) != TS_OK) {
		ts_trace_write_free(w);
		return TS_ERROR;
	}
	*writer = w;
	return TS_OK;
}

ts_status ts_trace_write_stage(ts_trace_writer *writer, const ts_run *run, const ts_stage *stage)
{
	return ts_emit_stage(run, stage, take, writer);
}

/* The lowest version that has all features of the trace. */
static int version_of(const ts_trace_writer *w)
{
	bool beyond = false;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		beyond |= w->files[id].has_file && (w->files[id].shared || w->options.compress);
	}
	return beyond ? TS_TRACE_VERSION_SHARED : TS_TRACE_VERSION;
}

ts_status ts_trace_write_end(ts_trace_writer *w, const ts_run *run)
{
	const char *path = w->options.place(w->options.user, "trace.json");
	if (path == NULL) return TS_ERROR;
	const ts_trace_description about = {w->pipeline, run, w->files, w->options.crop, version_of(w)};
	json_t *root = ts_trace_describe(&about);
	if (root == NULL) return ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
	return ts_trace_write_json(path, root);
}

void ts_trace_write_free(ts_trace_writer *w)
{
	if (w == NULL) return;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_file_drop(&w->open[id]);
		ts_packer_free(w->packer[id]);
	}
	ts_sums_end(&w->sums);
	free(w);
}

u64 ts_trace_estimate(const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *typed,
                      const ts_trace_options *options)
{
	const ts_params params = ts_pipeline_params(pipeline, typed);
	const ts_expected expected = ts_pipeline_expect(pipeline, scene, &params);
	u64 bytes = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_step *step = ts_pipeline_maker(pipeline, (ts_buffer_id)id);
		if (options->without[id] || (step != NULL && !ts_pipeline_takes(step, &params, true))) continue;
		if (step != NULL && step->only_margins && !options->margins) continue;
		if (step == NULL && !ts_emit_is_scene((ts_buffer_id)id)) continue;
		bool batches = step != NULL && step->each_batch && ts_emit_is_batched((ts_buffer_id)id);
		u64 part = ts_pipeline_bytes((ts_buffer_id)id, &expected.sizes);
		bytes += TS_NPY_HEADER + (part * (batches ? expected.batches : 1));
	}
	return bytes;
}
