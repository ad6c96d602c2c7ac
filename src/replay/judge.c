/* Compares files with memory. */
#include "replay/judge.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "trace/item.h"

static bool same_shape(const ts_buffer *ours, const ts_trace_item *item)
{
	const ts_npy *npy = &item->npy;
	u32 skip = item->cropped ? 2 : 0;
	if (npy->n_dims != ours->n_dims) return false;
	if (item->cropped && (ours->n_dims < 2 || item->crop[1] + (u64)item->crop[3] > ours->shape[0] ||
	                      item->crop[0] + (u64)item->crop[2] > ours->shape[1]))
		return false;
	return memcmp(npy->shape + skip, ours->shape + skip, (ours->n_dims - skip) * sizeof *npy->shape) == 0;
}

static void name_shape(char text[TS_VALUE_TEXT], u32 n_dims, const u64 *shape)
{
	FILE *out = fmemopen(text, TS_VALUE_TEXT, "w");
	if (out == NULL) return;
	for (u32 i = 0; i < n_dims; i++) fprintf(out, "%s%" PRIu64, i != 0 ? " x " : "shape ", shape[i]);
	fclose(out);
}

/* Appends to `where`. The reference's file is not wrong if the candidate's inputs give something else. */
static void set_text(ts_judged *judged, const char *where, const char *made, const char *found)
{
	const char *format =
		judged->not_given ? "%sthe candidate's inputs give %s, the reference has %s" : "%s%s is right, %s was found";
	snprintf(judged->text, sizeof judged->text, format, where, made, found);
}

static void name_shapes(ts_judged *judged, const ts_buffer *ours)
{
	char made[TS_VALUE_TEXT] = "", found[TS_VALUE_TEXT] = "";
	name_shape(made, ours->n_dims, ours->shape);
	name_shape(found, judged->item->npy.n_dims, judged->item->npy.shape);
	set_text(judged, "", made, found);
}

static void name_first(ts_judged *judged)
{
	const ts_verdict *v = &judged->verdict;
	char where[TS_WHERE_TEXT], place[sizeof where + 80], name[64], right[TS_VALUE_TEXT], found[TS_VALUE_TEXT];
	(void)ts_difference_where(where, NULL, judged->id, &v->first);
	ts_difference_field(name, judged->id, &v->first);
	ts_difference_show(right, judged->id, &v->first, v->first.ref);
	ts_difference_show(found, judged->id, &v->first, v->first.cand);
	if (v->has_first) {
		snprintf(place, sizeof place, "%s%s%s: ", where, name[0] != 0 ? ", field " : "", name);
		set_text(judged, place, right, found);
	} else if (v->n_missing + v->n_extra == 0) {
		snprintf(judged->text, sizeof judged->text, "element %" PRIu64 ": %s",
		         v->n_ref < v->n_cand ? v->n_ref : v->n_cand,
		         v->n_ref < v->n_cand ? "beside the right ones" : "missing");
	} else {
		snprintf(judged->text, sizeof judged->text, "%" PRIu64 " records missing, %" PRIu64 " beside", v->n_missing,
		         v->n_extra);
	}
}

/* Our elements within a cropped file; to be released by free(). */
static void *crop_of(const ts_buffer *ours, const u32 crop[4], size_t element_bytes)
{
	u64 pixel = ours->n / (ours->shape[0] * ours->shape[1]) * element_bytes, row = crop[2] * pixel;
	u8 *part = ts_alloc(crop[3], (size_t)row, "a crop");
	for (u64 y = 0; part != NULL && y < crop[3]; y++) {
		memcpy(part + y * row, (const u8 *)ours->data + ((crop[1] + y) * ours->shape[1] + crop[0]) * pixel,
		       (size_t)row);
	}
	return part;
}

/* A buffer of the run as an item of a trace. */
static void put_item(ts_trace_item *item, const ts_buffer *ours, ts_buffer_id id)
{
	*item = (ts_trace_item){.path = (char *)(uintptr_t)ts_buffer_table[id].name,
	                        .memory = ours->data,
	                        .npy = {.n_dims = ours->n_dims, .n = ours->n}};
	memcpy(item->npy.shape, ours->shape, sizeof item->npy.shape);
}

/* The number of elements may differ if the stage itself counts them; they are compared all the same. */
static bool can_match(const ts_buffer *ours, const ts_trace_item *item, ts_buffer_id id)
{
	ts_trace_item right;
	put_item(&right, ours, id);
	return same_shape(ours, item) || (ours->n_dims == item->npy.n_dims && ts_item_match(id, &right, item) == TS_OK);
}

/* The stage's inputs replace the reference's, so that they name places. */
static void put_inputs(ts_trace *right, const ts_load *load)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (load->item[id] != NULL) right->item[id] = *load->item[id];
	}
}

/* Judges against `right`, a trace whose buffers of this stage are the run's. */
static ts_status judge_by(ts_judged *judged, ts_trace *right, const ts_load *load, const ts_trace *owner,
                          const ts_relaxations *relaxations)
{
	ts_order order = {.given = false};
	ts_status status = TS_OK;
	ts_buffer_id id = judged->id, key = ts_order_key_of(id);
	void *crop = NULL;
	put_inputs(right, load);
	put_item(&right->item[id], &load->run.frame.buffer[id], id);
	if (key != TS_N_BUFFERS) {
		put_item(&right->item[key], &load->run.frame.buffer[key], key);
		status = ts_order_make(&order, key, right, owner);
	}
	if (judged->item->cropped) {
		crop = crop_of(&load->run.frame.buffer[id], judged->item->crop, ts_buffer_table[id].element_bytes);
		right->item[id].memory = crop;
		right->item[id].npy = judged->item->npy;
		memcpy(right->item[id].crop, judged->item->crop, sizeof judged->item->crop);
		status = crop != NULL ? status : TS_ERROR;
	}
	if (status == TS_OK) status = ts_compare_buffer(&judged->verdict, id, right, owner, &order, relaxations);
	ts_order_free(&order);
	free(crop);
	return status;
}

ts_status ts_judge(ts_judged *judged, const ts_load *load, ts_buffer_id id, const ts_relaxations *relaxations)
{
	const ts_relaxations none = {.ulp = 0};
	const ts_buffer *ours = &load->run.frame.buffer[id];
	*judged = (ts_judged){.id = id,
	                      .item = ts_load_item(load->reference, load->candidate, id),
	                      .verdict = {.list = judged->verdict.list}};
	if (judged->item == NULL) return TS_OK;
	const ts_trace *candidate = load->candidate;
	judged->not_given = candidate != NULL && judged->item != &candidate->item[id];
	judged->shape_differs = !can_match(ours, judged->item, id);
	if (judged->shape_differs) {
		judged->verdict.judgement = TS_UNLIKE;
		judged->verdict.n_ref = ours->n;
		judged->verdict.n_cand = judged->item->npy.n;
		name_shapes(judged, ours);
		return TS_DIFFERENT;
	}
	const ts_trace *owner = candidate != NULL && !judged->not_given ? candidate : load->reference;
	ts_trace *right = ts_alloc(1, sizeof *right, "a trace");
	if (right == NULL) return TS_ERROR;
	*right = *load->reference;
	right->arrival = false;
	ts_status status = judge_by(judged, right, load, owner, relaxations != NULL ? relaxations : &none);
	free(right);
	if (status != TS_OK || judged->verdict.judgement == TS_SAME) return status;
	name_first(judged);
	return TS_DIFFERENT;
}
