/* The picture of a trace, and its trace.json. */
#include <stdlib.h>
#include "kernels/base/srgb.h"
#include "output/json/text.h"
#include "report/page.h"

/* All elements of a buffer, to be released by free(); NULL with the message set. */
static void *read_all(const ts_trace *trace, ts_buffer_id id)
{
	const ts_trace_item *item = &trace->item[id];
	const size_t size = ts_buffer_table[id].element_bytes;
	ts_reader *reader = ts_trace_read(item, id);
	u8 *to = reader != NULL ? ts_alloc((size_t)item->npy.n, size, ts_buffer_table[id].name) : NULL;
	for (u64 at = 0, n; to != NULL && at < item->npy.n; at += n) {
		const void *some = ts_reader_at(reader, at, &n);
		if (some == NULL) {
			free(to);
			to = NULL;
		} else {
			memcpy(to + at * size, some, (size_t)n * size);
		}
	}
	ts_reader_close(reader);
	return to;
}

/* CONTRACT rule 38, for traces that hold only the radiance. */
static u8 *displayed(const f32 *radiance, u64 n, f32 exposure)
{
	u8 *rgb = ts_alloc((size_t)n, 1, "a picture");
	for (u64 i = 0; rgb != NULL && i < n; i++) rgb[i] = (u8)ts_srgb_byte(radiance[i] * exposure);
	return rgb;
}

static bool is_picture(const ts_npy *npy) { return npy->n_dims == 3 && npy->n > 0 && npy->shape[2] == 3; }

/* *id: the buffer of the picture; TS_N_BUFFERS: the trace holds none. */
static u8 *read_picture(const ts_trace *trace, ts_buffer_id *id)
{
	*id = TS_B_image_srgb;
	if (trace->item[*id].path != NULL && is_picture(&trace->item[*id].npy)) return read_all(trace, *id);
	*id = TS_B_image_radiance;
	bool has = trace->item[*id].path != NULL && is_picture(&trace->item[*id].npy);
	f32 *radiance = has ? read_all(trace, *id) : NULL;
	if (!has) *id = TS_N_BUFFERS;
	if (radiance == NULL) return NULL;
	u8 *rgb = displayed(radiance, trace->item[*id].npy.n, TS_PARAM(&trace->params, image_exposure));
	free(radiance);
	return rgb;
}

/* Members for readers; others are for programs. */
static json_t *described(ts_page *page, const ts_trace *trace)
{
	static const char *const keys[] = {"pipeline",   "effect", "paper",    "scene",  "producer", "order",
	                                   "arithmetic", "params", "contract", "stages", "counters"};
	json_t *root, *o = json_object();
	ts_page_put(page, o, "dir", ts_text_json(trace->dir));
	ts_page_put(page, o, "pipeline", json_string(trace->pipeline->name));
	ts_page_put(page, o, "effect", json_string(trace->pipeline->effect->name));
	if (ts_page_read(&root, trace->dir, "trace.json", true) != TS_OK) {
		json_decref(o);
		return NULL;
	}
	for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
		json_t *value = json_object_get(root, keys[i]);
		if (value != NULL) ts_page_put(page, o, keys[i], json_incref(value));
	}
	json_decref(root);
	return o;
}

static ts_status add_picture(ts_page *page, const ts_trace *trace, json_t *o)
{
	ts_buffer_id id;
	ts_page_picture p = {.name = (char *)trace->pipeline->name, .group = "", .folder = TS_NONE, .of = trace};
	p.rgb = read_picture(trace, &id);
	if (p.rgb == NULL) return id == TS_N_BUFFERS ? TS_OK : TS_ERROR;
	const ts_trace_item *item = &trace->item[id];
	p.width = (u32)item->npy.shape[1];
	p.height = (u32)item->npy.shape[0];
	p.left = item->crop[0];
	p.top = item->crop[1];
	ts_page_put(page, o, "picture", json_integer((json_int_t)page->n_pictures));
	json_t *png = ts_page_png(p.rgb, p.width, p.height, 3, trace->dir);
	json_t *shown = ts_page_take(page, &p, trace->dir, png);
	if (shown == NULL) return TS_ERROR;
	ts_page_put(page, shown, "trace", ts_text_json(trace->dir));
	return ts_page_check(page);
}

ts_status ts_page_add_trace(ts_page *page, const ts_trace *trace)
{
	json_t *o = described(page, trace);
	if (o == NULL) return TS_ERROR;
	ts_page_append(page, page->traces, o);
	return ts_page_check(page) == TS_OK ? add_picture(page, trace, o) : TS_ERROR;
}
