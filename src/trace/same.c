/* First differences, field by field. */
#include "same.h"
#include <inttypes.h>
#include <stdio.h>

enum { BLOCK_BYTES = 1 << 16 };

/* Skips what is the same by blocks. */
static u64 find_element(const u8 *a, const u8 *b, u64 n, size_t element_bytes)
{
	u64 block = BLOCK_BYTES / element_bytes, i = 0;
	while (n - i > block && memcmp(a + i * element_bytes, b + i * element_bytes, block * element_bytes) == 0) i += block;
	while (i < n && memcmp(a + i * element_bytes, b + i * element_bytes, element_bytes) == 0) i++;
	return i;
}

bool ts_same_find(ts_place *first, ts_buffer_id id, const void *a, const void *b, u64 n)
{
	size_t bytes = ts_buffer_table[id].element_bytes;
	u64 element = n != 0 ? find_element(a, b, n, bytes) : 0;
	if (element == n) return true;
	const u8 *x = (const u8 *)a + element * bytes, *y = (const u8 *)b + element * bytes;
	ts_field fields[TS_MAX_FIELDS];
	u32 n_fields = ts_field_list(fields, id);
	for (u32 f = 0; f < n_fields; f++) {
		size_t size = ts_type_bytes(fields[f].type), at = fields[f].at;
		for (u32 k = 0; k < fields[f].count; k++, at += size) {
			*first = (ts_place){element, fields[f], k};
			if (memcmp(x + at, y + at, size) != 0) return false;
		}
	}
	return false;
}

void ts_value_print(char text[TS_VALUE_TEXT], ts_type type, const void *value)
{
	u32 bits;
	u64 wide;
	switch (type) {
	case TS_TYPE_U64:
		memcpy(&wide, value, sizeof wide);
		snprintf(text, TS_VALUE_TEXT, "%" PRIu64 " (%016" PRIx64 ")", wide, wide);
		return;
	case TS_TYPE_U8:
		bits = *(const u8 *)value;
		snprintf(text, TS_VALUE_TEXT, "%" PRIu32 " (%02" PRIx32 ")", bits, bits);
		return;
	case TS_TYPE_F32:
		memcpy(&bits, value, sizeof bits);
		snprintf(text, TS_VALUE_TEXT, "%.9g (%a, %08" PRIx32 ")", (double)ts_u2f(bits), (double)ts_u2f(bits), bits);
		return;
	case TS_TYPE_I32:
		memcpy(&bits, value, sizeof bits);
		wide = bits < 1u << 31 ? bits : -(u64)bits & UINT32_MAX;
		snprintf(text, TS_VALUE_TEXT, "%s%" PRIu64 " (%08" PRIx32 ")", bits < 1u << 31 ? "" : "-", wide, bits);
		return;
	case TS_TYPE_U32:
		memcpy(&bits, value, sizeof bits);
		snprintf(text, TS_VALUE_TEXT, "%" PRIu32 " (%08" PRIx32 ")", bits, bits);
	}
}

void ts_place_print(char text[TS_PLACE_TEXT], const ts_place *place)
{
	const ts_field *field = &place->field;
	char component[16] = "";
	if (field->count > 1) snprintf(component, sizeof component, "[%" PRIu32 "]", place->component);
	const char *word = field->name[0] != 0 ? ", field " : "";
	snprintf(text, TS_PLACE_TEXT, "element %" PRIu64 "%s%s%s", place->element, word, field->name, component);
}

void ts_same_print(char text[TS_SAME_TEXT], const ts_place *place, const char *here, const void *a, const char *there,
                   const void *b)
{
	char where[TS_PLACE_TEXT], x[TS_VALUE_TEXT], y[TS_VALUE_TEXT];
	ts_type type = place->field.type;
	size_t at = place->field.at + place->component * ts_type_bytes(type);
	ts_place_print(where, place);
	ts_value_print(x, type, (const u8 *)a + at);
	ts_value_print(y, type, (const u8 *)b + at);
	snprintf(text, TS_SAME_TEXT, "%s: %s %.40s, %s %.40s", where, x, here, y, there);
}
