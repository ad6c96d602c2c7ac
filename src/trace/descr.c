/* Dtypes of buffers. */
#include "trace/descr.h"
#include <assert.h>
#include <stdio.h>
#include <string.h>

static const struct {
	const char *type, *descr;
} scalars[] = {
	{"f32", "<f4"}, {"i32", "<i4"}, {"u32", "<u4"}, {"u64", "<u8"}, {"u8", "|u1"},
};

static const char *scalar_descr(const char *type)
{
	for (size_t i = 0; i < sizeof scalars / sizeof *scalars; i++) {
		if (strcmp(scalars[i].type, type) == 0) return scalars[i].descr;
	}
	return NULL;
}

static size_t put_field(char *out, size_t room, const ts_field_info *f, bool first)
{
	char count[32] = "";
	if (f->count > 1) snprintf(count, sizeof count, ", (%u,)", (unsigned)f->count);
	int n = snprintf(out, room, "%s('%s', '%s'%s)", first ? "" : ", ", f->name, scalar_descr(f->type), count);
	assert(n > 0 && (size_t)n < room);
	return (size_t)n;
}

void ts_npy_descr(char descr[TS_NPY_DESCR], ts_buffer_id id)
{
	const char *element = ts_buffer_table[id].element, *scalar = scalar_descr(element);
	if (scalar != NULL) {
		snprintf(descr, TS_NPY_DESCR, "'%s'", scalar);
		return;
	}
	size_t n_fields, used = 1;
	const ts_field_info *fields = ts_field_table(&n_fields);
	descr[0] = '[';
	for (size_t i = 0; i < n_fields; i++) {
		if (strcmp(fields[i].record, element) != 0) continue;
		used += put_field(descr + used, TS_NPY_DESCR - used - 2, &fields[i], used == 1);
	}
	memcpy(descr + used, "]", 2);
}
