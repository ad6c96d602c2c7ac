/* Sizes, shapes, floats and indices of loaded buffers. */
#include "check.h"
#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include "../methods/stages.h"
#include "../trace/emit.h"
#include "../trace/field.h"

enum { DIMS_TEXT = TS_MAX_DIMS * 24 };

ts_status ts_check_refuse(const ts_load *load, ts_buffer_id id, u64 element, const char *field, u32 component,
                          const char *right, ...)
{
	const ts_fields fields = ts_fields_of(id);
	char name[64], value[TS_VALUE_TEXT], would[160];
	u32 f = 0;
	while (f + 1 < fields.n && strcmp(fields.field[f].name, field) != 0) f++;
	assert(strcmp(fields.field[f].name, field) == 0);
	const u8 *data = ts_frame_data(&load->run.frame, id);
	data += element * ts_buffer_table[id].element_bytes;
	ts_field_name(name, &fields.field[f], component);
	ts_field_show(value, &fields.field[f], ts_field_bits(&fields.field[f], data, component));
	va_list arguments;
	va_start(arguments, right);
	vsnprintf(would, sizeof would, right, arguments);
	va_end(arguments);
	return ts_fail("%s: element %" PRIu64 "%s%s: %s; %s would be right", load->item[id]->path, element,
	               name[0] != 0 ? ", field " : "", name, value, would);
}

/* Buffers from which sizes are taken, most trusted first. */
typedef enum { FROM_SCENE, FROM_LOADED, FROM_ALL, N_FROM } source;

static bool is_from(const ts_load *load, ts_buffer_id id, source from)
{
	return from == FROM_SCENE ? ts_emit_is_scene(id) : from == FROM_LOADED ? load->item[id] != NULL : true;
}

/* Sizes that are the first dimensions of buffers, loaded or not, that the stage does not make. */
static void count(ts_load *load, const ts_stage *stage)
{
	for (source from = FROM_SCENE; from < N_FROM; from++) {
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			const ts_trace_item *item = ts_load_item(load->reference, load->candidate, (ts_buffer_id)id);
			ts_dim of = ts_buffer_tells((ts_buffer_id)id);
			bool made = ts_stage_writes(stage, (ts_buffer_id)id), turn = is_from(load, (ts_buffer_id)id, from);
			if (item == NULL || of == TS_DIM_none || made || !turn) continue;
			if (load->sizes.n[of] == TS_UNKNOWN) load->sizes.n[of] = item->npy.shape[0];
		}
	}
}

static u32 size_or(u64 size, u32 otherwise) { return size != TS_UNKNOWN ? (u32)size : otherwise; }

void ts_check_sizes(ts_load *load, const ts_stage *stage)
{
	u64 *n = load->sizes.n;
	ts_sizes_clear(&load->sizes);
	if (load->item[TS_B_scene_info] != NULL) n[TS_DIM_reflectors] = load->scene.info.n_reflectors;
	count(load, stage);
	ts_counts counts = {.reflectors = load->scene.info.n_reflectors,
	                    .lights = size_or(n[TS_DIM_lights], load->scene.n_lights),
	                    .cubes = size_or(n[TS_DIM_cubes], TS_NONE), .views = size_or(n[TS_DIM_views], TS_NONE),
	                    .lamps = size_or(n[TS_DIM_lamps], TS_NONE)};
	bool faces = n[TS_DIM_cubes] != TS_UNKNOWN && n[TS_DIM_views] == TS_UNKNOWN;
	if (faces) ts_sizes_cubes(&load->sizes, n[TS_DIM_cubes]);
	ts_pipeline_plan(load->pipeline, &load->run, &counts, NULL);
}

/* Sizes that are computed; texels from the cubes or views that were loaded, which are right. */
static void compute_sizes(ts_load *load)
{
	u64 *n = load->sizes.n;
	bool cubes = load->item[TS_B_resize_face] != NULL, views = load->item[TS_B_offscreen_view] != NULL;
	if (cubes || views) n[TS_DIM_texels] = TS_UNKNOWN;
	if (cubes) n[TS_DIM_mip_texels] = TS_UNKNOWN;
	ts_sizes_give(&load->sizes, &load->run);
	load->run.sizes = load->sizes;
}

static void print_dims(char text[DIMS_TEXT], u32 n, const u64 *dims)
{
	size_t used = 0;
	for (u32 i = 0; i < n; i++) {
		used += (size_t)snprintf(text + used, DIMS_TEXT - used, "%s%" PRIu64, i > 0 ? " x " : "", dims[i]);
	}
}

