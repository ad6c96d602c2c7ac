/* Files of a trace, written as the stages make them. */
#include "write.h"
#include <stdlib.h>
#include "../output/file.h"
#include "describe.h"
#include "sums.h"

struct ts_trace_writer {
	const ts_pipeline *pipeline;
	ts_trace_options options;
	ts_sums sums;
	ts_trace_file files[TS_N_BUFFERS];
	ts_file open[TS_N_BUFFERS];
	u64 left[TS_N_BUFFERS]; /* bytes that the file still lacks */
};

static ts_status put(ts_trace_writer *w, ts_buffer_id id, const void *data, u64 bytes)
{
	ts_digest_add(&w->sums.digest[id], data, (size_t)bytes);
	return w->options.without[id] ? TS_OK : ts_file_put(&w->open[id], data, (size_t)bytes);
}

static bool is_cropped(const ts_trace_writer *w, ts_buffer_id id)
{
	return w->options.crop[2] != 0 && ts_shape_is_image(ts_buffer_shape(id));
}

static ts_status open_file(ts_trace_writer *w, const ts_chunk *chunk)
{
	ts_trace_file *file = &w->files[chunk->id];
	char header[TS_NPY_HEADER];
	file->made = true;
	file->n_dims = chunk->n_dims;
	memcpy(file->shape, chunk->shape, sizeof file->shape);
	file->cropped = is_cropped(w, chunk->id);
	if (file->cropped) {
		file->shape[0] = w->options.crop[3];
		file->shape[1] = w->options.crop[2];
	}
	ts_emit_name(file->name, w->pipeline, chunk->id);
	ts_npy_descr(file->descr, chunk->id);
	ts_digest_begin(&w->sums.digest[chunk->id]);
	if (!w->options.without[chunk->id]) {
		file->path = w->options.place(w->options.user, file->name);
		if (file->path == NULL) return TS_ERROR;
		if (ts_file_begin(&w->open[chunk->id], file->path) != TS_OK) return TS_ERROR;
	}
	u64 n;
	if (!ts_shape_count(&n, file->n_dims, file->shape)) return ts_fail("%s: too large for a file", file->name);
	w->left[chunk->id] = n * ts_buffer_table[chunk->id].element_bytes;
	return put(w, chunk->id, header, ts_npy_header(header, file->descr, file->n_dims, file->shape));
}

/* The rows of the crop's part of an image. */
static ts_status put_crop(ts_trace_writer *w, const ts_chunk *chunk)
{
	const u32 *crop = w->options.crop;
	u64 pixel_bytes = chunk->bytes / (chunk->shape[0] * chunk->shape[1]);
	for (u32 y = crop[1]; y < crop[1] + crop[3]; y++) {
		const u8 *row = (const u8 *)chunk->data + (y * chunk->shape[1] + crop[0]) * pixel_bytes;
		if (put(w, chunk->id, row, crop[2] * pixel_bytes) != TS_OK) return TS_ERROR;
	}
	w->left[chunk->id] = 0;
	return TS_OK;
}

static ts_status close_file(ts_trace_writer *w, ts_buffer_id id)
{
	ts_digest_end(&w->sums.digest[id], w->files[id].sha256);
	return w->options.without[id] ? TS_OK : ts_file_end(&w->open[id]);
}

static ts_status take(void *user, const ts_chunk *chunk)
{
	ts_trace_writer *w = user;
	bool complete = !chunk->first && !w->sums.digest[chunk->id].begun;
	if (complete && chunk->bytes == 0) return TS_OK; /* a cube out of sight, behind the last that is in sight */
	if (chunk->first && open_file(w, chunk) != TS_OK) return TS_ERROR;
	if (is_cropped(w, chunk->id)) {
		if (put_crop(w, chunk) != TS_OK) return TS_ERROR;
	} else {
		if (put(w, chunk->id, chunk->data, chunk->bytes) != TS_OK) return TS_ERROR;
		w->left[chunk->id] -= chunk->bytes;
	}
	return w->left[chunk->id] == 0 ? close_file(w, chunk->id) : TS_OK;
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
	if (ts_emit_scene(run, take, w) != TS_OK) {
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

ts_status ts_trace_write_end(ts_trace_writer *w, const ts_run *run)
{
	const char *path = w->options.place(w->options.user, "trace.json");
	if (path == NULL) return TS_ERROR;
	const ts_trace_about about = {w->pipeline, run, w->files, w->options.crop};
	json_t *root = ts_trace_describe(&about);
	if (root == NULL) return ts_fail("%s: out of memory", path);
	return ts_trace_write_json(path, root);
}

void ts_trace_write_free(ts_trace_writer *w)
{
	if (w == NULL) return;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_file_drop(&w->open[id]);
	}
	ts_sums_end(&w->sums);
	free(w);
}

u64 ts_trace_estimate(const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *params,
                      const ts_trace_options *options)
{
	const ts_expected expected = ts_pipeline_expect(pipeline, scene, params);
	u64 bytes = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_step *step = ts_pipeline_maker(pipeline, (ts_buffer_id)id);
		if (options->without[id] || (step != NULL && !ts_pipeline_takes(step, params, true))) continue;
		if (step != NULL && step->only_margins && !options->margins) continue;
		if (step == NULL && !ts_emit_is_scene((ts_buffer_id)id)) continue;
		bool batches = step != NULL && step->each_batch && ts_emit_is_batched((ts_buffer_id)id);
		u64 part = ts_pipeline_bytes((ts_buffer_id)id, &expected.sizes);
		bytes += TS_NPY_HEADER + (part * (batches ? expected.batches : 1));
	}
	return bytes;
}
