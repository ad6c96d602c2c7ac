/* Elements by the shapes of their buffers. */
#include "where.h"
#include <inttypes.h>
#include <stdio.h>
#include "../kernels/base/num.h"
#include "reader.h"

/* Copies element `index` of a buffer of the reference; false if it is not there. */
static bool fetch(const ts_trace *reference, ts_buffer_id id, u64 index, void *to)
{
	const ts_trace_item *item = &reference->item[id];
	size_t bytes = ts_buffer_table[id].element_bytes;
	u64 held;
	if (item->path == NULL || index >= item->npy.n) return false;
	ts_reader *reader = ts_trace_read(item, id);
	const void *from = reader != NULL ? ts_reader_at(reader, index, &held) : NULL;
	if (from != NULL) memcpy(to, from, bytes);
	ts_reader_close(reader);
	return from != NULL;
}

void ts_where_key(char text[TS_WHERE_TEXT], u64 key)
{
	snprintf(text, TS_WHERE_TEXT, "piece %u, x %d, y %d", (unsigned)(key >> 32), (int)(key & 0xffff) - 32768,
	         (int)(key >> 16 & 0xffff) - 32768);
}

static bool where_point(char *text, const ts_trace *reference, ts_buffer_id id, u64 point)
{
	u64 key;
	(void)id;
	if (!fetch(reference, TS_B_points_key, point, &key)) return false;
	char inside[TS_WHERE_TEXT];
	ts_where_key(inside, key);
	snprintf(text, TS_WHERE_TEXT, "key (%.100s)", inside);
	return true;
}

static bool where_pixel(char *text, const ts_trace *reference, ts_buffer_id id, u64 pixel)
{
	ts_pixel record;
	(void)id;
	if (!fetch(reference, TS_B_pixel_record, pixel, &record) || TS_PARAM(&reference->params, width) == 0) return false;
	snprintf(text, TS_WHERE_TEXT, "pixel (%u, %u)", (unsigned)(record.index % TS_PARAM(&reference->params, width)),
	         (unsigned)(record.index / TS_PARAM(&reference->params, width)));
	return true;
}

const char *ts_where_face(u32 face)
{
	static const char *const faces[] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
	return faces[face % 6];
}

/* Of views that are no cubes' faces. */
static bool where_view(char *text, const ts_trace *reference, u64 texel)
{
	ts_offscreen view;
	for (u64 v = 0; fetch(reference, TS_B_offscreen_view, v, &view); v++) {
		u64 inside = texel - view.offset;
		if (texel < view.offset || inside >= (u64)view.width * view.height) continue;
		snprintf(text, TS_WHERE_TEXT, "view %" PRIu64 ", texel (%" PRIu64 ", %" PRIu64 ")", v, inside % view.width,
		         inside / view.width);
		return true;
	}
	return false;
}

static bool where_texel(char *text, const ts_trace *reference, ts_buffer_id id, u64 texel)
{
	(void)id;
	ts_face cube;
	if (reference->item[TS_B_resize_face].path == NULL) return where_view(text, reference, texel);
	for (u64 r = 0; fetch(reference, TS_B_resize_face, r, &cube); r++) {
		u64 n = cube.n, inside = texel - cube.offset;
		if (texel < cube.offset || inside >= 6 * n * n) continue;
		snprintf(text, TS_WHERE_TEXT, "%s %" PRIu64 ", face %s, texel (%" PRIu64 ", %" PRIu64 ")",
		         cube.object != TS_NONE ? "reflector" : "sample", r, ts_where_face((u32)(inside / (n * n))), inside % n,
		         inside / n % n);
		return true;
	}
	return false;
}

static bool where_image(char *text, const ts_trace *reference, ts_buffer_id id, u64 element)
{
	const ts_trace_item *item = &reference->item[id];
	u64 x = element % item->npy.shape[1] + (item->cropped ? item->crop[0] : 0);
	u64 y = element / item->npy.shape[1] + (item->cropped ? item->crop[1] : 0);
	snprintf(text, TS_WHERE_TEXT, "pixel (%" PRIu64 ", %" PRIu64 ")", x, y);
	return true;
}

/* Things that say more of their place than their number. */
static const struct {
	ts_dim of;
	bool (*where)(char *text, const ts_trace *reference, ts_buffer_id id, u64 index);
} places[] = {
	{TS_DIM_points, where_point},
	{TS_DIM_mirror_pixels, where_pixel},
	{TS_DIM_texels, where_texel},
	{TS_DIM_height, where_image},
};

/* What the first dimension counts; of a product the last. */
static const char *noun(const ts_axis *axis)
{
	bool named = axis->n_factors != 0 && axis->number == 1;
	return named ? ts_dim_table[axis->factor[axis->n_factors - 1]].noun : "element";
}

void ts_where(char text[TS_WHERE_TEXT], const ts_trace *reference, ts_buffer_id id, u64 element)
{
	const ts_shape *shape = ts_buffer_shape(id);
	const ts_npy *npy = &reference->item[id].npy;
	ts_dim of = ts_buffer_counts(id);
	u64 row_elements = 1;
	bool found = false;
	char row_text[TS_WHERE_TEXT] = "";
	for (u32 i = ts_shape_is_image(shape) ? 2 : 1; i < npy->n_dims; i++) row_elements *= npy->shape[i];
	u64 row = row_elements != 0 ? element / row_elements : 0, inside = row_elements != 0 ? element % row_elements : 0;
	for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
		if (places[i].of == of) found = places[i].where(row_text, reference, id, row);
	}
	if (!found) snprintf(row_text, sizeof row_text, "%s %" PRIu64, noun(&shape->axis[0]), row);
	bool lights = shape->n == 3 && ts_axis_counts(&shape->axis[2]) == TS_DIM_lamps;
	const char *format = lights ? "%.90s, light %" PRIu64 : row_elements > 1 ? "%.90s [%" PRIu64 "]" : "%.90s";
	snprintf(text, TS_WHERE_TEXT, format, row_text, inside);
}
