/* Places of points and reflective pixels. */
#include <stdio.h>
#include "methods/points/tools/tools.h"

static void where_key(char *text, u64 key)
{
	snprintf(text, TS_WHERE_TEXT, "key (piece %u, x %d, y %d)", (unsigned)(key >> 32), (int)(key & 0xffff) - 32768,
	         (int)(key >> 16 & 0xffff) - 32768);
}

static bool where_point(char *text, const ts_trace *reference, ts_buffer_id id, u64 point)
{
	u64 key;
	(void)id;
	if (!ts_where_fetch(reference, TS_B_points_key, point, &key)) return false;
	where_key(text, key);
	return true;
}

static bool where_pixel(char *text, const ts_trace *reference, ts_buffer_id id, u64 pixel)
{
	ts_pixel record;
	(void)id;
	u32 width = TS_PARAM(&reference->params, width), height = TS_PARAM(&reference->params, height);
	if (!ts_where_fetch(reference, TS_B_mirror_pixel_record, pixel, &record) || width == 0) return false;
	u32 row = record.index / width;
	int n = snprintf(text, TS_WHERE_TEXT, "pixel (%u, %u)", (unsigned)(record.index % width), (unsigned)(row % height));
	if (TS_PARAM(&reference->params, eye_samples) != TS_EYE_SAMPLES_1)
		snprintf(text + n, TS_WHERE_TEXT - (size_t)n, ", sample %u", (unsigned)(row / height));
	return true;
}

const ts_where_rule ts_points_places[] = {
	{TS_DIM_points, where_point, where_key},
	{TS_DIM_mirror_pixels, where_pixel, NULL},
	{.where = NULL},
};
