/* Elements of an untrusted trace, one at a time. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "probe/parts.h"
#include "replay/check.h"
#include "replay/replay.h"

/* First dimensions of the buffers; the least where files disagree, so that indices below it are in all of them. */
static void find_sizes(ts_probe *p)
{
	u64 *n = p->sizes.n;
	ts_run run = {.params = p->trace->params, .pipeline = p->trace->pipeline};
	const ts_counts unknown = {TS_NONE, TS_NONE, TS_NONE, TS_NONE, TS_NONE};
	ts_sizes_clear(&p->sizes);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_trace_item *item = &p->trace->item[id];
		ts_dim of = ts_buffer_gives((ts_buffer_id)id);
		if (item->path == NULL || item->cropped || of == TS_DIM_none) continue;
		if (item->npy.shape[0] < n[of]) n[of] = item->npy.shape[0];
	}
	if (n[TS_DIM_cubes] != TS_UNKNOWN && n[TS_DIM_views] == TS_UNKNOWN) ts_sizes_cubes(&p->sizes, n[TS_DIM_cubes]);
	if (p->trace->pipeline->effect->mirrors) n[TS_DIM_reflectors] = n[TS_DIM_cubes];
	ts_plan_make(&run.plan, run.pipeline, &run.params, &unknown, NULL);
	ts_sizes_give(&p->sizes, &run);
}

ts_status ts_probe_open(ts_probe **probe, const ts_trace *trace)
{
	*probe = NULL;
	if (!trace->has_params) {
		return ts_fail("%s: trace.json has no params, and without them nothing can be computed again", trace->dir);
	}
	if (ts_probe_explains(trace) != TS_OK) return TS_ERROR;
	ts_probe *made = ts_alloc_zero(1, sizeof *made, "a probe");
	if (made != NULL) made->trace = ts_alloc(1, sizeof *trace, "a probe");
	if (made == NULL || made->trace == NULL) {
		ts_probe_close(made);
		return TS_ERROR;
	}
	*made->trace = *trace;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) made->fields[id] = ts_fields_of((ts_buffer_id)id);
	find_sizes(made);
	*probe = made;
	return TS_OK;
}

void ts_probe_close(ts_probe *p)
{
	if (p == NULL) return;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_reader_close(p->reader[id]);
		free(p->whole[id]);
	}
	free(p->texels);
	free(p->image_read);
	ts_load_end(p->load);
	free(p->trace);
	free(p);
}

bool ts_probe_makes(const ts_probe *p, ts_buffer_id id) { return ts_pipeline_maker(p->trace->pipeline, id) != NULL; }
bool ts_probe_has(const ts_probe *p, ts_buffer_id id) { return p->trace->item[id].path != NULL; }
u64 ts_probe_n(const ts_probe *p, ts_buffer_id id) { return ts_probe_has(p, id) ? p->trace->item[id].npy.n : 0; }

ts_status ts_probe_require(const ts_probe *p, const ts_buffer_id *ids)
{
	char missing[512] = "";
	size_t used = 0;
	for (; *ids != TS_N_BUFFERS; ids++) {
		if (ts_probe_has(p, *ids) || used + 64 > sizeof missing) continue;
		used += (size_t)snprintf(missing + used, sizeof missing - used, "%s%s", used > 0 ? ", " : "",
		                         ts_buffer_table[*ids].name);
	}
	return used == 0 ? TS_OK
	                 : ts_fail("%s: this needs %s; a trace that was written whole has them", p->trace->dir, missing);
}

static ts_status check_value(const ts_probe *p, ts_buffer_id id, u64 element, const ts_field *field, u64 bits)
{
	const char *path = p->trace->item[id].path, *dot = field->name[0] != 0 ? " field " : "";
	if (field->kind == 'f' && (bits & 0x7f800000u) == 0x7f800000u) {
		return ts_fail("%s: element %" PRIu64 "%s%s is %08" PRIx64 ", not a finite number", path, element, dot,
		               field->name, bits);
	}
	bool none = field->none && (field->bytes == 8 ? bits == UINT64_MAX : bits == TS_NONE);
	u64 index = field->bytes == 8 ? bits & 0xffffffffu : bits;
	u64 size = field->of != NULL ? ts_axis_size(field->of, &p->sizes) : TS_UNKNOWN;
	if (none || index < size || size == TS_UNKNOWN) return TS_OK;
	return ts_fail("%s: element %" PRIu64 "%s%s names %" PRIu64 " of %" PRIu64, path, element, dot, field->name, index,
	               size);
}

