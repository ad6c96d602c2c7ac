/* A golden as a trace: its small buffers, its picture, and of all others the digests. */
#include "api/golden_trace.h"
#include <stdio.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "golden/beside.h"
#include "golden/params.h"
#include "trace/item.h"

static ts_status keep_files(ts_trace *trace, const ts_golden *golden, const char *folder)
{
	ts_status status = TS_OK;
	for (u32 id = 0; id < TS_N_BUFFERS && status == TS_OK; id++) {
		const ts_golden_file *file = &golden->file[id];
		if (file->data == NULL) {
			memcpy(trace->item[id].sha256, golden->sums.hex[id], TS_DIGEST_BYTES);
		} else if (strcmp(file->hex, golden->sums.hex[id]) != 0) {
			status = ts_fail("%s: %s: small/ does not hold what SHA256SUMS says", folder, ts_buffer_table[id].name);
		} else {
			status = ts_item_keep(trace, (ts_buffer_id)id, &file->npy, file->data + file->npy.data_at);
		}
	}
	return status;
}

/* Puts the picture without its alpha, if SHA256SUMS has its digest. */
static ts_status put_picture(ts_trace *trace, u8 *rgba, u32 width, u32 height)
{
	char hex[TS_DIGEST_BYTES], wanted[TS_DIGEST_BYTES];
	ts_trace_item *item = &trace->item[TS_B_image_srgb];
	const u64 n = (u64)width * height;
	const ts_npy shape = {.n_dims = 3, .shape = {height, width, 3}, .n = 3 * n};
	for (u64 i = 0; i < n; i++) memmove(rgba + 3 * i, rgba + 4 * i, 3);
	memcpy(wanted, item->sha256, sizeof wanted);
	if (ts_item_keep(trace, TS_B_image_srgb, &shape, rgba) != TS_OK) return TS_ERROR;
	if (ts_trace_sha256(hex, item, TS_B_image_srgb) != TS_OK) return TS_ERROR;
	if (strcmp(hex, wanted) == 0) return TS_OK;
	return ts_fail("%s/%s: not the picture whose digest SHA256SUMS says", trace->dir, TS_GOLDEN_PREVIEW);
}

static ts_status add_picture(ts_trace *trace, const ts_golden_dir *dir)
{
	char *file;
	size_t bytes;
	u8 *rgba = NULL;
	u32 width, height;
	const ts_trace_item *item = &trace->item[TS_B_image_srgb];
	if (item->path != NULL || item->sha256[0] == 0 || !ts_golden_has(dir, TS_GOLDEN_PREVIEW)) return TS_OK;
	if (ts_golden_read_file(&file, &bytes, dir, TS_GOLDEN_PREVIEW, TS_GOLDEN_FILE_BYTES) != TS_OK) return TS_ERROR;
	ts_status status = ts_image_decode(&rgba, &width, &height, file, bytes, TS_GOLDEN_PIXELS, dir->path);
	if (status == TS_OK) status = put_picture(trace, rgba, width, height);
	free(rgba);
	free(file);
	return status;
}

static ts_status read_all(ts_trace *trace, const ts_golden_dir *dir)
{
	ts_golden_settings settings;
	ts_golden golden;
	if (ts_golden_read_params(&settings, dir) != TS_OK) return TS_ERROR;
	trace->pipeline = ts_pipeline_find(settings.effect, settings.method);
	if (trace->pipeline == NULL)
		return ts_fail("%s: %s by %s: no such method", dir->path, settings.effect, settings.method);
	trace->params = ts_pipeline_params(trace->pipeline, &settings.params);
	trace->has_params = true;
	snprintf(trace->producer, sizeof trace->producer, "golden");
	ts_status status = ts_golden_read(&golden, dir, trace->pipeline);
	if (status == TS_OK) status = keep_files(trace, &golden, dir->path);
	if (status == TS_OK) status = add_picture(trace, dir);
	ts_golden_free(&golden);
	return status;
}

bool ts_golden_is(const char *folder)
{
	ts_golden_dir dir;
	if (ts_golden_dir_open(&dir, NULL, folder) != TS_OK) return false;
	bool is = ts_golden_has(&dir, TS_GOLDEN_SUMS) && ts_golden_has(&dir, TS_GOLDEN_PARAMS) &&
	          !ts_golden_has(&dir, "trace.json");
	ts_golden_dir_close(&dir);
	return is;
}

ts_status ts_golden_open(ts_trace **trace, const char *folder)
{
	ts_golden_dir dir;
	ts_trace *made = ts_trace_new(folder);
	ts_status status = made != NULL ? ts_golden_dir_open(&dir, NULL, folder) : TS_ERROR;
	if (status == TS_OK) {
		status = read_all(made, &dir);
		ts_golden_dir_close(&dir);
	}
	*trace = status == TS_OK ? made : NULL;
	if (status != TS_OK) ts_trace_close(made);
	return status;
}
