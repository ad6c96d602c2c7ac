/* Finds a candidate's keys among the reference's. 16 bytes per record at most. */
#include "compare/order.h"
#include <stdlib.h>
#include "kernels/base/num.h"
#include "trace/reader.h"

enum { MOST_SLICES = 1 << 20, AHEAD = 32 };

/* The reference's keys, and where each value of the upper bits begins; slices[n_slices] ends the last. */
typedef struct {
	u64 *keys;
	u32 *slices, n_slices;
	u32 shift;
} key_index;

bool ts_order_is_set(ts_buffer_id id) { return strcmp(ts_buffer_table[id].order, "set") == 0; }

ts_buffer_id ts_order_key_of(ts_buffer_id id)
{
	u32 key = ts_order_is_set(id) ? 0 : TS_N_BUFFERS;
	while (key < TS_N_BUFFERS && strcmp(ts_buffer_table[id].key, ts_buffer_table[key].name) != 0) key++;
	return (ts_buffer_id)key;
}

ts_buffer_id ts_order_key(void)
{
	u32 id = 0;
	while (id < TS_N_BUFFERS && strcmp(ts_buffer_table[id].key, ts_buffer_table[id].name) != 0) id++;
	return (ts_buffer_id)id;
}

ts_dim ts_order_of(void)
{
	ts_buffer_id key = ts_order_key();
	return key != TS_N_BUFFERS ? ts_buffer_counts(key) : TS_DIM_none;
}

bool ts_order_is_of_points(ts_buffer_id id)
{
	const ts_fields fields = ts_fields_of(id);
	if (ts_order_is_set(id) && ts_order_key_of(id) == ts_order_key()) return true;
	for (u32 f = 0; f < fields.n; f++) {
		if (ts_field_names(&fields.field[f], ts_order_of())) return true;
	}
	return false;
}

static ts_status read_keys(u64 *keys, const ts_order *order, const ts_trace *trace)
{
	u64 held = 0, n = order->n_ref;
	ts_reader *reader = ts_trace_read(&trace->item[order->key], order->key);
	if (reader == NULL) return TS_ERROR;
	for (u64 i = 0; i < n; i += held) {
		const u64 *part = ts_reader_at(reader, i, &held);
		if (part == NULL) {
			ts_reader_close(reader);
			return TS_ERROR;
		}
		memcpy(keys + i, part, (size_t)held * sizeof *keys);
	}
	ts_reader_close(reader);
	for (u64 i = 1; i < n; i++) {
		if (keys[i - 1] >= keys[i]) {
			return ts_fail("%s: keys do not ascend, so it is no reference", trace->item[order->key].path);
		}
	}
	return TS_OK;
}

static void make_slices(key_index *index, u64 n)
{
	u64 at = 0, most = n > 0 ? index->keys[n - 1] : 0;
	while (most >> index->shift >= index->n_slices) index->shift++;
	for (u32 s = 0; s <= index->n_slices; s++) {
		while (at < n && index->keys[at] >> index->shift < s) at++;
		index->slices[s] = (u32)at;
	}
}

static void free_index(key_index *index)
{
	free(index->keys);
	free(index->slices);
}

static ts_status make_index(key_index *index, const ts_order *order, const ts_trace *reference)
{
	u64 n = order->n_ref;
	u32 n_slices = n < MOST_SLICES ? (u32)n + 1 : MOST_SLICES;
	*index = (key_index){.keys = ts_alloc((size_t)n, sizeof(u64), "keys of records"),
	                     .n_slices = n_slices,
	                     .slices = ts_alloc((size_t)n_slices + 1, sizeof(u32), "an index of keys")};
	bool there = index->keys != NULL && index->slices != NULL;
	if (!there || read_keys(index->keys, order, reference) != TS_OK) {
		free_index(index);
		return TS_ERROR;
	}
	make_slices(index, n);
	return TS_OK;
}

/* The place of a key, or TS_NONE. */
static u32 find(const key_index *index, u64 key)
{
	u64 slice = key >> index->shift;
	if (slice >= index->n_slices) return TS_NONE;
	u32 low = index->slices[slice], end = index->slices[slice + 1], high = end;
	while (low < high) {
		u32 middle = low + (high - low) / 2;
		if (index->keys[middle] < key) {
			low = middle + 1;
		} else {
			high = middle;
		}
	}
	return low < end && index->keys[low] == key ? low : TS_NONE;
}

/* Prefetches what later keys need. */
static void fetch_ahead(const key_index *index, const u32 *cand_of_ref, const u64 *keys, u64 n)
{
	u64 far = n > AHEAD ? keys[AHEAD] >> index->shift : 0, near = n > AHEAD / 2 ? keys[AHEAD / 2] >> index->shift : 0;
	if (far < index->n_slices) __builtin_prefetch(&index->slices[far]);
	if (near >= index->n_slices) return;
	__builtin_prefetch(&index->keys[index->slices[near]]);
	__builtin_prefetch(&cand_of_ref[index->slices[near]]);
}

static ts_status meet(ts_order *order, const key_index *index, const ts_trace *candidate, bool *ascend)
{
	u64 held = 0, before = 0;
	ts_reader *reader = ts_trace_read(&candidate->item[order->key], order->key);
	if (reader == NULL) return TS_ERROR;
	for (u64 i = 0; i < order->n_cand; i += held) {
		const u64 *keys = ts_reader_at(reader, i, &held);
		if (keys == NULL) {
			ts_reader_close(reader);
			return TS_ERROR;
		}
		for (u64 k = 0; k < held; k++) {
			fetch_ahead(index, order->cand_of_ref, keys + k, held - k);
			u32 place = find(index, keys[k]);
			bool twice = place != TS_NONE && order->cand_of_ref[place] != TS_NONE;
			bool met = place != TS_NONE && !twice;
			order->ref_of_cand[i + k] = twice ? TS_NO_PARTNER : place;
			order->n_extra += !met;
			if (met) order->cand_of_ref[place] = (u32)(i + k);
			*ascend &= keys[k] >= before;
			before = keys[k];
		}
	}
	ts_reader_close(reader);
	for (u64 i = 0; i < order->n_ref; i++) order->n_missing += order->cand_of_ref[i] == TS_NONE;
	return TS_OK;
}