static ts_status check(const ts_probe *p, ts_buffer_id id, u64 element, const void *data)
{
	for (u32 f = 0; f < p->fields[id].n; f++) {
		const ts_field *field = &p->fields[id].field[f];
		if (field->kind != 'f' && field->of == NULL) continue;
		for (u32 c = 0; c < field->count; c++) {
			ts_status status = check_value(p, id, element, field, ts_field_bits(field, data, c));
			if (status != TS_OK) return status;
		}
	}
	return TS_OK;
}

static ts_status open_reader(ts_probe *p, ts_buffer_id id)
{
	const ts_trace_item *item = &p->trace->item[id];
	const ts_buffer_id needed[] = {id, TS_N_BUFFERS};
	if (p->reader[id] != NULL) return TS_OK;
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	p->reader[id] = ts_trace_read(item, id);
	return p->reader[id] != NULL ? TS_OK : TS_ERROR;
}

ts_status ts_probe_fetch(ts_probe *p, ts_buffer_id id, u64 first, u64 n, void *to)
{
	const ts_trace_item *item = &p->trace->item[id];
	size_t bytes = ts_buffer_table[id].element_bytes;
	u8 *out = to;
	if (open_reader(p, id) != TS_OK) return TS_ERROR;
	if (first > item->npy.n || n > item->npy.n - first) {
		return ts_fail("%s: element %" PRIu64 " is named and not there; it has %" PRIu64, item->path, first + n - 1,
		               item->npy.n);
	}
	while (n > 0) {
		u64 held;
		const void *from = ts_reader_at(p->reader[id], first, &held);
		if (from == NULL) return TS_ERROR;
		held = held < n ? held : n;
		memcpy(out, from, (size_t)held * bytes);
		for (u64 i = 0; i < held; i++) {
			if (check(p, id, first + i, out + i * bytes) != TS_OK) return TS_ERROR;
		}
		first += held;
		n -= held;
		out += held * bytes;
	}
	return TS_OK;
}

ts_status ts_probe_fetch_pixel(ts_probe *p, ts_buffer_id id, u32 x, u32 y, u32 n, void *to, bool *there)
{
	const ts_trace_item *item = &p->trace->item[id];
	*there = false;
	if (!ts_probe_has(p, id)) return TS_OK;
	u64 width = item->npy.shape[1], height = item->npy.shape[0];
	u64 column = x - (item->cropped ? item->crop[0] : 0), row = y - (item->cropped ? item->crop[1] : 0);
	if (column >= width || row >= height) return TS_OK;
	*there = true;
	return ts_probe_fetch(p, id, (row * width + column) * n, n, to);
}

void *ts_probe_whole(ts_probe *p, ts_buffer_id id)
{
	const ts_buffer_id needed[] = {id, TS_N_BUFFERS};
	if (p->whole[id] != NULL) return p->whole[id];
	if (ts_probe_require(p, needed) != TS_OK) return NULL;
	u64 n = ts_probe_n(p, id);
	void *data = ts_alloc((size_t)n, ts_buffer_table[id].element_bytes, ts_buffer_table[id].name);
	if (data != NULL && n > 0 && ts_probe_fetch(p, id, 0, n, data) != TS_OK) {
		free(data);
		return NULL;
	}
	p->whole[id] = data;
	return data;
}

static bool has_loaded(const ts_probe *p, const ts_buffer_id *ids)
{
	while (*ids != TS_N_BUFFERS && p->load->item[*ids] != NULL) ids++;
	return *ids == TS_N_BUFFERS;
}

ts_status ts_probe_load_for(ts_probe *p, const char *const *stages)
{
	ts_buffer_id reads[TS_N_BUFFERS + 1], all[TS_N_BUFFERS + 1];
	bool wanted[TS_N_BUFFERS] = {[TS_B_eye_view] = true};
	u32 n = 0;
	const ts_stage *last = NULL;
	for (; *stages != NULL; stages++) {
		last = ts_stage_find(*stages);
		ts_replay_reads(reads, last, p->trace->pipeline, &p->trace->params);
		for (u32 i = 0; reads[i] != TS_N_BUFFERS; i++) wanted[reads[i]] = true;
	}
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (wanted[id]) all[n++] = (ts_buffer_id)id;
	}
	all[n] = TS_N_BUFFERS;
	if (p->load != NULL && has_loaded(p, all)) return TS_OK;
	ts_load_end(p->load);
	if (ts_load_begin(&p->load, all, p->trace, NULL, 1) != TS_OK) return TS_ERROR;
	if (ts_check(p->load, last) == TS_OK) return TS_OK;
	ts_load_end(p->load);
	p->load = NULL;
	return TS_ERROR;
}

const void *ts_probe_loaded(const ts_probe *p, ts_buffer_id id) { return ts_frame_data(&p->load->run.frame, id); }
