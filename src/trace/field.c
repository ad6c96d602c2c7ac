/* Fields and their offsets, from records.def. */
#include "field.h"
#include <assert.h>

static const struct { const char *name; size_t bytes; } types[] = {
	[TS_TYPE_F32] = {"f32", 4}, [TS_TYPE_I32] = {"i32", 4}, [TS_TYPE_U32] = {"u32", 4},
	[TS_TYPE_U64] = {"u64", 8}, [TS_TYPE_U8] = {"u8", 1},
};

enum { N_TYPES = sizeof types / sizeof *types };

static bool find_type(ts_type *type, const char *name)
{
	for (u32 i = 0; i < N_TYPES; i++) {
		*type = (ts_type)i;
		if (strcmp(types[i].name, name) == 0) return true;
	}
	return false;
}

size_t ts_type_bytes(ts_type type) { return types[type].bytes; }

u32 ts_field_list(ts_field fields[TS_MAX_FIELDS], ts_buffer_id id)
{
	const char *element = ts_buffer_table[id].element;
	fields[0] = (ts_field){.name = "", .count = 1};
	if (find_type(&fields[0].type, element)) return 1;
	size_t n_rows, at = 0;
	u32 n = 0;
	const ts_field_info *rows = ts_field_table(&n_rows);
	for (size_t i = 0; i < n_rows; i++) {
		if (strcmp(rows[i].record, element) != 0) continue;
		assert(n < TS_MAX_FIELDS);
		ts_field *field = &fields[n++];
		*field = (ts_field){.name = rows[i].name, .count = rows[i].count, .at = at};
		bool known = find_type(&field->type, rows[i].type);
		assert(known);
		(void)known;
		at += field->count * ts_type_bytes(field->type);
	}
	assert(n > 0 && at == ts_buffer_table[id].element_bytes);
	return n;
}
