/* The cross-bilateral filter at a pixel: its neighbours along its row, then along its column. */
#include <stdlib.h>
#include "kernels/views/bilateral.h"
#include "methods/stages.h"
#include "methods/views/tools/probe.h"

enum { MOST_LISTED = 8 };

typedef struct {
	i32 k;
	f32 weight;
} neighbour;

static int by_weight(const void *a, const void *b)
{
	const neighbour *s = a, *t = b;
	return s->weight != t->weight ? (s->weight < t->weight) - (s->weight > t->weight) : (s->k > t->k) - (s->k < t->k);
}

/* Finds the neighbours that take part, including the pixel. Returns their number. */
static u32 find(const ts_bilateral_args *args, u32 x, u32 y, neighbour *found)
{
	i32 place = (i32)(args->columns != 0 ? y : x), end = (i32)(args->columns != 0 ? args->height : args->width);
	i32 radius = (i32)args->radius;
	u64 i = (u64)y * args->width + x;
	u32 n = 0;
	for (i32 k = -radius; k <= radius; k++) {
		if (place + k < 0 || place + k >= end) continue;
		u64 other = (u64)((i64)i + k * (args->columns != 0 ? (i64)args->width : 1));
		if (args->pixels[other].depth != TS_SKY) found[n++] = (neighbour){k, ts_k_bilateral_weight(args, i, other, k)};
	}
	return n;
}

/* One pass: the pixels that take part, and those with the most weight. */
static ts_status put_pass(ts_probe *p, json_t *object, const char *name, const ts_bilateral_args *args, u32 x, u32 y)
{
	json_t *o = json_object(), *list = json_array();
	neighbour *found = ts_alloc(2 * (size_t)args->radius + 1, sizeof *found, "neighbours");
	if (found == NULL) return TS_ERROR;
	u32 n = find(args, x, y, found);
	f32 sum = 0.0f;
	for (u32 k = 0; k < n; k++) sum = sum + found[k].weight;
	qsort(found, n, sizeof *found, by_weight);
	for (u32 k = 0; k < n && k < MOST_LISTED; k++) {
		u32 column = args->columns != 0 ? x : x + (u32)found[k].k, row = args->columns != 0 ? y + (u32)found[k].k : y;
		json_t *entry = json_object();
		ts_probe_put(p, entry, "pixel", ts_probe_pair(column, row));
		ts_probe_put(p, entry, "weight", ts_probe_bits(found[k].weight));
		ts_probe_put(p, entry, "irradiance", ts_probe_v3(ts_load3(args->from + ((u64)row * args->width + column) * 3)));
		ts_probe_append(p, list, entry);
	}
	free(found);
	ts_probe_put(p, o, "pixels", ts_probe_int(n));
	ts_probe_put(p, o, "sum_of_weights", ts_probe_bits(sum));
	ts_probe_put(p, o, "heaviest", list);
	ts_probe_put(p, object, name, o);
	return TS_OK;
}

/* Filters along rows, for all pixels of the column that the filter reaches. */
static void filter_rows(const ts_bilateral_args *args, u32 x, u32 y)
{
	u32 first = y > args->radius ? y - args->radius : 0;
	for (u32 row = first; row <= y + args->radius && row < args->height; row++) {
		ts_k_bilateral_item(args, (u64)row * args->width + x);
	}
}

/* rows and columns: in the picture of the pixel's sample. */
static ts_status put_filter(ts_probe *p, json_t *o, ts_bilateral_args *args, f32 *rows, f32 *columns,
                            const ts_probe_seen *at)
{
	bool there;
	f32 held[3];
	u32 x = at->x, y = at->y;
	u64 pixel = (u64)y * args->width + x;
	filter_rows(args, x, y);
	ts_status status = put_pass(p, o, "along_the_row", args, x, y);
	if (status == TS_OK) status = ts_probe_fetch_pixel(p, TS_B_bilateral_filtered_rows, x, at->row, 3, held, &there);
	if (status != TS_OK) return status;
	ts_probe_put(p, o, "of_the_row", ts_probe_v3_bits(ts_load3(rows + pixel * 3)));
	if (there) ts_probe_put_check(p, o, TS_B_bilateral_filtered_rows, rows + pixel * 3, held, 3);
	args->from = rows;
	args->to = columns;
	args->columns = 1;
	ts_k_bilateral_item(args, pixel);
	return put_pass(p, o, "along_the_column", args, x, y);
}

ts_status ts_probe_filter(ts_probe *p, const ts_probe_seen *at, json_t *object, f32 irradiance[3])
{
	const ts_params *params = &p->load->run.params;
	u64 n = (u64)TS_PARAM(params, width) * TS_PARAM(params, height);
	u64 first = (u64)(at->row - at->y) * TS_PARAM(params, width);
	f32 *rows = ts_alloc_zero((size_t)n, 3 * sizeof *rows, "rows"), *columns = NULL;
	ts_bilateral_args args = {.pixels = (const ts_gpixel *)ts_probe_loaded(p, TS_B_gbuffer_pixel) + first,
	                          .from = (const f32 *)ts_probe_loaded(p, TS_B_vpl_gather_irradiance) + first * 3,
	                          .to = rows,
	                          .width = TS_PARAM(params, width),
	                          .height = TS_PARAM(params, height),
	                          .radius = TS_PARAM(params, bilateral_px)};
	json_t *o = json_object();
	if (rows != NULL) columns = ts_alloc_zero((size_t)n, 3 * sizeof *columns, "columns");
	ts_status status = columns != NULL ? put_filter(p, o, &args, rows, columns, at) : TS_ERROR;
	if (status == TS_OK)
		memcpy(irradiance, columns + ((u64)at->y * TS_PARAM(params, width) + at->x) * 3, 3 * sizeof *irradiance);
	ts_probe_put(p, object, "filter", o);
	free(rows);
	free(columns);
	return status;
}