static ts_status check_shape(const ts_load *load, ts_buffer_id id)
{
	u64 dims[TS_MAX_DIMS];
	char found[DIMS_TEXT], right[DIMS_TEXT];
	const ts_npy *npy = &load->item[id]->npy;
	const ts_buffer_info *info = &ts_buffer_table[id];
	const ts_shape *shape = ts_buffer_shape(id);
	if (!ts_shape_dims(shape, &load->sizes, dims)) {
		return ts_fail("%s: the trace does not tell the sizes of its shape, %s", load->item[id]->path, info->shape);
	}
	if (shape->n == npy->n_dims && memcmp(dims, npy->shape, shape->n * sizeof *dims) == 0) return TS_OK;
	print_dims(found, npy->n_dims, npy->shape);
	print_dims(right, shape->n, dims);
	return ts_fail("%s: shape %s; %s of shape %s is %s with the other buffers and parameters of the trace",
	               load->item[id]->path, found, info->name, info->shape, right);
}

static ts_status check_floats(const ts_load *load, ts_buffer_id id)
{
	const ts_fields fields = ts_fields_of(id);
	const u8 *data = ts_frame_data(&load->run.frame, id);
	u64 n = ts_frame_n(&load->run.frame, id);
	size_t bytes = ts_buffer_table[id].element_bytes;
	for (u32 f = 0; f < fields.n; f++) {
		if (fields.field[f].kind != 'f') continue;
		for (u64 i = 0; i < n; i++) {
			for (u32 k = 0; k < fields.field[f].count; k++) {
				u32 value;
				memcpy(&value, data + i * bytes + fields.field[f].offset + k * sizeof value, sizeof value);
				if ((value & 0x7f800000u) != 0x7f800000u) continue;
				return ts_check_refuse(load, id, i, fields.field[f].name, k, "a finite number");
			}
		}
	}
	return TS_OK;
}

static ts_status refuse_index(const ts_load *load, const ts_index_info *index, u64 element, u32 component, u64 size)
{
	const char *none = !index->none                                        ? ""
	                   : strcmp(index->field, "") != 0                     ? ", or 4294967295 for none,"
	                   : ts_buffer_table[index->buffer].element_bytes == 8 ? " in the low half, or all ones,"
	                                                                       : ", or 4294967295 for none,";
	return ts_check_refuse(load, index->buffer, element, index->field, component, "less than %" PRIu64 " (%s)%s", size,
	                       index->size, none);
}

static ts_status check_keys(const ts_load *load, const ts_index_info *index, u64 size)
{
	const u64 *keys = ts_frame_data(&load->run.frame, index->buffer);
	u64 n = ts_frame_n(&load->run.frame, index->buffer);
	for (u64 i = 0; i < n; i++) {
		bool empty = index->none && keys[i] == TS_EMPTY;
		if (!empty && (keys[i] & TS_NONE) >= size) return refuse_index(load, index, i, 0, size);
	}
	return TS_OK;
}

static ts_status check_index(const ts_load *load, const ts_index_info *index)
{
	u32 f = 0;
	ts_buffer_id id = index->buffer;
	const ts_fields fields = ts_fields_of(id);
	u64 size = ts_axis_size(&index->of, &load->sizes);
	if (load->item[id] == NULL || size == TS_UNKNOWN) return TS_OK;
	while (f + 1 < fields.n && strcmp(fields.field[f].name, index->field) != 0) f++;
	assert(strcmp(fields.field[f].name, index->field) == 0);
	if (fields.field[f].bytes == 8) return check_keys(load, index, size);
	const u8 *data = (const u8 *)ts_frame_data(&load->run.frame, id) + fields.field[f].offset;
	for (u64 i = 0, n = ts_frame_n(&load->run.frame, id); i < n; i++) {
		for (u32 k = 0; k < fields.field[f].count; k++) {
			u32 value;
			memcpy(&value, data + i * ts_buffer_table[id].element_bytes + k * sizeof value, sizeof value);
			bool none = index->none && value == TS_NONE;
			if (!none && value >= size) return refuse_index(load, index, i, k, size);
		}
	}
	return TS_OK;
}

static ts_status check_indices(const ts_load *load)
{
	size_t n;
	const ts_index_info *indices = ts_index_table(&n);
	for (size_t row = 0; row < n; row++) {
		if (check_index(load, &indices[row]) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Of methods that have one. */
static ts_status check_grid(const ts_load *load)
{
	bool any = ts_pipeline_maker(load->pipeline, TS_B_nearest_depth) != NULL;
	return any ? ts_grid_check(&load->run.params) : TS_OK;
}

ts_status ts_check(ts_load *load, const ts_stage *stage)
{
	if (check_grid(load) != TS_OK) return TS_ERROR;
	ts_check_sizes(load, stage);
	if (ts_check_faces(load) != TS_OK || ts_check_views(load) != TS_OK) return TS_ERROR;
	compute_sizes(load);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (load->item[id] == NULL) continue;
		if (check_shape(load, (ts_buffer_id)id) != TS_OK || check_floats(load, (ts_buffer_id)id) != TS_OK)
			return TS_ERROR;
	}
	return check_indices(load) == TS_OK ? ts_check_values(load, stage) : TS_ERROR;
}