static ts_status find_order(ts_order *order, const ts_trace *reference, const ts_trace *candidate)
{
	key_index index;
	bool ascend = true;
	if (make_index(&index, order, reference) != TS_OK) return TS_ERROR;
	order->cand_of_ref = ts_alloc((size_t)order->n_ref, sizeof(u32), "places of records");
	order->ref_of_cand = ts_alloc((size_t)order->n_cand, sizeof(u32), "places of records");
	ts_status status = order->cand_of_ref != NULL && order->ref_of_cand != NULL ? TS_OK : TS_ERROR;
	if (status == TS_OK) {
		memset(order->cand_of_ref, 0xff, (size_t)order->n_ref * sizeof(u32));
		status = meet(order, &index, candidate, &ascend);
	}
	free_index(&index);
	if (!candidate->arrival && !ascend) ts_order_free(order);
	return status;
}

ts_status ts_order_make(ts_order *order, ts_buffer_id key, const ts_trace *reference, const ts_trace *candidate)
{
	*order = (ts_order){.key = key};
	if (key == TS_N_BUFFERS || (key == ts_order_key() && !candidate->arrival)) return TS_OK;
	const ts_trace_item *ref = &reference->item[key], *cand = &candidate->item[key];
	if (ref->path == NULL || cand->path == NULL) return TS_OK;
	order->given = true;
	order->n_ref = ref->npy.n;
	order->n_cand = cand->npy.n;
	if (order->n_ref < TS_NONE && order->n_cand < TS_NONE) return find_order(order, reference, candidate);
	return ts_fail("%s: more records than 32-bit indices can name", cand->path);
}

void ts_order_free(ts_order *order)
{
	free(order->cand_of_ref);
	free(order->ref_of_cand);
	*order = (ts_order){.key = order->key};
}

/* Inserts a difference among those from `first` on, whose keys ascend; the last one may drop out. */
static void insert(ts_differences *list, u32 first, const ts_difference *d, const ts_trace *reference, ts_buffer_id id)
{
	if (list->n == list->most && list->items[list->n - 1].difference.cand <= d->cand) return;
	list->n -= list->n == list->most;
	(void)ts_differences_add(list, reference, id, d); /* moved to its place below */
	for (u32 at = list->n - 1; at > first && list->items[at - 1].difference.cand > d->cand; at--) {
		ts_named greater = list->items[at - 1];
		list->items[at - 1] = list->items[at];
		list->items[at] = greater;
	}
}

static ts_status list_extra(ts_differences *list, const ts_order *order, ts_buffer_id id, const ts_trace *reference,
                            const ts_trace *candidate)
{
	u64 held = 0;
	u32 first = list->n;
	ts_reader *reader = ts_trace_read(&candidate->item[order->key], order->key);
	if (reader == NULL) return TS_ERROR;
	for (u64 i = 0; i < order->n_cand; i += held) {
		const u64 *keys = ts_reader_at(reader, i, &held);
		if (keys == NULL) {
			ts_reader_close(reader);
			return TS_ERROR;
		}
		for (u64 k = 0; k < held; k++) {
			bool twice = order->ref_of_cand[i + k] == TS_NO_PARTNER;
			if (!twice && order->ref_of_cand[i + k] != TS_NONE) continue;
			const ts_difference d = {.how = twice ? TS_TWICE : TS_BESIDE, .element = i + k, .cand = keys[k]};
			insert(list, first, &d, reference, id);
		}
	}
	ts_reader_close(reader);
	return TS_OK;
}

ts_status ts_order_unmet(ts_differences *list, const ts_order *order, ts_buffer_id id, const ts_trace *reference,
                         const ts_trace *candidate)
{
	for (u64 i = 0; i < order->n_ref && list->n < list->most; i++) {
		const ts_difference d = {.how = TS_LACKED, .element = i};
		if (order->cand_of_ref[i] != TS_NONE) continue;
		if (ts_differences_add(list, reference, id, &d) != TS_OK) return TS_ERROR;
	}
	bool more = order->n_extra > 0 && list->n < list->most;
	return more ? list_extra(list, order, id, reference, candidate) : TS_OK;
}

u32 ts_order_map(const ts_order *order, u32 index)
{
	if (!order->given) return index;
	u32 mapped = index < order->n_cand ? order->ref_of_cand[index] : index < order->n_ref ? TS_NONE : index;
	return mapped != TS_NONE || index == TS_NONE ? mapped : TS_NO_PARTNER;
}

void ts_order_map_field(const ts_order *order, const ts_field *field, u8 *elements, u64 n, size_t element_bytes)
{
	for (u64 k = 0; k < n * field->count; k++) {
		u8 *at = elements + k / field->count * element_bytes + field->offset + k % field->count * field->bytes;
		u32 index; /* of a 64-bit key the low half: files are little-endian */
		memcpy(&index, at, sizeof index);
		bool empty = field->bytes == 8 ? ts_field_bits(field, at - field->offset, 0) == TS_EMPTY : index == TS_NONE;
		if (!empty) index = ts_order_map(order, index);
		memcpy(at, &index, sizeof index);
	}
}
