/* Sizes, shapes, floats, indices and sums of loaded buffers, the families' checks, and outputs that a stage makes
 * again. */
#include "replay/check.h"
#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include "kernels/base/num.h"
#include "trace/emitted/emit.h"
#include "trace/field.h"

enum { DIMS_TEXT = TS_MAX_DIMS * 24, MAX_UNITS = 1 << 20 };

static const ts_check_rule *const *lists;

void ts_check_use(const ts_check_rule *const *rules) { lists = rules; }

const void *ts_check_elements(const ts_load *load, ts_buffer_id id, u64 *n)
{
	*n = load->item[id] != NULL ? ts_frame_n(&load->run.frame, id) : 0;
	return load->item[id] != NULL ? ts_frame_data(&load->run.frame, id) : NULL;
}

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
	return ts_refuse("%s: element %" PRIu64 "%s%s: %s; %s would be right", load->item[id]->path, element,
	                 name[0] != 0 ? ", field " : "", name, value, would);
}

/* Sources of sizes, most trusted first. */
typedef enum { FROM_SCENE, FROM_LOADED, FROM_ALL, N_FROM } source;

static bool is_from(const ts_load *load, ts_buffer_id id, source from)
{
	return from == FROM_SCENE ? ts_emit_is_scene(id) : from == FROM_LOADED ? load->item[id] != NULL : true;
}

/* Sizes from first dimensions of buffers, loaded or not, that the stage does not write. */
static void count(ts_load *load, const ts_stage *stage)
{
	for (source from = FROM_SCENE; from < N_FROM; from++) {
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			const ts_trace_item *item = ts_load_item(load->reference, load->candidate, (ts_buffer_id)id);
			ts_dim of = ts_buffer_gives((ts_buffer_id)id);
			bool made = ts_stage_writes(stage, (ts_buffer_id)id), turn = is_from(load, (ts_buffer_id)id, from);
			if (item == NULL || of == TS_DIM_none || made || !turn) continue;
			if (load->sizes.n[of] == TS_UNKNOWN) load->sizes.n[of] = item->npy.shape[0];
		}
	}
}

static u32 size_or(u64 size, u32 otherwise) { return size != TS_UNKNOWN ? (u32)size : otherwise; }

/* A size that is no buffer's first dimension: the last element of its prefix sums. */
static void count_sums(ts_load *load, const ts_stage *stage)
{
	size_t n_sums;
	const ts_sum_info *sums = ts_sum_table(&n_sums);
	for (size_t row = 0; row < n_sums; row++) {
		ts_buffer_id id = sums[row].buffer;
		ts_dim size = sums[row].size;
		if (size == TS_DIM_none || load->item[id] == NULL || ts_stage_writes(stage, id)) continue;
		u64 n = ts_frame_n(&load->run.frame, id);
		if (n == 0 || load->sizes.n[size] != TS_UNKNOWN) continue;
		load->sizes.n[size] = ((const u32 *)ts_frame_data(&load->run.frame, id))[n - 1];
	}
}

/* Finds sizes from buffers other than the stage's outputs, and the plan that follows. */
static void check_sizes(ts_load *load, const ts_stage *stage)
{
	u64 *n = load->sizes.n;
	ts_sizes_clear(&load->sizes);
	if (load->item[TS_B_scene_info] != NULL) n[TS_DIM_reflectors] = load->scene.info.n_reflectors;
	count(load, stage);
	count_sums(load, stage);
	ts_counts counts = {.reflectors = load->scene.info.n_reflectors,
	                    .lights = size_or(n[TS_DIM_lights], load->scene.n_lights),
	                    .cubes = size_or(n[TS_DIM_cubes], TS_NONE),
	                    .views = size_or(n[TS_DIM_views], TS_NONE),
	                    .lamps = size_or(n[TS_DIM_lamps], TS_NONE)};
	bool faces = n[TS_DIM_cubes] != TS_UNKNOWN && n[TS_DIM_views] == TS_UNKNOWN;
	if (faces) ts_sizes_cubes(&load->sizes, n[TS_DIM_cubes]);
	ts_pipeline_plan(load->pipeline, &load->run, &counts, NULL);
}

