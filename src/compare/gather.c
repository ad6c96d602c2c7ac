/* A window over the reference's order, filled by one pass over the candidate's file. */
#include <assert.h>
#include <stdlib.h>
#include "compare/order.h"
#include "kernels/base/num.h"

enum { LEAST_BYTES = 1 << 25, BYTES_A_RECORD = 8 };

struct ts_gather {
	ts_reader *reader;
	const ts_order *order;
	size_t element_bytes;
	u64 first, n, most; /* of the window, in the reference's order; n 0: empty */
	u8 *window;
};

ts_gather *ts_gather_open(const ts_trace_item *item, ts_buffer_id id, const ts_order *order)
{
	size_t element_bytes = ts_buffer_table[id].element_bytes;
	assert(item->npy.n == order->n_cand);
	ts_gather *g = ts_alloc_zero(1, sizeof *g, "a window");
	if (g == NULL) return NULL;
	u64 most = (LEAST_BYTES + order->n_ref * BYTES_A_RECORD) / element_bytes;
	*g = (ts_gather){.order = order, .element_bytes = element_bytes, .most = most < order->n_ref ? most : order->n_ref};
	g->reader = ts_trace_read(item, id);
	g->window = g->reader != NULL ? ts_alloc((size_t)g->most, element_bytes, "a window of records") : NULL;
	if (g->window != NULL) return g;
	ts_gather_close(g);
	return NULL;
}

/* Parts of the candidate's file hold its records; those without one in the window are not read. */
static ts_status fill(ts_gather *g)
{
	const ts_order *order = g->order;
	const u8 *part = NULL;
	u64 begin = 0, held = 0;
	memset(g->window, 0, (size_t)g->n * g->element_bytes);
	for (u64 i = 0; i < order->n_cand; i++) {
		u64 place = (u64)order->ref_of_cand[i] - g->first;
		if (place >= g->n || order->ref_of_cand[i] == TS_NONE) continue;
		if (i - begin >= held) {
			begin = i;
			part = ts_reader_at(g->reader, i, &held);
			if (part == NULL) return TS_ERROR;
		}
		memcpy(g->window + place * g->element_bytes, part + (i - begin) * g->element_bytes, g->element_bytes);
	}
	return TS_OK;
}

const void *ts_gather_at(ts_gather *g, u64 first, u64 *n)
{
	assert(first < g->order->n_ref);
	if (first - g->first >= g->n) {
		u64 left = g->order->n_ref - first;
		g->first = first;
		g->n = left < g->most ? left : g->most;
		if (fill(g) != TS_OK) {
			g->n = 0;
			return NULL;
		}
	}
	*n = g->n - (first - g->first);
	return g->window + (first - g->first) * g->element_bytes;
}

void ts_gather_close(ts_gather *g)
{
	if (g == NULL) return;
	ts_reader_close(g->reader);
	free(g->window);
	free(g);
}
