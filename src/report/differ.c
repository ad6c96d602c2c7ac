/* Where a candidate's pictures differ: the first buffer of each pixel, the pixels of first differences, and why pixels
 * are as they are on both sides. */
#include <stdlib.h>
#include "output/json/text.h"
#include "probe/probe.h"
#include "report/page.h"
#include "trace/emitted/emit.h"

enum { MOST_LAYERS = 254 };

/* For each pixel of the picture, the first buffer that differs there, in the order of the pipeline. */
typedef struct {
	ts_page *page;
	json_t *o; /* the comparison */
	const ts_trace *reference, *candidate;
	const ts_comparison *comparison;
	u32 width, height, left, top;
	u8 *first;  /* 0: none; otherwise its number among the layers, from 1 */
	u8 *wanted; /* 1: include its probe */
	json_t *layers;
	u64 n_differing, n_wanted;
} differing;

/* Whether the buffer has one row per row of pixels, or of their samples, one image below the other. */
static bool fits(const differing *d, ts_buffer_id id)
{
	const ts_npy *npy = &d->reference->item[id].npy;
	return ts_shape_is_image(ts_buffer_shape(id)) && npy->n > 0 && npy->n_dims >= 2 && npy->shape[1] == d->width &&
	       npy->shape[0] % d->height == 0;
}

/* The pixel of an element. */
static u64 pixel_of(const differing *d, ts_buffer_id id, u64 element)
{
	const ts_npy *npy = &d->reference->item[id].npy;
	u64 at = element / (npy->n / (npy->shape[0] * npy->shape[1]));
	return at / d->width % d->height * d->width + at % d->width;
}

static void add_layer(differing *d, ts_buffer_id id, const u8 *marks)
{
	u8 number = (u8)(json_array_size(d->layers) + 1);
	u64 n = 0;
	for (u64 i = 0; i < d->reference->item[id].npy.n; i++) {
		u8 *first = &d->first[pixel_of(d, id, i)];
		if (marks[i] == 0 || *first != 0) continue;
		*first = number;
		n++;
	}
	d->n_differing += n;
	ts_page_append(d->page, d->layers,
	               json_pack("{s:s, s:I}", "buffer", ts_buffer_table[id].name, "pixels", (json_int_t)n));
}

static ts_status mark_buffer(differing *d, ts_buffer_id id, const ts_order *order, const ts_relaxations *relaxations)
{
	u8 *marks = ts_alloc_zero((size_t)d->reference->item[id].npy.n, 1, "differing pixels");
	if (marks == NULL) return TS_ERROR;
	ts_verdict v = {.marks = marks};
	ts_status status = ts_compare_buffer(&v, id, d->reference, d->candidate, order, relaxations);
	if (status == TS_OK) add_layer(d, id, marks);
	free(marks);
	return status;
}

static ts_status mark_all(differing *d, const ts_relaxations *relaxations)
{
	ts_order order;
	ts_buffer_id ids[TS_N_BUFFERS];
	ts_emit_order(ids, d->reference->pipeline);
	ts_status status = ts_order_make(&order, ts_order_key(), d->reference, d->candidate);
	for (u32 i = 0; i < TS_N_BUFFERS && status == TS_OK; i++) {
		const ts_verdict *v = &d->comparison->verdict[ids[i]];
		bool shaped = v->judgement == TS_UNLIKE && !v->by_digest && v->n_ref == v->n_cand && fits(d, ids[i]);
		if (shaped && json_array_size(d->layers) < MOST_LAYERS) status = mark_buffer(d, ids[i], &order, relaxations);
	}
	ts_order_free(&order);
	return status;
}

static void want(differing *d, u64 pixel)
{
	if (d->first[pixel] == 0 || d->wanted[pixel] != 0 || d->n_wanted == d->page->n_probes) return;
	d->wanted[pixel] = 1;
	d->n_wanted++;
}

/* Gives a pixel buffer's first differences their x and y; probes of these pixels have priority. */
static void place_firsts(differing *d)
{
	size_t i, k;
	json_t *unlike, *first;
	ts_buffer_id id;
	json_array_foreach (json_object_get(json_object_get(d->o, "said"), "differences"), i, unlike) {
		const char *buffer = json_string_value(json_object_get(unlike, "buffer"));
		if (buffer == NULL || !ts_trace_find(&id, buffer) || !fits(d, id)) continue;
		json_array_foreach (json_object_get(unlike, "first"), k, first) {
			const json_t *element = json_object_get(first, "element");
			if (element == NULL) continue;
			u64 pixel = pixel_of(d, id, (u64)json_integer_value(element));
			want(d, pixel);
			ts_page_put(d->page, first, "x", json_integer((json_int_t)(pixel % d->width)));
			ts_page_put(d->page, first, "y", json_integer((json_int_t)(pixel / d->width)));
		}
	}
}

/* One side's answer, or why there is none. */
static json_t *ask(ts_probe *probe, const char *why, u64 x, u64 y)
{
	json_t *answer = NULL;
	ts_probe_question q = {.subject = TS_PROBE_PIXEL, .x = (u32)x, .y = (u32)y};
	if (probe != NULL && ts_probe_ask(probe, &q, &answer) == TS_OK) return answer;
	return json_pack("{s:o}", "none", ts_text_json(probe != NULL ? ts_error_message() : why));
}