/* Computed sizes; texels from the loaded cubes or views, which have been checked. */
static void compute_sizes(ts_load *load)
{
	u64 *n = load->sizes.n;
	bool cubes = load->item[TS_B_cube_size_face] != NULL, views = load->item[TS_B_offscreen_view] != NULL;
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
		return ts_refuse("%s: the trace does not tell the sizes of its shape, %s", load->item[id]->path, info->shape);
	}
	if (shape->n == npy->n_dims && memcmp(dims, npy->shape, shape->n * sizeof *dims) == 0) return TS_OK;
	print_dims(found, npy->n_dims, npy->shape);
	print_dims(right, shape->n, dims);
	return ts_refuse("%s: shape %s; %s of shape %s is %s with the other buffers and parameters of the trace",
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

static ts_status check_sum(const ts_load *load, const ts_sum_info *sum)
{
	u64 n, total = sum->size != TS_DIM_none ? load->sizes.n[sum->size] : TS_UNKNOWN;
	ts_buffer_id id = sum->buffer;
	const u32 *offset = ts_check_elements(load, id, &n);
	if (n != 0 && offset[0] != 0) return ts_check_refuse(load, id, 0, "", 0, "0, where sums begin,");
	for (u64 i = 1; i < n; i++) {
		if (offset[i] < offset[i - 1]) {
			return ts_check_refuse(load, id, i, "", 0, "at least %" PRIu32 ", the sum before it,", offset[i - 1]);
		}
	}
	if (n == 0 || total == TS_UNKNOWN || offset[n - 1] == total) return TS_OK;
	return ts_check_refuse(load, id, n - 1, "", 0, "%" PRIu64 " (%s), where sums end,", total,
	                       ts_dim_table[sum->size].name);
}

static bool has_own_sums(ts_buffer_id id)
{
	for (const ts_check_rule *const *list = lists; *list != NULL; list++) {
		for (const ts_check_rule *rule = *list; rule->check != NULL; rule++) {
			if (rule->buffer == id && rule->time == TS_CHECK_SUMS) return true;
		}
	}
	return false;
}

static ts_status check_sums(const ts_load *load)
{
	size_t n;
	const ts_sum_info *sums = ts_sum_table(&n);
	for (size_t row = 0; row < n; row++) {
		if (!has_own_sums(sums[row].buffer) && check_sum(load, &sums[row]) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static bool applies(const ts_load *load, const ts_check_rule *rule, ts_check_time time)
{
	if ((rule->time == TS_CHECK_SUMS ? TS_CHECK_VALUES : rule->time) != time) return false;
	if (time == TS_CHECK_PARAMS) return ts_pipeline_maker(load->pipeline, rule->buffer) != NULL;
	return load->item[rule->buffer] != NULL;
}

static ts_status check_by(const ts_check_rule *rule, const ts_load *load, const ts_stage *stage, ts_check_time time)
{
	for (; rule->check != NULL; rule++) {
		if (applies(load, rule, time) && rule->check(load, stage, rule->buffer) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static ts_status check_rules(const ts_load *load, const ts_stage *stage, ts_check_time time)
{
	assert(lists != NULL);
	if (check_by(ts_check_scene, load, stage, time) != TS_OK) return TS_ERROR;
	for (const ts_check_rule *const *list = lists; *list != NULL; list++) {
		if (check_by(*list, load, stage, time) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

static ts_status check_units(const ts_load *load)
{
	if (load->scene.info.n_reflectors > MAX_UNITS) {
		return ts_refuse("%s: %" PRIu32 " reflectors; at most %d would be right", load->reference->dir,
		                 load->scene.info.n_reflectors, MAX_UNITS);
	}
	if (load->run.plan.units <= MAX_UNITS) return TS_OK;
	return ts_refuse("%s: %" PRIu32 " cubes or views; at most %d would be right", load->reference->dir,
	                 load->run.plan.units, MAX_UNITS);
}

ts_status ts_check(ts_load *load, const ts_stage *stage)
{
	if (check_rules(load, stage, TS_CHECK_PARAMS) != TS_OK) return TS_ERROR;
	check_sizes(load, stage);
	if (check_rules(load, stage, TS_CHECK_SIZES) != TS_OK) return TS_ERROR;
	compute_sizes(load);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (load->item[id] == NULL) continue;
		if (check_shape(load, (ts_buffer_id)id) != TS_OK || check_floats(load, (ts_buffer_id)id) != TS_OK)
			return TS_ERROR;
	}
	if (check_indices(load) != TS_OK || check_units(load) != TS_OK || check_sums(load) != TS_OK) return TS_ERROR;
	return check_rules(load, stage, TS_CHECK_VALUES);
}

static ts_status compare(const ts_load *load, const ts_frame *right, ts_buffer_id id, const char *maker,
                         const char *from)
{
	size_t bytes = ts_buffer_table[id].element_bytes;
	const u8 *a = ts_frame_data(&load->run.frame, id), *b = ts_frame_data(right, id);
	for (u64 i = 0, n = ts_frame_n(right, id); i < n; i++) {
		if (memcmp(a + i * bytes, b + i * bytes, bytes) == 0) continue;
		u64 value = 0;
		memcpy(&value, b + i * bytes, bytes);
		return ts_check_refuse(load, id, i, "", 0, "%" PRIu64 ", which stage %s makes of the same %s,", value, maker,
		                       from);
	}
	return TS_OK;
}

ts_status ts_check_again(const ts_load *load, const char *maker, const char *from)
{
	const ts_stage *stage = ts_stage_find(maker);
	ts_run again = load->run;
	again.hook = NULL;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		again.frame.buffer[*id] = (ts_buffer){.made = false};
	}
	ts_status status = ts_run_stage(&again, stage);
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (status == TS_OK && load->item[*id] != NULL) status = compare(load, &again.frame, *id, maker, from);
		ts_frame_drop(&again.frame, *id);
	}
	return status;
}
