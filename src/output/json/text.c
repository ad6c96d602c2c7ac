/* Text from files, on its way out as JSON: names may hold any bytes, JSON holds UTF-8 only. And JSON, on its way out as
 * text. */
#include "output/json/text.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "model/core.h"

enum { ESCAPE_BYTES = 4 };

json_t *ts_text_json(const char *text)
{
	json_t *string = json_string(text);
	char *escaped = string == NULL ? ts_alloc(strlen(text) + 1, ESCAPE_BYTES, "a text") : NULL;
	if (escaped == NULL) {
		return string;
	}
	char *to = escaped;
	for (const unsigned char *c = (const unsigned char *)text; *c != 0; c++) {
		to += snprintf(to, ESCAPE_BYTES + 1, *c > 127 ? "\\x%02x" : "%c", (unsigned)*c);
	}
	*to = 0;
	string = json_string(escaped);
	free(escaped);
	return string;
}

json_t *ts_json_made(json_t *made, int failed)
{
	if (failed == 0) return made;
	json_decref(made);
	return NULL;
}

typedef struct {
	void *bytes;
	size_t n, capacity;
	const char *what;
	bool cut;
} buffer;

static int add(const char *bytes, size_t n, void *user)
{
	buffer *b = user;
	b->cut |= ts_grow(&b->bytes, &b->capacity, b->n + n + 1, 1, b->what) != TS_OK;
	if (b->cut) return -1;
	memcpy((char *)b->bytes + b->n, bytes, n);
	b->n += n;
	((char *)b->bytes)[b->n] = 0;
	return 0;
}

/* Jansson does not ask how the name of a member was written. */
char *ts_json_text(const json_t *value, size_t flags, const char *what)
{
	buffer b = {.what = what};
	if (json_dump_callback(value, add, &b, flags) == 0 && !b.cut) return b.bytes;
	free(b.bytes);
	ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", what);
	return NULL;
}
