/* Dimensions of a buffer from the text of its shape. */
#include "model/shape.h"
#include <stdlib.h>
#include <string.h>

#define DIM(id, noun, how, bits, doc) {#id, noun, TS_IS_##how, bits, doc},
const ts_dim_info ts_dim_table[TS_N_DIMS] = {
#include <touchstone/records.def>
};

void ts_sizes_clear(ts_sizes *sizes)
{
	for (u32 dim = 0; dim < TS_N_DIMS; dim++) sizes->n[dim] = TS_UNKNOWN;
}

static bool multiply(u64 *product, u64 factor)
{
	if (factor != 0 && *product > UINT64_MAX / factor) return false;
	*product *= factor;
	return true;
}

static ts_dim find(const char *name, size_t length)
{
	for (u32 dim = 0; dim < TS_N_DIMS; dim++) {
		const char *known = ts_dim_table[dim].name;
		if (strlen(known) == length && memcmp(known, name, length) == 0) return (ts_dim)dim;
	}
	return TS_DIM_none;
}

/* A number of at most 18 digits, or a size. */
static bool parse_factor(ts_axis *axis, const char *text, size_t length)
{
	if (length > 0 && length <= 18 && strspn(text, "0123456789") == length) {
		return multiply(&axis->number, strtoull(text, NULL, 10));
	}
	ts_dim dim = find(text, length);
	if (dim == TS_DIM_none || axis->n_factors == TS_MAX_FACTORS) return false;
	axis->factor[axis->n_factors++] = dim;
	return true;
}

static bool parse_axis(ts_axis *axis, const char *text, size_t length)
{
	bool one_more = length > 2 && memcmp(text + length - 2, "+1", 2) == 0;
	const char *end = text + length - (one_more ? 2 : 0);
	*axis = (ts_axis){.number = 1, .more = one_more};
	for (size_t n; text <= end; text += n + 1) {
		const char *times = memchr(text, '*', (size_t)(end - text));
		n = (size_t)((times != NULL ? times : end) - text);
		if (!parse_factor(axis, text, n)) return false;
	}
	return true;
}

bool ts_shape_parse(ts_shape *shape, const char *text)
{
	shape->n = 0;
	for (size_t length; *text != 0; text += length + (text[length] == ' ')) {
		length = strcspn(text, " ");
		if (shape->n == TS_MAX_DIMS || !parse_axis(&shape->axis[shape->n++], text, length)) return false;
	}
	return shape->n > 0;
}

u64 ts_axis_size(const ts_axis *axis, const ts_sizes *sizes)
{
	u64 size = axis->number;
	for (u32 k = 0; k < axis->n_factors; k++) {
		u64 factor = sizes->n[axis->factor[k]];
		if (factor == TS_UNKNOWN || !multiply(&size, factor)) return TS_UNKNOWN;
	}
	return size > UINT64_MAX - axis->more ? TS_UNKNOWN : size + axis->more;
}

bool ts_shape_dims(const ts_shape *shape, const ts_sizes *sizes, u64 dims[TS_MAX_DIMS])
{
	bool known = true;
	for (u32 i = 0; i < shape->n; i++) {
		dims[i] = ts_axis_size(&shape->axis[i], sizes);
		known &= dims[i] != TS_UNKNOWN;
	}
	return known;
}

ts_dim ts_axis_counts(const ts_axis *axis)
{
	return axis->number == 1 && axis->n_factors == 1 ? axis->factor[0] : TS_DIM_none;
}

bool ts_shape_is_image(const ts_shape *shape)
{
	ts_dim rows = ts_axis_counts(&shape->axis[0]);
	bool eye = rows == TS_DIM_height || rows == TS_DIM_eye_rows || rows == TS_DIM_sample_rows;
	return shape->n >= 2 && eye && ts_axis_counts(&shape->axis[1]) == TS_DIM_width;
}

bool ts_shape_count(u64 *n, u32 n_dims, const u64 *dims)
{
	*n = 1;
	for (u32 i = 0; i < n_dims; i++) {
		if (!multiply(n, dims[i])) return false;
	}
	return true;
}
