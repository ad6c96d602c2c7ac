/* Fields of records.def's elements. */
#include "trace/field.h"
#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include "kernels/base/scene.h"

static const struct {
	const char *type;
	char kind;
	u32 bytes;
} types[] = {
	{"f32", 'f', 4}, {"i32", 'i', 4}, {"u32", 'u', 4}, {"u64", 'u', 8}, {"u8", 'u', 1},
};

static ts_field field_of(ts_buffer_id id, const char *name, const char *type, u32 count, u32 offset)
{
	ts_field field = {.name = name, .count = count, .offset = offset};
	for (size_t i = 0; i < sizeof types / sizeof *types; i++) {
		if (strcmp(types[i].type, type) != 0) continue;
		field.kind = types[i].kind;
		field.bytes = types[i].bytes;
	}
	size_t n;
	const ts_index_info *indices = ts_index_table(&n);
	for (size_t i = 0; i < n; i++) {
		if (indices[i].buffer != id || strcmp(indices[i].field, name) != 0) continue;
		field.of = &indices[i].of;
		field.none = indices[i].none;
		field.distance = field.bytes == 8 && strcmp(ts_buffer_table[id].order, "set") != 0;
	}
	return field;
}

ts_fields ts_fields_of(ts_buffer_id id)
{
	size_t n;
	u32 offset = 0;
	const ts_field_info *rows = ts_field_table(&n);
	const ts_buffer_info *info = &ts_buffer_table[id];
	ts_fields fields = {.n = 0};
	for (size_t i = 0; i < n; i++) {
		if (strcmp(rows[i].record, info->element) != 0) continue;
		assert(fields.n < TS_MAX_FIELDS);
		ts_field *field = &fields.field[fields.n++];
		*field = field_of(id, rows[i].name, rows[i].type, rows[i].count, offset);
		offset += field->bytes * field->count;
	}
	if (fields.n == 0) {
		fields.field[fields.n++] = field_of(id, "", info->element, 1, 0);
		offset = fields.field[0].bytes;
	}
	assert(offset == info->element_bytes);
	return fields;
}

bool ts_field_names(const ts_field *field, ts_dim dim) { return field->of != NULL && ts_axis_counts(field->of) == dim; }

u64 ts_field_bits(const ts_field *field, const void *data, u32 component)
{
	const u8 *at = (const u8 *)data + field->offset + (size_t)component * field->bytes;
	u64 wide;
	u32 word;
	if (field->bytes == 1) return *at;
	if (field->bytes == 4) {
		memcpy(&word, at, 4);
		return word;
	}
	memcpy(&wide, at, 8);
	return wide;
}

bool ts_field_is_nan(u64 bits) { return (bits & 0x7fffffffu) > 0x7f800000u; }

/* The place of a float among all floats. */
static i64 place_of(u64 bits)
{
	i64 size = (i64)(bits & 0x7fffffffu);
	return (bits & 0x80000000u) != 0 ? -size - 1 : size;
}

i64 ts_field_ulps(u64 from, u64 to)
{
	return ts_field_is_nan(from) || ts_field_is_nan(to) ? INT64_MAX : place_of(to) - place_of(from);
}

void ts_field_show(char text[TS_VALUE_TEXT], const ts_field *field, u64 bits)
{
	if (field->kind == 'f') {
		double value = (double)ts_u2f((u32)bits);
		snprintf(text, TS_VALUE_TEXT, "%.9g = %a (%08" PRIx64 ")", value, value, bits);
	} else if (field->kind == 'i') {
		snprintf(text, TS_VALUE_TEXT, "%d (%08" PRIx64 ")", (int)(i32)(u32)bits, bits);
	} else if (field->distance && bits == UINT64_MAX) {
		snprintf(text, TS_VALUE_TEXT, "empty");
	} else if (field->bytes == 8 && field->of != NULL && !field->distance) {
		snprintf(text, TS_VALUE_TEXT, "%u | %u (%08x_%08x)", (unsigned)(bits >> 32), (unsigned)(u32)bits,
		         (unsigned)(bits >> 32), (unsigned)(u32)bits);
	} else if (field->distance) {
		snprintf(text, TS_VALUE_TEXT, "%.9g | %u (%08x_%08x)", (double)ts_u2f((u32)(bits >> 32)), (unsigned)(u32)bits,
		         (unsigned)(bits >> 32), (unsigned)(u32)bits);
	} else if (field->of != NULL && field->bytes == 4 && bits == TS_NO_PARTNER) {
		snprintf(text, TS_VALUE_TEXT, "a point that is not of the reference");
	} else if (field->none && bits == TS_NONE) {
		snprintf(text, TS_VALUE_TEXT, "none");
	} else {
		snprintf(text, TS_VALUE_TEXT, "%" PRIu64 " (%0*" PRIx64 ")", bits, (int)field->bytes * 2, bits);
	}
}

void ts_field_name(char text[64], const ts_field *field, u32 component)
{
	if (field->count > 1) {
		snprintf(text, 64, "%s[%u]", field->name, (unsigned)component);
	} else {
		snprintf(text, 64, "%s", field->name);
	}
}
