/* Sorting a candidate's keys, and meeting them with the reference's. 16 bytes a record at most. */
#include "order.h"
#include "../kernels/scene.h"
#include <inttypes.h>
#include <stdlib.h>
#include "reader.h"

/* Without padding: 12 bytes. */
typedef struct { u32 high, low, index; } entry;

static int by_key(const void *a, const void *b)
{
	const entry *x = a, *y = b;
	if (x->high != y->high) return x->high < y->high ? -1 : 1;
	if (x->low != y->low) return x->low < y->low ? -1 : 1;
	return x->index < y->index ? -1 : x->index > y->index;
}

static u64 key_of(const entry *e) { return (u64)e->high << 32 | e->low; }

static ts_reader *open_keys(const ts_trace *trace)
{
	const ts_trace_item *item = &trace->item[TS_B_points_key];
	return ts_reader_open(item->path, item->npy.data_at, item->npy.n, sizeof(u64));
}

static entry *sorted_keys(const ts_trace *trace)
{
	u64 n = trace->item[TS_B_points_key].npy.n, held = 0;
	entry *entries = ts_alloc((size_t)n, sizeof *entries, "keys of points");
	ts_reader *reader = entries != NULL ? open_keys(trace) : NULL;
	for (u64 i = 0; reader != NULL && i < n; i += held) {
		const u64 *keys = ts_reader_at(reader, i, &held);
		if (keys == NULL) {
			ts_reader_close(reader);
			reader = NULL;
			break;
		}
		for (u64 k = 0; k < held; k++) entries[i + k] = (entry){(u32)(keys[k] >> 32), (u32)keys[k], (u32)(i + k)};
	}
	if (reader == NULL) {
		free(entries);
		return NULL;
	}
	ts_reader_close(reader);
	qsort(entries, (size_t)n, sizeof *entries, by_key);
	return entries;
}

static void count_extra(ts_order *order, u64 key, bool twice)
{
	order->n_twice += twice;
	if (order->n_extra++ == 0) order->extra = key;
}

/* Passes the candidate's keys below `key`. */
static void skip_below(ts_order *order, const entry *entries, u64 *at, u64 key)
{
	for (; *at < order->n_cand && key_of(&entries[*at]) < key; (*at)++) {
		bool twice = *at > 0 && key_of(&entries[*at - 1]) == key_of(&entries[*at]);
		count_extra(order, key_of(&entries[*at]), twice);
	}
}

static ts_status meet(ts_order *order, const ts_trace *reference, const entry *entries)
{
	u64 held = 0, at = 0, before = 0;
	ts_reader *reader = open_keys(reference);
	if (reader == NULL) return TS_ERROR;
	for (u64 i = 0; i < order->n_ref; i += held) {
		const u64 *keys = ts_reader_at(reader, i, &held);
		for (u64 k = 0; keys != NULL && k < held; k++) {
			bool ascends = i + k == 0 || keys[k] > before;
			before = keys[k];
			skip_below(order, entries, &at, before);
			bool met = ascends && at < order->n_cand && key_of(&entries[at]) == before;
			order->cand_of_ref[i + k] = met ? entries[at++].index : TS_NONE;
			if (!met && order->n_missing++ == 0) order->missing = before;
			if (!ascends) held = 0;
		}
		if (keys != NULL && held > 0) continue;
		ts_reader_close(reader);
		return keys == NULL ? TS_ERROR
		                    : ts_fail("%s: keys do not ascend, so it is no reference",
		                              reference->item[TS_B_points_key].path);
	}
	skip_below(order, entries, &at, UINT64_MAX);
	if (at < order->n_cand) count_extra(order, UINT64_MAX, false);
	ts_reader_close(reader);
	return TS_OK;
}

static ts_status reverse(ts_order *order)
{
	order->ref_of_cand = ts_alloc((size_t)order->n_cand, sizeof(u32), "places of points");
	if (order->ref_of_cand == NULL) return TS_ERROR;
	memset(order->ref_of_cand, 0xff, (size_t)order->n_cand * sizeof(u32));
	for (u64 i = 0; i < order->n_ref; i++) {
		if (order->cand_of_ref[i] != TS_NONE) order->ref_of_cand[order->cand_of_ref[i]] = (u32)i;
	}
	return TS_OK;
}

ts_status ts_order_make(ts_order *order, const ts_trace *reference, const ts_trace *candidate)
{
	*order = (ts_order){.given = false};
	const ts_trace_item *ref = &reference->item[TS_B_points_key], *cand = &candidate->item[TS_B_points_key];
	if (!candidate->arrival || ref->path == NULL || cand->path == NULL) return TS_OK;
	order->given = true;
	order->n_ref = ref->npy.n;
	order->n_cand = cand->npy.n;
	if (order->n_ref >= TS_NONE || order->n_cand >= TS_NONE) {
		return ts_fail("%s: more points than 32-bit indices can name", cand->path);
	}
	entry *entries = sorted_keys(candidate);
	if (entries == NULL) return TS_ERROR;
	order->cand_of_ref = ts_alloc((size_t)order->n_ref, sizeof(u32), "places of points");
	ts_status status = order->cand_of_ref != NULL ? meet(order, reference, entries) : TS_ERROR;
	free(entries);
	return status == TS_OK ? reverse(order) : status;
}

void ts_order_free(ts_order *order)
{
	free(order->cand_of_ref);
	free(order->ref_of_cand);
	*order = (ts_order){.given = false};
}

u32 ts_order_map(const ts_order *order, u32 index)
{
	if (!order->given || index >= order->n_cand) return index;
	u32 mapped = order->ref_of_cand[index];
	return mapped != TS_NONE ? mapped : TS_NONE - 1;
}
