/* Text from files, on its way out as JSON: names may hold any bytes, JSON holds UTF-8 only. */
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
