/* Where a number stands in a buffer: a component of a field of an element. */
#ifndef TS_TESTS_REPLAY_SPOT_H
#define TS_TESTS_REPLAY_SPOT_H
#include "tests/model/test.h"
#include "trace/field.h"

typedef struct {
	void *at;
	size_t bytes;
} spot;

/* In `data`, n elements of a buffer. */
static inline spot spot_of(void *data, u64 n, ts_buffer_id id, u64 element, const char *name, u32 component)
{
	const ts_fields fields = ts_fields_of(id);
	u32 f = 0;
	while (f < fields.n && strcmp(fields.field[f].name, name) != 0) f++;
	assert_true(f < fields.n && element < n && component < fields.field[f].count);
	const ts_field *field = &fields.field[f];
	u64 offset = element * ts_buffer_table[id].element_bytes + field->offset + component * field->bytes;
	return (spot){(u8 *)data + offset, field->bytes};
}

#endif
