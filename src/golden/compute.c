/* Computing a golden: a traced run whose files are digested, looked through for numbers that no stage may store
 * (CONTRACT rules 12 and 24), and kept if small. */
#include <stdlib.h>
#include "golden/golden.h"
#include "kernels/base/num.h"
#include "model/order.h"

/* A float that is NaN, infinite, -0 or nearer to 0 than 2^-100. */
static bool is_stray(u32 bits)
{
	u32 size = bits & 0x7fffffffu;
	return size >= 0x7f800000u || (bits != 0 && size < 0x0d800000u);
}

/* True if word `at` of an element is a float. */
static bool is_float(ts_buffer_id id, size_t at)
{
	const char *element = ts_buffer_table[id].element;
	if (strcmp(element, "f32") == 0) return true;
	size_t n, word = 0;
	const ts_field_info *fields = ts_field_table(&n);
	for (size_t i = 0; i < n; i++) {
		if (strcmp(fields[i].record, element) != 0) continue;
		size_t words = fields[i].count * (ts_type_bytes(fields[i].type) / 4);
		if (at >= word && at < word + words) return strcmp(fields[i].type, "f32") == 0;
		word += words;
	}
	return false;
}

/* A key's high half is a distance; an axial one of 0 is before the near plane. */
static bool is_stray_key(ts_buffer_id id, u64 key)
{
	u32 distance = (u32)(key >> 32);
	bool axial = strstr(ts_buffer_table[id].doc, "axial") != NULL;
	return key != TS_EMPTY && (is_stray(distance) || (distance == 0 && axial));
}

static u64 stray_keys(ts_buffer_id id, const u8 *data, u64 bytes)
{
	u64 count = 0;
	for (u64 i = 0; i < bytes / 8; i++) count += is_stray_key(id, ts_order_read(data + 8 * i, 8));
	return count;
}

u64 ts_golden_strays(ts_buffer_id id, const void *data, u64 bytes)
{
	const ts_buffer_info *info = &ts_buffer_table[id];
	bool floats[64] = {false}, any = false;
	size_t n_words = info->element_bytes / 4;
	if (strcmp(info->element, "u64") == 0 && strstr(info->name, ".depth_") != NULL) return stray_keys(id, data, bytes);
	for (size_t i = 0; i < n_words && i < 64; i++) any |= floats[i] = is_float(id, i);
	u64 count = 0;
	for (u64 i = 0; any && i < bytes / 4; i++) {
		count += floats[i % n_words] && is_stray((u32)ts_order_read((const u8 *)data + 4 * i, 4));
	}
	return count;
}

/* Allocates the file, with its header, if it is to be kept. */
static ts_status begin_file(ts_golden *golden, const ts_chunk *chunk)
{
	char header[TS_NPY_HEADER], descr[TS_NPY_DESCR];
	ts_golden_file *file = &golden->file[chunk->id];
	u64 n;
	ts_npy_descr(descr, chunk->id);
	size_t head = ts_npy_header(header, descr, chunk->n_dims, chunk->shape);
	ts_shape_count(&n, chunk->n_dims, chunk->shape);
	golden->bytes[chunk->id] = head + n * ts_buffer_table[chunk->id].element_bytes;
	free(file->data);
	*file = (ts_golden_file){.data = NULL};
	if (!ts_golden_is_small(golden, chunk->id) && chunk->id != TS_B_image_srgb) return TS_OK;
	file->bytes = (size_t)golden->bytes[chunk->id];
	file->data = ts_alloc(file->bytes, 1, ts_buffer_table[chunk->id].name);
	if (file->data == NULL) return TS_ERROR;
	memcpy(file->data, header, head);
	file->taken = head;
	file->npy = (ts_npy){.n_dims = chunk->n_dims, .n = n, .data_at = head};
	memcpy(file->npy.shape, chunk->shape, sizeof file->npy.shape);
	return TS_OK;
}

static ts_status take(void *user, const ts_chunk *chunk)
{
	ts_golden *golden = user;
	ts_golden_file *file = &golden->file[chunk->id];
	if (ts_sums_take(&golden->sums, chunk) != TS_OK) return TS_ERROR;
	if (chunk->first && begin_file(golden, chunk) != TS_OK) return TS_ERROR;
	u64 strays = ts_golden_strays(chunk->id, chunk->data, chunk->bytes);
	if (strays != 0 && golden->stray == TS_N_BUFFERS) golden->stray = chunk->id;
	golden->n_strays += strays;
	if (file->data == NULL || chunk->bytes == 0) return TS_OK;
	if (chunk->bytes > file->bytes - file->taken) {
		return ts_fail("%s: its parts are longer than its shape", ts_buffer_table[chunk->id].name);
	}
	memcpy(file->data + file->taken, chunk->data, (size_t)chunk->bytes);
	file->taken += (size_t)chunk->bytes;
	return TS_OK;
}

static ts_status take_stage(const ts_run *run, const ts_stage *stage, void *user)
{
	return ts_emit_stage(run, stage, take, user);
}

ts_status ts_golden_compute(ts_golden *golden, const ts_golden_job *job)
{
	ts_run run;
	memset(golden, 0, sizeof *golden);
	golden->stray = TS_N_BUFFERS;
	ts_run_begin(&run, job->scene, job->params, job->how.threads);
	ts_run_how(&run, &job->how);
	run.traced = run.lean = true;
	run.hook = take_stage;
	run.hook_user = golden;
	ts_status status = ts_emit_scene(&run, take, golden);
	if (status == TS_OK) status = ts_pipeline_run(job->pipeline, &run);
	ts_sums_end(&golden->sums);
	ts_run_end(&run);
	return status;
}

void ts_golden_free(ts_golden *golden)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		free(golden->file[id].data);
		golden->file[id] = (ts_golden_file){.data = NULL};
	}
}

bool ts_golden_is_small(const ts_golden *computed, ts_buffer_id id)
{
	return computed->bytes[id] != 0 && computed->bytes[id] <= TS_GOLDEN_SMALL_BYTES;
}

const u8 *ts_golden_image(const ts_golden *golden, u32 *width, u32 *height)
{
	const ts_golden_file *file = &golden->file[TS_B_image_srgb];
	if (file->data == NULL) return NULL;
	*height = (u32)file->npy.shape[0];
	*width = (u32)file->npy.shape[1];
	return (const u8 *)file->data + file->npy.data_at;
}

bool ts_golden_is_constant(const ts_golden *golden)
{
	u32 width, height;
	const u8 *pixel = ts_golden_image(golden, &width, &height);
	for (u64 i = 1; pixel != NULL && i < (u64)width * height; i++) {
		if (memcmp(pixel, pixel + 3 * i, 3) != 0) return false;
	}
	return true;
}
