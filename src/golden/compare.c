/* The first difference of two goldens, in the order of the pipeline, then of the elements. */
#include <inttypes.h>
#include <stdio.h>
#include "golden/golden.h"
#include "model/order.h"
#include "trace/emitted/emit.h"

static void add(char *text, size_t text_bytes, const char *format, ...) __attribute__((format(printf, 3, 4)));
static void add(char *text, size_t text_bytes, const char *format, ...)
{
	size_t used = strlen(text);
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(text + used, text_bytes - used, format, arguments);
	va_end(arguments);
}

/* Floats exactly, with their bits, also for NaNs. */
static void add_value(char *text, size_t text_bytes, const char *type, const char *at)
{
	u64 u = ts_order_read(at, ts_type_bytes(type));
	if (strcmp(type, "f32") == 0) {
		add(text, text_bytes, "%a (%08" PRIx64 ")", (double)ts_u2f((u32)u), u);
	} else if (strcmp(type, "i32") == 0) {
		add(text, text_bytes, "%" PRId32 " (0x%08" PRIx64 ")", (i32)(u32)u, u);
	} else {
		add(text, text_bytes, "%" PRIu64 " (0x%" PRIx64 ")", u, u);
	}
}

static void add_dims(char *text, size_t text_bytes, u32 n_dims, const u64 *dims)
{
	for (u32 i = 0; i < n_dims; i++) add(text, text_bytes, "%s%" PRIu64, i == 0 ? "[" : ", ", dims[i]);
	add(text, text_bytes, "]");
}

static void add_place(char *text, size_t text_bytes, const ts_npy *npy, u64 element)
{
	u64 place[TS_MAX_DIMS] = {0};
	for (u32 i = npy->n_dims; i-- > 0;) {
		place[i] = element % npy->shape[i];
		element /= npy->shape[i];
	}
	add(text, text_bytes, "element ");
	add_dims(text, text_bytes, npy->n_dims, place);
}

/* The field at byte `at` of an element: its type, and where its value begins. Adds its name if it has one. */
static const char *add_field(char *text, size_t text_bytes, ts_buffer_id id, size_t *at)
{
	const char *element = ts_buffer_table[id].element;
	size_t n, begin = 0;
	const ts_field_info *fields = ts_field_table(&n);
	for (size_t i = 0; i < n; i++) {
		if (strcmp(fields[i].record, element) != 0) continue;
		size_t size = ts_type_bytes(fields[i].type), bytes = fields[i].count * size;
		if (*at < begin + bytes) {
			size_t k = (*at - begin) / size;
			add(text, text_bytes, ", field %s", fields[i].name);
			if (fields[i].count > 1) add(text, text_bytes, "[%zu]", k);
			*at = begin + k * size;
			return fields[i].type;
		}
		begin += bytes;
	}
	*at = 0;
	return element;
}

void ts_golden_first(char *text, size_t text_bytes, ts_buffer_id id, const ts_golden_file *stored,
                     const ts_golden_file *computed)
{
	const ts_npy *s = &stored->npy, *c = &computed->npy;
	const char *a = stored->data + s->data_at, *b = computed->data + c->data_at;
	size_t bytes = ts_buffer_table[id].element_bytes;
	u64 element = 0;
	text[0] = 0;
	if (s->n_dims != c->n_dims || memcmp(s->shape, c->shape, s->n_dims * sizeof *s->shape) != 0) {
		add(text, text_bytes, "shape: golden ");
		add_dims(text, text_bytes, s->n_dims, s->shape);
		add(text, text_bytes, " here ");
		add_dims(text, text_bytes, c->n_dims, c->shape);
		return;
	}
	while (element < s->n && memcmp(a + element * bytes, b + element * bytes, bytes) == 0) element++;
	if (element == s->n) return;
	size_t at = 0;
	while (a[element * bytes + at] == b[element * bytes + at]) at++;
	add_place(text, text_bytes, s, element);
	const char *type = add_field(text, text_bytes, id, &at);
	add(text, text_bytes, ": golden ");
	add_value(text, text_bytes, type, a + element * bytes + at);
	add(text, text_bytes, " here ");
	add_value(text, text_bytes, type, b + element * bytes + at);
}

/* Compares one file; like ts_golden_compare. */
static ts_status compare(char *text, size_t text_bytes, ts_buffer_id id, const ts_golden *stored,
                         const ts_golden *computed)
{
	const char *s = stored->sums.hex[id], *c = computed->sums.hex[id];
	const ts_golden_file *kept = &stored->file[id], *now = &computed->file[id];
	size_t before = strlen(text);
	bool damaged = kept->data != NULL && strcmp(kept->hex, s) != 0;
	if (strcmp(s, c) == 0 && !damaged) return TS_OK;
	if (s[0] == 0 || c[0] == 0) {
		add(text, text_bytes, "%s", s[0] == 0 ? "not in SHA256SUMS" : "in SHA256SUMS, but not made here");
		return TS_DIFFERENT;
	}
	if (kept->data != NULL && now->data != NULL) ts_golden_first(text + before, text_bytes - before, id, kept, now);
	if (text[before] == 0 && strcmp(s, c) != 0) add(text, text_bytes, "SHA-256: golden %.16s... here %.16s...", s, c);
	if (damaged) add(text, text_bytes, "%ssmall/ does not hold what SHA256SUMS says", text[before] != 0 ? "; " : "");
	return TS_DIFFERENT;
}

ts_status ts_golden_compare(char *text, size_t text_bytes, const ts_golden *stored, const ts_golden *computed,
                            const ts_pipeline *pipeline, bool small)
{
	ts_buffer_id ids[TS_N_BUFFERS];
	ts_emit_order(ids, pipeline);
	for (u32 i = 0; i < TS_N_BUFFERS; i++) {
		char name[TS_EMIT_NAME];
		ts_buffer_id id = ids[i];
		ts_emit_name(name, pipeline, id);
		snprintf(text, text_bytes, "%s: ", name);
		ts_status status = compare(text, text_bytes, id, stored, computed);
		if (status != TS_OK) return status;
		bool must = small && ts_golden_is_small(computed, id);
		if (must && stored->file[id].data == NULL) return ts_fail("small/%s: there is no such file", name);
	}
	text[0] = 0;
	return TS_OK;
}

ts_buffer_id ts_golden_named(const char *text, const ts_pipeline *pipeline)
{
	char name[TS_EMIT_NAME];
	u32 id = 0;
	for (; id < TS_N_BUFFERS; id++) {
		ts_emit_name(name, pipeline, (ts_buffer_id)id);
		if (strncmp(text, name, strlen(name)) == 0 && text[strlen(name)] == ':') break;
	}
	return (ts_buffer_id)id;
}