/* Chooses other differing pixels, evenly spread, as far as there is room. */
static void want_others(differing *d)
{
	u64 n = 0, room = d->page->n_probes - d->n_wanted, others = d->n_differing - d->n_wanted;
	for (u64 i = 0; i < (u64)d->width * d->height; i++) {
		if (d->first[i] == 0 || d->wanted[i] != 0) continue;
		u64 k = n++;
		if (others <= room || k * room / others != (k + 1) * room / others) want(d, i);
	}
}

static ts_status probe_pixels(differing *d)
{
	static const char *const sides[] = {"reference", "candidate"};
	const ts_trace *const traces[] = {d->reference, d->candidate};
	ts_probe *probe[2] = {NULL, NULL};
	char why[2][TS_WHY_TEXT] = {"", ""};
	json_t *probes = json_array();
	for (u32 s = 0; s < 2 && d->n_wanted > 0; s++) {
		if (ts_probe_open(&probe[s], traces[s]) != TS_OK) snprintf(why[s], TS_WHY_TEXT, "%s", ts_error_message());
	}
	for (u64 i = 0; i < (u64)d->width * d->height; i++) {
		if (d->wanted[i] == 0) continue;
		u64 x = i % d->width, y = i / d->width;
		json_t *o = json_pack("{s:I, s:I}", "x", (json_int_t)x, "y", (json_int_t)y);
		for (u32 s = 0; s < 2; s++) ts_page_put(d->page, o, sides[s], ask(probe[s], why[s], x + d->left, y + d->top));
		ts_page_append(d->page, probes, o);
	}
	for (u32 s = 0; s < 2; s++) ts_probe_close(probe[s]);
	ts_page_put(d->page, d->o, "probes", probes);
	return ts_page_check(d->page);
}

static ts_status look_at_pixels(differing *d, const ts_relaxations *relaxations)
{
	d->first = ts_alloc_zero(d->width, d->height, "differing pixels");
	d->wanted = ts_alloc_zero(d->width, d->height, "differing pixels");
	d->layers = json_array();
	ts_page_put(d->page, d->o, "layers", d->layers);
	ts_status status = d->first != NULL && d->wanted != NULL ? ts_page_check(d->page) : TS_ERROR;
	if (status == TS_OK) status = mark_all(d, relaxations);
	if (status == TS_OK) {
		place_firsts(d);
		want_others(d);
		status = probe_pixels(d);
	}
	json_t *png = status == TS_OK ? ts_page_png(d->first, d->width, d->height, 1, d->candidate->dir) : NULL;
	if (png != NULL) ts_page_put(d->page, d->o, "firsts", png);
	free(d->first);
	free(d->wanted);
	return png != NULL ? ts_page_check(d->page) : TS_ERROR;
}

static json_t *begin(ts_page *page, const json_t *json)
{
	json_t *o = json_object();
	ts_page_put(page, o, "said", json_deep_copy(json));
	ts_page_append(page, page->comparisons, o);
	return o;
}

/* Pairs the pictures, and measures their distance. */
static ts_status pair_last(ts_page *page, json_t *o, size_t reference, size_t image)
{
	ts_page_put(page, o, "reference", json_integer((json_int_t)reference));
	ts_page_put(page, o, "image", json_integer((json_int_t)image));
	return ts_page_add_pair(page, reference, image);
}

ts_status ts_page_add_picture_comparison(ts_page *page, const json_t *json)
{
	if (page->n_pictures < 2) return ts_fail("the page: a comparison of two pictures, of which it has fewer");
	json_t *o = begin(page, json);
	const size_t n = page->n_pictures;
	return ts_page_check(page) == TS_OK ? pair_last(page, o, n - 2, n - 1) : TS_ERROR;
}

/* The index of an added trace's picture; n_pictures: none. */
static size_t picture_of(const ts_page *page, const ts_trace *trace)
{
	size_t i = page->n_pictures;
	while (i > 0 && page->picture[i - 1].of != trace) i--;
	return i > 0 ? i - 1 : page->n_pictures;
}

ts_status ts_page_add_comparison(ts_page *page, const ts_comparison *comparison, const ts_trace *reference,
                                 const ts_trace *candidate, const ts_relaxations *relaxations, const json_t *json)
{
	json_t *o = begin(page, json);
	const size_t a = picture_of(page, reference), b = picture_of(page, candidate);
	differing d = {.page = page, .o = o, .reference = reference, .candidate = candidate, .comparison = comparison};
	if (ts_page_check(page) != TS_OK) return TS_ERROR;
	if (a == page->n_pictures || b == page->n_pictures) return TS_OK;
	const ts_page_picture *p = &page->picture[a], *q = &page->picture[b];
	if (p->width != q->width || p->height != q->height) return TS_OK;
	d.width = p->width;
	d.height = p->height;
	d.left = p->left;
	d.top = p->top;
	if (pair_last(page, o, a, b) != TS_OK) return TS_ERROR;
	return look_at_pixels(&d, relaxations);
}
