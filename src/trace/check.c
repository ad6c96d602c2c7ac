/* Sizes, shapes, floats and indices of loaded buffers. */
#include "check.h"
#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include "../kernels/illuminate.h"
#include "../kernels/samples.h"
#include "../stages/stages.h"
#include "emit.h"
#include "field.h"

static const struct {
	ts_buffer_id id;
	const char *field, *size;
	bool none;
} indices[] = {
#define INDEX(buffer, field, size, none) {TS_B_##buffer, field, size, none},
#include <touchstone/records.def>
};

enum { N_INDICES = sizeof indices / sizeof *indices, DIMS_TEXT = TS_MAX_DIMS * 24 };

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

static const ts_size *find_size(const ts_sizes *sizes, const char *name, size_t length)
{
	for (u32 i = 0; i < sizes->n; i++) {
		const char *known = sizes->size[i].name;
		if (strlen(known) == length && memcmp(known, name, length) == 0) return &sizes->size[i];
	}
	return NULL;
}

/* Names of the sizes that buffers define: the first dimension, where it is a name and nothing else. */
static const char *const defined[] = {"V", "T", "M", "S", "I",  "X",  "L", "O", "A",  "B", "U", "R", "P", "Q",  "N",
                                      "P2", "P3", "C", "C4", "Z", "D", "E", "F", "J", "p", "p2", "s", "f"};

static void define(ts_sizes *sizes, ts_buffer_id id, u64 n)
{
	const char *shape = ts_buffer_table[id].shape;
	size_t length = strcspn(shape, " ");
	if (find_size(sizes, shape, length) != NULL) return;
	for (u32 i = 0; i < sizeof defined / sizeof *defined; i++) {
		if (strlen(defined[i]) == length && memcmp(defined[i], shape, length) == 0) ts_sizes_set(sizes, defined[i], n);
	}
}

static u32 size_or(const ts_sizes *sizes, const char *name, u32 otherwise)
{
	const ts_size *size = find_size(sizes, name, strlen(name));
	return size != NULL ? (u32)size->n : otherwise;
}

void ts_check_sizes(ts_load *load, const ts_stage *stage)
{
	ts_sizes *sizes = &load->sizes;
	ts_sizes_set(sizes, "H", load->run.params.height);
	ts_sizes_set(sizes, "W", load->run.params.width);
	ts_sizes_set(sizes, "G", load->run.params.grid_px);
	ts_sizes_set(sizes, "K", TS_N_SAMPLES);
	ts_sizes_set(sizes, "l", load->run.params.levels + 1);
	ts_sizes_set(sizes, "Y", ts_k_mask_first(load->run.params.levels + 1));
	ts_pyramid pyramid = ts_view_pyramid(&load->run.params);
	ts_sizes_set(sizes, "v", pyramid.n);
	ts_sizes_set(sizes, "m", ts_k_pyramid_texels(&pyramid));
	if (load->item[TS_B_scene_info] != NULL) ts_sizes_set(sizes, "R", load->scene.info.n_reflectors);
	/* The scene, loaded or not; what was loaded; the rest. */
	for (u32 pass = 0; pass < 3; pass++) {
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			const ts_trace_item *item = ts_load_item(load->reference, load->candidate, (ts_buffer_id)id);
			bool turn = pass == 0 ? ts_emit_is_scene((ts_buffer_id)id) : pass == 1 ? load->item[id] != NULL : true;
			bool made = ts_stage_writes(stage, (ts_buffer_id)id);
			if (item != NULL && turn && !made) define(sizes, (ts_buffer_id)id, item->npy.shape[0]);
		}
	}
	load->scene.info.n_reflectors = size_or(sizes, "R", load->scene.info.n_reflectors);
	ts_counts counts = {.reflectors = load->scene.info.n_reflectors, .lights = size_or(sizes, "L", load->scene.n_lights),
	                    .cubes = size_or(sizes, "B", TS_NONE), .views = size_or(sizes, "U", TS_NONE),
	                    .lamps = size_or(sizes, "A", TS_NONE)};
	if (counts.views != TS_NONE) ts_sizes_views(sizes, counts.views);
	else if (counts.cubes != TS_NONE) ts_sizes_cubes(sizes, counts.cubes);
	ts_pipeline_plan(load->pipeline, &load->run, &counts, NULL);
	ts_check_leaves(load);
	ts_check_lists(load);
}

