/* From a run's buffers to the parts of files: the dtypes of their headers, and their data. */
#include "trace/emitted/emit.h"
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "model/order.h"

static const struct {
	const char *type, *descr;
} scalars[] = {
	{"f32", "<f4"}, {"i32", "<i4"}, {"u32", "<u4"}, {"u64", "<u8"}, {"u8", "|u1"},
};

static const char *scalar_descr(const char *type)
{
	for (size_t i = 0; i < sizeof scalars / sizeof *scalars; i++) {
		if (strcmp(scalars[i].type, type) == 0) return scalars[i].descr;
	}
	return NULL;
}

static size_t put_field(char *out, size_t room, const ts_field_info *f, bool first)
{
	char count[32] = "";
	if (f->count > 1) snprintf(count, sizeof count, ", (%u,)", (unsigned)f->count);
	int n = snprintf(out, room, "%s('%s', '%s'%s)", first ? "" : ", ", f->name, scalar_descr(f->type), count);
	assert(n > 0 && (size_t)n < room);
	return (size_t)n;
}

void ts_npy_descr(char descr[TS_NPY_DESCR], ts_buffer_id id)
{
	const char *element = ts_buffer_table[id].element, *scalar = scalar_descr(element);
	if (scalar != NULL) {
		snprintf(descr, TS_NPY_DESCR, "'%s'", scalar);
		return;
	}
	size_t n_fields, used = 1;
	const ts_field_info *fields = ts_field_table(&n_fields);
	descr[0] = '[';
	for (size_t i = 0; i < n_fields; i++) {
		if (strcmp(fields[i].record, element) != 0) continue;
		used += put_field(descr + used, TS_NPY_DESCR - used - 2, &fields[i], used == 1);
	}
	memcpy(descr + used, "]", 2);
}

bool ts_emit_is_scene(ts_buffer_id id) { return strncmp(ts_buffer_table[id].name, "scene.", 6) == 0; }

bool ts_emit_is_batched(ts_buffer_id id)
{
	ts_dim dim = ts_buffer_counts(id);
	return dim != TS_DIM_none && ts_dim_table[dim].how == TS_IS_batched;
}

static bool is_whole(const ts_run *run) { return run->n_units == run->plan.units; }

static bool is_last_batch(const ts_run *run) { return run->first_unit + run->n_units == run->plan.units; }

/* Rows of a buffer over all units. */
static u64 all_rows(const ts_run *run, ts_buffer_id id)
{
	ts_sizes sizes = run->sizes;
	ts_sizes_give(&sizes, run);
	return ts_axis_size(&ts_buffer_shape(id)->axis[0], &sizes);
}

/* Where memory and files differ in byte order, a copy is converted. */
static ts_status give(ts_chunk *chunk, ts_take_chunk *take, void *user)
{
	if (TS_LITTLE_ENDIAN) return take(user, chunk);
	void *file = ts_alloc((size_t)chunk->bytes, 1, ts_buffer_table[chunk->id].name);
	if (file == NULL) return TS_ERROR;
	ts_order_reverse(file, chunk->data, chunk->id, chunk->bytes / ts_buffer_table[chunk->id].element_bytes);
	chunk->data = file;
	ts_status status = take(user, chunk);
	free(file);
	return status;
}

static ts_status offer(const ts_run *run, ts_buffer_id id, ts_take_chunk *take, void *user)
{
	const ts_buffer *buffer = &run->frame.buffer[id];
	bool part = ts_emit_is_batched(id) && !is_whole(run);
	if (!part && !is_last_batch(run)) return TS_OK;
	ts_chunk p = {.id = id,
	              .n_dims = buffer->n_dims,
	              .first = !part || run->first_unit == 0,
	              .data = ts_frame_data(&run->frame, id),
	              .bytes = buffer->bytes};
	memcpy(p.shape, buffer->shape, sizeof p.shape);
	if (part) p.shape[0] = all_rows(run, id);
	return give(&p, take, user);
}

ts_status ts_emit_scene(const ts_run *run, ts_take_chunk *take, void *user)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool made = ts_emit_is_scene((ts_buffer_id)id) && run->frame.buffer[id].made;
		if (made && offer(run, (ts_buffer_id)id, take, user) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

ts_status ts_emit_stage(const ts_run *run, const ts_stage *stage, ts_take_chunk *take, void *user)
{
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		bool made = run->frame.buffer[*id].made;
		if (made && offer(run, *id, take, user) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

const char *ts_emit_maker(const ts_pipeline *pipeline, ts_buffer_id id)
{
	const ts_step *step = ts_pipeline_maker(pipeline, id);
	return step != NULL ? step->stage : "scene";
}

u32 ts_emit_number(const ts_pipeline *pipeline, ts_buffer_id id)
{
	u32 number = 0;
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step++) {
		number += !step->only_margins && !step->unnumbered;
		if (ts_stage_writes(ts_stage_find(step->stage), id)) return number;
	}
	return 0;
}

void ts_emit_order(ts_buffer_id ids[TS_N_BUFFERS], const ts_pipeline *pipeline)
{
	bool listed[TS_N_BUFFERS] = {false};
	u32 n = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		listed[id] = ts_pipeline_maker(pipeline, (ts_buffer_id)id) == NULL;
		if (listed[id]) ids[n++] = (ts_buffer_id)id;
	}
	for (const ts_step *step = ts_pipeline_steps(pipeline); step->stage != NULL; step++) {
		for (const ts_buffer_id *id = ts_stage_outputs(ts_stage_find(step->stage)); *id != TS_N_BUFFERS; id++) {
			if (!listed[*id]) ids[n++] = *id;
			listed[*id] = true;
		}
	}
}

void ts_emit_name(char name[TS_EMIT_NAME], const ts_pipeline *pipeline, ts_buffer_id id)
{
	snprintf(name, TS_EMIT_NAME, "%02u-%s.npy", (unsigned)ts_emit_number(pipeline, id), ts_buffer_table[id].name);
}
