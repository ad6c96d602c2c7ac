/* Elements by the shapes of their buffers. */
#include "trace/where.h"
#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include "kernels/base/num.h"
#include "trace/reader.h"

static const ts_where_rule *const *lists;
static _Thread_local bool failed; /* an existing row could not be read */

void ts_where_use(const ts_where_rule *const *rules) { lists = rules; }

bool ts_where_fetch(const ts_trace *reference, ts_buffer_id id, u64 index, void *to)
{
	const ts_trace_item *item = &reference->item[id];
	size_t bytes = ts_buffer_table[id].element_bytes;
	u64 held;
	if (item->path == NULL || index >= item->npy.n) return false;
	ts_reader *reader = ts_trace_read(item, id);
	const void *from = reader != NULL ? ts_reader_at(reader, index, &held) : NULL;
	if (from != NULL) memcpy(to, from, bytes);
	ts_reader_close(reader);
	failed |= from == NULL;
	return from != NULL;
}

void ts_where_key(char text[TS_WHERE_TEXT], ts_buffer_id id, u64 key)
{
	assert(lists != NULL);
	snprintf(text, TS_WHERE_TEXT, "key %" PRIx64, key);
	for (const ts_where_rule *const *list = lists; *list != NULL; list++) {
		for (const ts_where_rule *rule = *list; rule->where != NULL; rule++) {
			if (rule->of == ts_buffer_counts(id) && rule->key != NULL) rule->key(text, key);
		}
	}
}

const char *ts_where_face(u32 face)
{
	static const char *const faces[] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
	return faces[face % 6];
}

/* For views that are not faces of cubes. */
static bool where_view(char *text, const ts_trace *reference, u64 texel)
{
	ts_offscreen view;
	for (u64 v = 0; ts_where_fetch(reference, TS_B_offscreen_view, v, &view); v++) {
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
	if (reference->item[TS_B_cube_size_face].path == NULL) return where_view(text, reference, texel);
	for (u64 r = 0; ts_where_fetch(reference, TS_B_cube_size_face, r, &cube); r++) {
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

/* For a buffer with one picture per sample. */
static bool where_sample(char *text, const ts_trace *reference, ts_buffer_id id, u64 element)
{
	ts_view eye;
	u64 width = reference->item[id].npy.shape[1], y = element / width;
	bool one = !ts_where_fetch(reference, TS_B_eye_view, 0, &eye) || reference->item[id].npy.shape[0] <= eye.height;
	if (one || eye.height == 0) return where_image(text, reference, id, element);
	snprintf(text, TS_WHERE_TEXT, "pixel (%" PRIu64 ", %" PRIu64 "), sample %" PRIu64, element % width, y % eye.height,
	         y / eye.height);
	return true;
}

/* For one row of all pixels, and then of their further samples; false: the buffer has another shape. */
static bool where_pixel(char *text, const ts_trace *reference, ts_buffer_id id, u64 element)
{
	ts_view eye;
	const ts_axis *pixels = &ts_buffer_shape(id)->axis[0];
	bool image = pixels->n_factors == 2 && pixels->factor[1] == TS_DIM_width;
	if (!image || !ts_where_fetch(reference, TS_B_eye_view, 0, &eye) || eye.width == 0 || eye.height == 0) return false;
	u64 y = element / eye.width, sample = y / eye.height;
	bool several = reference->item[id].npy.n > (u64)eye.width * eye.height + 1;
	int n = snprintf(text, TS_WHERE_TEXT, "pixel (%" PRIu64 ", %" PRIu64 ")", element % eye.width, y % eye.height);
	if (several) snprintf(text + n, TS_WHERE_TEXT - (size_t)n, ", sample %" PRIu64, sample);
	return true;
}

/* Rules of no family. */
static const ts_where_rule general[] = {
	{TS_DIM_texels, where_texel, NULL},
	{TS_DIM_height, where_image, NULL},
	{TS_DIM_eye_rows, where_sample, NULL},
	{TS_DIM_sample_rows, where_sample, NULL},
	{.where = NULL},
};

static bool where_by(const ts_where_rule *rule, char *text, const ts_trace *reference, ts_buffer_id id, u64 index)
{
	for (ts_dim of = ts_buffer_counts(id); rule->where != NULL; rule++) {
		if (rule->of == of) return rule->where(text, reference, id, index);
	}
	return false;
}

/* False if only the number of the element is known. */
static bool find(char *text, const ts_trace *reference, ts_buffer_id id, u64 index)
{
	assert(lists != NULL);
	bool found = where_by(general, text, reference, id, index) || where_pixel(text, reference, id, index);
	for (const ts_where_rule *const *list = lists; *list != NULL && !found; list++) {
		found = where_by(*list, text, reference, id, index);
	}
	return found;
}

/* The noun of the first dimension; for a product, of its last factor. */
static const char *noun(const ts_axis *axis)
{
	bool named = axis->n_factors != 0 && axis->number == 1;
	return named ? ts_dim_table[axis->factor[axis->n_factors - 1]].noun : "element";
}

ts_status ts_where(char text[TS_WHERE_TEXT], const ts_trace *reference, ts_buffer_id id, u64 element)
{
	const ts_shape *shape = ts_buffer_shape(id);
	const ts_npy *npy = &reference->item[id].npy;
	u64 row_elements = 1;
	char row_text[TS_WHERE_TEXT] = "";
	for (u32 i = ts_shape_is_image(shape) ? 2 : 1; i < npy->n_dims; i++) row_elements *= npy->shape[i];
	failed = false;
	u64 row = row_elements != 0 ? element / row_elements : 0, inside = row_elements != 0 ? element % row_elements : 0;
	if (!find(row_text, reference, id, row)) {
		snprintf(row_text, sizeof row_text, "%s %" PRIu64, noun(&shape->axis[0]), row);
	}
	bool lights = shape->n == 3 && ts_axis_counts(&shape->axis[2]) == TS_DIM_lamps;
	const char *format = lights ? "%.90s, light %" PRIu64 : row_elements > 1 ? "%.90s [%" PRIu64 "]" : "%.90s";
	snprintf(text, TS_WHERE_TEXT, format, row_text, inside);
	return failed ? TS_ERROR : TS_OK;
}
