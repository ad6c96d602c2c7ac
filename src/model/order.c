/* Elements between memory and file. */
#include "model/order.h"
#include <assert.h>

enum { MOST_BYTES = 256 };

/* Appends to `place` the source of each byte of `count` numbers. */
static size_t add(u32 place[MOST_BYTES], size_t at, const char *type, u32 count)
{
	size_t bytes = ts_type_bytes(type), end = at + count * bytes;
	assert(end <= MOST_BYTES);
	for (; at < end; at += bytes) {
		for (size_t k = 0; k < bytes; k++) place[at + k] = (u32)(at + bytes - 1 - k);
	}
	return end;
}

void ts_order_reverse(void *to, const void *from, ts_buffer_id id, u64 n)
{
	const ts_buffer_info *info = &ts_buffer_table[id];
	size_t n_fields, bytes = 0;
	u32 place[MOST_BYTES];
	const ts_field_info *fields = ts_field_table(&n_fields);
	for (size_t i = 0; i < n_fields; i++) {
		if (strcmp(fields[i].record, info->element) == 0) bytes = add(place, bytes, fields[i].type, fields[i].count);
	}
	if (bytes == 0) bytes = add(place, 0, info->element, 1);
	assert(bytes == info->element_bytes);
	for (u64 i = 0; i < n; i++) {
		u8 *element = (u8 *)to + i * bytes;
		for (size_t k = 0; k < bytes; k++) element[k] = ((const u8 *)from)[i * bytes + place[k]];
	}
}