/* Texels of the cubes or views that were loaded, which are right. */
static void count_texels(ts_load *load)
{
	bool cubes = load->item[TS_B_resize_face] != NULL, views = load->item[TS_B_offscreen_view] != NULL;
	u32 units = cubes ? ts_run_n_cubes(&load->run) : views ? (u32)ts_frame_n(&load->run.frame, TS_B_offscreen_view) : 0;
	if (cubes || views) ts_sizes_set(&load->sizes, "C", ts_run_n_texels(&load->run, 0, units));
	if (!cubes) return;
	ts_sizes_set(&load->sizes, "C4", ts_k_mip_first(ts_frame_data(&load->run.frame, TS_B_resize_face), 0, units));
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
	u32 n_dims;
	u64 dims[TS_MAX_DIMS];
	char found[DIMS_TEXT], right[DIMS_TEXT];
	const ts_npy *npy = &load->item[id]->npy;
	const ts_buffer_info *info = &ts_buffer_table[id];
	if (!ts_shape_dims(info->shape, &load->sizes, &n_dims, dims)) {
		return ts_fail("%s: the trace does not tell the sizes of its shape, %s", load->item[id]->path, info->shape);
	}
	if (n_dims == npy->n_dims && memcmp(dims, npy->shape, n_dims * sizeof *dims) == 0) return TS_OK;
	print_dims(found, npy->n_dims, npy->shape);
	print_dims(right, n_dims, dims);
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

static ts_status refuse_index(const ts_load *load, u32 row, u64 element, u32 component, u64 size)
{
	const char *none = !indices[row].none                                    ? ""
	                   : strcmp(indices[row].field, "") != 0                 ? ", or 4294967295 for none,"
	                   : ts_buffer_table[indices[row].id].element_bytes == 8 ? " in the low half, or all ones,"
	                                                                         : ", or 4294967295 for none,";
	return ts_check_refuse(load, indices[row].id, element, indices[row].field, component,
	                       "less than %" PRIu64 " (%s)%s", size, indices[row].size, none);
}

static ts_status check_keys(const ts_load *load, u32 row, u64 size)
{
	const u64 *keys = ts_frame_data(&load->run.frame, indices[row].id);
	u64 n = ts_frame_n(&load->run.frame, indices[row].id);
	for (u64 i = 0; i < n; i++) {
		bool empty = indices[row].none && keys[i] == TS_EMPTY;
		if (!empty && (keys[i] & TS_NONE) >= size) return refuse_index(load, row, i, 0, size);
	}
	return TS_OK;
}

static ts_status check_index(const ts_load *load, u32 row)
{
	u32 n_dims, f = 0;
	u64 size[TS_MAX_DIMS];
	ts_buffer_id id = indices[row].id;
	const ts_fields fields = ts_fields_of(id);
	if (load->item[id] == NULL || !ts_shape_dims(indices[row].size, &load->sizes, &n_dims, size)) return TS_OK;
	while (f + 1 < fields.n && strcmp(fields.field[f].name, indices[row].field) != 0) f++;
	assert(strcmp(fields.field[f].name, indices[row].field) == 0);
	if (fields.field[f].bytes == 8) return check_keys(load, row, size[0]);
	const u8 *data = (const u8 *)ts_frame_data(&load->run.frame, id) + fields.field[f].offset;
	for (u64 i = 0, n = ts_frame_n(&load->run.frame, id); i < n; i++) {
		for (u32 k = 0; k < fields.field[f].count; k++) {
			u32 value;
			memcpy(&value, data + i * ts_buffer_table[id].element_bytes + k * sizeof value, sizeof value);
			bool none = indices[row].none && value == TS_NONE;
			if (!none && value >= size[0]) return refuse_index(load, row, i, k, size[0]);
		}
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
	count_texels(load);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (load->item[id] == NULL) continue;
		if (check_shape(load, (ts_buffer_id)id) != TS_OK || check_floats(load, (ts_buffer_id)id) != TS_OK)
			return TS_ERROR;
	}
	for (u32 row = 0; row < N_INDICES; row++) {
		if (check_index(load, row) != TS_OK) return TS_ERROR;
	}
	return ts_check_values(load, stage);
}
