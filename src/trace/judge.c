/* Files against memory, through a reader. */
#include "judge.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "reader.h"

typedef struct {
	ts_verdict *verdict;
	const u8 *ours;
	size_t element_bytes;
	ts_reader *theirs;
} judging;

static void note_first(judging *j, const u8 *ours, const u8 *theirs, ts_place place, u64 element)
{
	ts_verdict *v = j->verdict;
	size_t at = place.field.at + place.component * ts_type_bytes(place.field.type);
	place.element = element;
	v->first = place;
	ts_value_print(v->replayed, place.field.type, ours + at);
	ts_value_print(v->found, place.field.type, theirs + at);
	ts_same_print(v->text, &place, "is right", ours, "was found", theirs);
}

/* n elements, from `first` of the file and `at` of ours. */
static ts_status judge_part(judging *j, u64 at, u64 first, u64 n)
{
	ts_verdict *v = j->verdict;
	for (u64 got; n > 0; at += got, first += got, n -= got) {
		ts_place place;
		const u8 *theirs = ts_reader_at(j->theirs, first, &got), *ours = j->ours + at * j->element_bytes;
		if (theirs == NULL) return TS_ERROR;
		got = got < n ? got : n;
		for (u64 i = 0; i < got; i++) {
			const u8 *a = ours + i * j->element_bytes, *b = theirs + i * j->element_bytes;
			if (ts_same_find(&place, v->id, a, b, got - i)) break;
			i += place.element;
			a += place.element * j->element_bytes;
			b += place.element * j->element_bytes;
			if (v->n_different++ == 0) note_first(j, a, b, place, first + i);
		}
		v->n += got;
	}
	return TS_OK;
}

typedef struct {
	u64 key, index;
} keyed;

static int compare_keys(const void *a, const void *b)
{
	const keyed *x = a, *y = b;
	if (x->key != y->key) return x->key < y->key ? -1 : 1;
	return x->index < y->index ? -1 : x->index > y->index;
}

/* The n keys of a file in ascending order, which is the canonical one, and where they stand; by free(), NULL on
 * failure. */
static keyed *sort_keys(const ts_trace_item *keys, u64 n)
{
	keyed *sorted = ts_alloc((size_t)n, sizeof *sorted, "keys of points");
	ts_reader *reader = sorted != NULL ? ts_reader_open(keys->path, keys->npy.data_at, n, sizeof(u64)) : NULL;
	bool good = reader != NULL;
	for (u64 i = 0, got; i < n && good; i += got) {
		const u64 *data = ts_reader_at(reader, i, &got);
		good = data != NULL;
		for (u64 k = 0; good && k < got; k++) sorted[i + k] = (keyed){data[k], i + k};
		if (!good) got = n;
	}
	ts_reader_close(reader);
	if (good) {
		qsort(sorted, (size_t)n, sizeof *sorted, compare_keys);
		return sorted;
	}
	free(sorted);
	return NULL;
}

static ts_status judge_set(judging *j, const ts_trace_item *keys, u64 n)
{
	if (keys->path == NULL || keys->npy.n != n) {
		return ts_fail("%s: points.key must be there too, with as many elements", j->verdict->item->path);
	}
	keyed *sorted = sort_keys(keys, n);
	ts_status status = sorted != NULL ? TS_OK : TS_ERROR;
	for (u64 i = 0; i < n && status == TS_OK; i++) status = judge_part(j, i, sorted[i].index, 1);
	free(sorted);
	return status;
}

static ts_status judge_crop(judging *j, const ts_buffer *ours)
{
	const u32 *crop = j->verdict->item->crop;
	u64 pixel = ours->shape[1] != 0 ? ours->n / (ours->shape[0] * ours->shape[1]) : 0;
	ts_status status = TS_OK;
	for (u64 y = 0; y < crop[3] && status == TS_OK; y++) {
		u64 at = ((crop[1] + y) * ours->shape[1] + crop[0]) * pixel;
		status = judge_part(j, at, y * crop[2] * pixel, crop[2] * pixel);
	}
	return status;
}

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

static void tell_shapes(ts_verdict *v, const ts_buffer *ours)
{
	size_t used = 0;
	const char *first = "shape ";
	for (u32 i = 0; i < ours->n_dims; i++, first = " x ") {
		used += (size_t)snprintf(v->text + used, sizeof v->text - used, "%s%" PRIu64, first, ours->shape[i]);
	}
	for (u32 i = 0; i < v->item->npy.n_dims; i++, first = " x ") {
		used += (size_t)snprintf(v->text + used, sizeof v->text - used, "%s%" PRIu64, i == 0 ? " is right, " : first,
		                         v->item->npy.shape[i]);
	}
	snprintf(v->text + used, sizeof v->text - used, " was found");
}

ts_status ts_judge(ts_verdict *verdict, const ts_load *load, ts_buffer_id id)
{
	const ts_buffer *ours = &load->run.frame.buffer[id];
	const ts_trace *candidate = load->candidate;
	*verdict = (ts_verdict){.id = id, .item = ts_load_item(load->reference, candidate, id)};
	const ts_trace_item *item = verdict->item;
	if (item == NULL) return TS_OK;
	verdict->shape_differs = !same_shape(ours, item);
	if (verdict->shape_differs) {
		tell_shapes(verdict, ours);
		return TS_DIFFERENT;
	}
	judging j = {verdict, ours->data, ts_buffer_table[id].element_bytes,
	             ts_reader_open(item->path, item->npy.data_at, item->npy.n, ts_buffer_table[id].element_bytes)};
	if (j.theirs == NULL) return TS_ERROR;
	const ts_trace *owner = candidate != NULL && item == &candidate->item[id] ? candidate : load->reference;
	bool by_key = owner->arrival && strcmp(ts_buffer_table[id].order, "set") == 0;
	ts_status status = by_key          ? judge_set(&j, &owner->item[TS_B_points_key], item->npy.n)
	                   : item->cropped ? judge_crop(&j, ours)
	                                   : judge_part(&j, 0, 0, ours->n);
	ts_reader_close(j.theirs);
	if (status != TS_OK) return status;
	return verdict->n_different > 0 ? TS_DIFFERENT : TS_OK;
}
